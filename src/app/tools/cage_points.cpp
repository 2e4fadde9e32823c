#include "app/tools/cage_points.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "app/tools/sculptor.h"
#include "render/overlay.h"

namespace pectin {
namespace {

constexpr double kPickRadius = 9.0;      // of a control point, in pixels
constexpr double kClickTolerance = 3.0;  // a press that moves by fewer pixels is a click

template <class Visit>
void for_each_control(const Lattice& cage, const Visit& visit) {
    for (int k = 0; k < cage.deformable.z; ++k) {
        for (int j = 0; j < cage.deformable.y; ++j) {
            for (int i = 0; i < cage.deformable.x; ++i) visit(IVec3{i, j, k});
        }
    }
}

const Lattice& cage_of(const Session& session) { return *session.lattice_settings().cage; }

// The index on the other side of the plane of symmetry across this axis.
IVec3 mirrored(const Lattice& cage, int axis, IVec3 index) {
    index[axis] = cage.deformable[axis] - 1 - index[axis];
    return index;
}

// Returns d, without its component across the plane of symmetry if the control point lies on that
// plane.
Vec3 kept_on_symmetry_plane(const Session& session, const IVec3& index, Vec3 d) {
    const auto& plane = session.symmetry();
    if (plane && mirrored(cage_of(session), plane->axis, index) == index) d[plane->axis] = 0.0;
    return d;
}

}  // namespace

std::optional<IVec3> CagePoints::find_at(const Session& session, const View& view, const Vec2& at,
                                         const std::optional<Pick>& surface) const {
    if (!session.lattice_settings().cage) return {};
    const Lattice& cage = cage_of(session);
    const double limit =
        surface ? view.depth(surface->point) + kPickRadius * view.pixel_length(surface->point)
                : std::numeric_limits<double>::infinity();
    std::optional<IVec3> found;
    double nearest = kPickRadius;
    for_each_control(cage, [&](const IVec3& index) {
        if (!draws_control(cage, index)) return;
        const Vec3 position = cage.rest(index);
        const std::optional<Vec2> seen = view.project(position);
        if (!seen || view.depth(position) > limit) return;
        const double distance = glm::distance(*seen, at);
        if (distance > nearest) return;
        nearest = distance;
        found = index;
    });
    return found;
}

bool CagePoints::press(const Session& session, const View& view, const Vec2& at,
                       const Modifiers& modifiers, const std::optional<Pick>& surface) {
    assert(!is_active());
    if (modifiers.control) {
        box_ = ScreenBox{at, at};
        box_adds_ = modifiers.shift;
        return true;
    }
    const std::optional<IVec3> index = find_at(session, view, at, surface);
    if (!index) return false;
    const bool was_selected = is_selected(*index);
    if (modifiers.shift) {
        toggle(*index);
        if (was_selected) return true;
    } else if (!was_selected) {
        selected_ = {*index};
    }
    grabbed_ = Grabbed{.index = *index,
                       .pressed_at = at,
                       .at = at,
                       .was_selected = was_selected && !modifiers.shift};
    return true;
}

void CagePoints::move_to(const Vec2& at) {
    if (grabbed_) grabbed_->at = at;
    if (box_) box_->to = at;
}

Done CagePoints::begin_drag(Session& session) {
    grabbed_->moving = points_to_move(session, grabbed_->index);
    std::vector<IVec3> indices;
    for (const IVec3& control : grabbed_->moving) {
        indices.push_back(cage_of(session).user_index(control));
    }
    if (Done done = session.begin_control(indices); !done) {
        grabbed_.reset();
        return done;
    }
    grabbed_->has_begun = true;
    return {};
}

Done CagePoints::update_drag(Session& session, const View& view) {
    if (!grabbed_) return {};
    if (!grabbed_->has_begun) {
        const double moved_by = glm::distance(grabbed_->at, grabbed_->pressed_at);
        if (moved_by < kClickTolerance && !constraint_.is_active()) return {};
        if (Done done = begin_drag(session); !done) return done;
    }
    const std::optional<Vec3> displacement = wanted_displacement(session, view);
    if (!displacement || *displacement == grabbed_->displacement) return {};
    std::vector<Vec3> targets;
    for (const IVec3& index : grabbed_->moving) {
        targets.push_back(cage_of(session).rest(index) +
                          kept_on_symmetry_plane(session, index, *displacement));
    }
    if (Done done = session.control_to(targets); !done) return done;
    grabbed_->displacement = *displacement;
    return {};
}

// How far the cursor has moved since the press: on the axis or plane of the constraint, or else in
// the plane parallel to the picture, through the grabbed point.
std::optional<Vec3> CagePoints::cursor_displacement(const View& view, const Vec3& rest) const {
    const Ray first = view.ray_through(grabbed_->pressed_at);
    const auto follow = [&](const Ray& ray) {
        return constraint_.axis() ? on_constraint(constraint_, view.camera, rest, first, ray)
                                  : on_view_plane(view.camera, rest, ray);
    };
    const auto from = follow(first), to = follow(view.ray_through(grabbed_->at));
    return from && to ? std::optional(*to - *from) : std::nullopt;
}

// All selected points are displaced by this vector. Without a movement, a typed distance goes
// upwards in the picture.
std::optional<Vec3> CagePoints::wanted_displacement(const Session& session, const View& view) {
    const Vec3 rest = cage_of(session).rest(grabbed_->index);
    const auto cursor = cursor_displacement(view, rest);
    if (!cursor) return {};
    const Vec3 start = view.pixel_length(rest) * view.camera.true_up();
    return kept_on_symmetry_plane(session, grabbed_->index,
                                  constraint_.displacement(*cursor, start));
}

// Returns the selected points. With symmetry, points on the other side than the grabbed one are
// replaced by their images, since the session moves both sides.
std::vector<IVec3> CagePoints::points_to_move(const Session& session, const IVec3& grabbed) const {
    if (!session.symmetry()) return selected_;
    const Lattice& cage = cage_of(session);
    const int axis = session.symmetry()->axis;
    const auto is_low = [&](const IVec3& index) {
        return index[axis] <= mirrored(cage, axis, index)[axis];
    };
    std::vector<IVec3> moving;
    for (IVec3 index : selected_) {
        if (is_low(index) != is_low(grabbed)) index = mirrored(cage, axis, index);
        if (std::find(moving.begin(), moving.end(), index) == moving.end()) moving.push_back(index);
    }
    return moving;
}

std::vector<Vec3> CagePoints::displacements(const Session& session) const {
    const Lattice& cage = cage_of(session);
    std::vector<Vec3> all(cage.control_count(), Vec3{0.0});
    const auto& plane = session.symmetry();
    for (const IVec3& index : grabbed_->moving) {
        const Vec3 d = kept_on_symmetry_plane(session, index, grabbed_->displacement);
        if (plane) {
            const IVec3 image = mirrored(cage, plane->axis, index);
            all[cage.control_index(image)] = plane->image_of_vector(d);
        }
        all[cage.control_index(index)] = d;
    }
    return all;
}

Vec3 CagePoints::grabbed_position(const Session& session) const {
    return cage_of(session).rest(grabbed_->index) + grabbed_->displacement;
}

void CagePoints::release(const Session& session, const View& view) {
    assert(!is_dragging());
    if (box_) {
        select_in_box(session, view);
        box_.reset();
    } else {
        if (grabbed_ && grabbed_->was_selected) selected_ = {grabbed_->index};
        end();
    }
}

void CagePoints::reset_for(const std::optional<Lattice>& cage) {
    const IVec3 counts = cage ? cage->deformable : IVec3{0};
    if (counts == counts_) return;
    counts_ = counts;
    selected_.clear();
    hovered_.reset();
}

bool CagePoints::is_selected(const IVec3& index) const {
    return std::find(selected_.begin(), selected_.end(), index) != selected_.end();
}

void CagePoints::toggle(const IVec3& index) {
    if (std::erase(selected_, index) == 0) selected_.push_back(index);
}

void CagePoints::select_in_box(const Session& session, const View& view) {
    if (!box_adds_) selected_.clear();
    const Vec2 low = glm::min(box_->from, box_->to), high = glm::max(box_->from, box_->to);
    const Lattice& cage = cage_of(session);
    for_each_control(cage, [&](const IVec3& index) {
        const std::optional<Vec2> seen = view.project(cage.rest(index));
        if (!seen || is_selected(index)) return;
        const bool is_inside = glm::all(glm::greaterThanEqual(*seen, low)) &&
                               glm::all(glm::lessThanEqual(*seen, high));
        if (is_inside) selected_.push_back(index);
    });
}

}  // namespace pectin
