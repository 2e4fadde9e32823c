#include "app/cage_points.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "app/sculptor.h"
#include "render/overlay.h"

namespace pectin {
namespace {

constexpr double kReach = 9.0;    // of a control point, in pixels
constexpr double kTremble = 3.0;  // a press that moves less is a click

template <class Visit>
void for_each_control(const Lattice& cage, const Visit& visit) {
    for (int k = 0; k < cage.deformable.z; ++k) {
        for (int j = 0; j < cage.deformable.y; ++j) {
            for (int i = 0; i < cage.deformable.x; ++i) visit(IVec3{i, j, k});
        }
    }
}

const Lattice& cage_of(const Session& session) { return *session.lattice_settings().cage; }

IVec3 opposite(const Lattice& cage, int axis, IVec3 index) {
    index[axis] = cage.deformable[axis] - 1 - index[axis];
    return index;
}

// A control point on the plane of symmetry stays on it.
Vec3 allowed(const Session& session, const IVec3& index, Vec3 d) {
    const auto& plane = session.symmetry();
    if (plane && opposite(cage_of(session), plane->axis, index) == index) d[plane->axis] = 0.0;
    return d;
}

}  // namespace

std::optional<IVec3> CagePoints::under(const Session& session, const View& view, const Vec2& at,
                                       const std::optional<Pick>& surface) const {
    if (!session.lattice_settings().cage) return std::nullopt;
    const Lattice& cage = cage_of(session);
    const double limit =
        surface ? view.depth(surface->point) + kReach * view.pixel_length(surface->point)
                : std::numeric_limits<double>::infinity();
    std::optional<IVec3> found;
    double nearest = kReach;
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
    const std::optional<IVec3> index = under(session, view, at, surface);
    if (!index) return false;
    const bool was_selected = is_selected(*index);
    if (modifiers.shift) {
        toggle(*index);
        if (was_selected) return true;
    } else if (!was_selected) {
        selected_ = {*index};
    }
    held_ = Held{.index = *index,
                 .pressed_at = at,
                 .at = at,
                 .was_selected = was_selected && !modifiers.shift};
    return true;
}

void CagePoints::move_to(const Vec2& at) {
    if (held_) held_->at = at;
    if (box_) box_->to = at;
}

std::optional<std::string> CagePoints::update_drag(Session& session, const View& view) {
    if (!held_) return std::nullopt;
    if (!held_->has_begun) {
        if (glm::distance(held_->at, held_->pressed_at) < kTremble) return std::nullopt;
        held_->moving = moving_with(session, held_->index);
        std::vector<IVec3> indices;
        for (const IVec3& control : held_->moving) {
            indices.push_back(cage_of(session).user_index(control));
        }
        if (auto refusal = session.begin_control(indices)) {
            held_.reset();
            return refusal;
        }
        held_->has_begun = true;
    }
    const std::optional<Vec3> by = motion(session, view);
    if (!by || *by == held_->by) return std::nullopt;
    std::vector<Vec3> targets;
    for (const IVec3& index : held_->moving) {
        targets.push_back(cage_of(session).rest(index) + allowed(session, index, *by));
    }
    if (auto refusal = session.control_to(targets)) return refusal;
    held_->by = *by;
    return std::nullopt;
}

// How far the cursor has gone at the depth of the grabbed one, which all keep their distance to.
std::optional<Vec3> CagePoints::motion(const Session& session, const View& view) const {
    const Vec3 rest = cage_of(session).rest(held_->index);
    const auto from = on_view_plane(view.camera, rest, view.ray_through(held_->pressed_at));
    const auto to = on_view_plane(view.camera, rest, view.ray_through(held_->at));
    if (!from || !to) return std::nullopt;
    return allowed(session, held_->index, *to - *from);
}

// With symmetry on those of the grabbed one's side, in place of their images.
std::vector<IVec3> CagePoints::moving_with(const Session& session, const IVec3& grabbed) const {
    if (!session.symmetry()) return selected_;
    const Lattice& cage = cage_of(session);
    const int axis = session.symmetry()->axis;
    const auto is_low = [&](const IVec3& index) {
        return index[axis] <= opposite(cage, axis, index)[axis];
    };
    std::vector<IVec3> moving;
    for (IVec3 index : selected_) {
        if (is_low(index) != is_low(grabbed)) index = opposite(cage, axis, index);
        if (std::find(moving.begin(), moving.end(), index) == moving.end()) moving.push_back(index);
    }
    return moving;
}

std::vector<Vec3> CagePoints::displacements(const Session& session) const {
    const Lattice& cage = cage_of(session);
    std::vector<Vec3> all(cage.control_count(), Vec3{0.0});
    const auto& plane = session.symmetry();
    for (const IVec3& index : held_->moving) {
        const Vec3 d = allowed(session, index, held_->by);
        if (plane) {
            const IVec3 image = opposite(cage, plane->axis, index);
            all[cage.control_index(image)] = plane->image_of_vector(d);
        }
        all[cage.control_index(index)] = d;
    }
    return all;
}

std::optional<command::Control> CagePoints::release(Session& session, const View& view) {
    if (box_) {
        select_in_box(session, view);
        box_.reset();
        return std::nullopt;
    }
    if (!is_dragging()) {
        if (held_ && held_->was_selected) selected_ = {held_->index};
        held_.reset();
        return std::nullopt;
    }
    try {
        auto done = session.end_control();
        held_.reset();
        return done;
    } catch (...) {
        // A drag that goes on is still to be cancelled.
        if (!session.is_dragging()) held_.reset();
        throw;
    }
}

void CagePoints::cancel(Session& session) {
    if (is_dragging()) session.cancel_drag();
    held_.reset();
    box_.reset();
}

void CagePoints::forget_others(const std::optional<Lattice>& cage) {
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
