// Drags of control points of the cage: free-form deformation in its first form.
// Source: T. W. Sederberg, S. R. Parry. Free-Form Deformation of Solid Geometric Models. SIGGRAPH
// 1986; here with the uniform cubic B-splines of J. Gain, N. Dodgson. Adaptive Refinement and
// Decimation under Free-Form Deformation. Eurographics UK 1999.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/decimal.h"
#include "session/session_state.h"

namespace pectin {
namespace {

constexpr double kLargestMove = 1e6;  // in diagonals of object and cage, as for a drag
// A cage counts as symmetric if it is at most this many cells away from its mirror image.
constexpr double kSameCage = 1e-9;

std::string written(const IVec3& index) {
    return "[" + std::to_string(index.x) + ", " + std::to_string(index.y) + ", " +
           std::to_string(index.z) + "]";
}

bool is_in(const IVec3& index, const Lattice& cage) {
    return glm::all(glm::greaterThanEqual(index, cage.first_index())) &&
           glm::all(glm::lessThanEqual(index, cage.last_index()));
}

bool is_symmetric(const Lattice& cage, const MirrorPlane& plane) {
    const double distance =
        glm::length((mirror_image(plane, cage).origin - cage.origin) / cage.cell);
    return distance <= kSameCage;
}

Refusal needs_points() { return {"control needs at least one control point to move", "points"}; }

Refusal refuse_index(const IVec3& index, const Lattice& cage) {
    return Refusal{"the cage has no control point " + written(index) + "; its last is " +
                       written(cage.last_index()) + ", the first " + written(cage.first_index()),
                   "points"};
}

Refusal refuse_difference(const IVec3& index, const Vec3& a, const Vec3& b) {
    return Refusal{"control point " + written(index) + " is asked to move by " + decimal(a) +
                       " and by " + decimal(b) + "; name each once, with symmetry its image, too",
                   "points"};
}

// Collects the displacements of control points and refuses two different ones for the same point.
class Collector {
  public:
    explicit Collector(const Lattice& cage)
        : cage_(cage), all_(cage.control_count(), Vec3{0.0}), is_given_(all_.size(), false) {}

    Done add(const IVec3& index, const Vec3& d) {
        const std::size_t at = cage_.control_index(cage_.control_of_user_index(index));
        if (is_given_[at] && all_[at] != d) return refuse_difference(index, all_[at], d);
        all_[at] = d;
        is_given_[at] = true;
        return {};
    }
    std::vector<Vec3> take() { return std::move(all_); }

  private:
    const Lattice& cage_;
    std::vector<Vec3> all_;
    std::vector<bool> is_given_;
};

}  // namespace

Result<std::vector<Vec3>> Session::State::control_displacements(
    const command::Control& control) const {
    if (!lattice_settings.cage) {
        return Refusal{"only a cage has control points to move; use the cage command first"};
    }
    const Lattice& cage = *lattice_settings.cage;
    if (const Done done = check_lattice(cage); !done) return done.refusal();
    if (symmetry && !is_symmetric(cage, *symmetry)) {
        return Refusal{
            "the cage is not its own mirror image about the symmetry plane; move it so that the "
            "plane goes through its middle, or switch symmetry off"};
    }
    const double most = kLargestMove * (diagonal + cage.influenced_zone().diagonal());
    Collector collector(cage);
    for (const auto& [index, to] : control.points) {
        if (!is_in(index, cage)) return refuse_index(index, cage);
        const Vec3 d = to - cage.rest(cage.control_of_user_index(index));
        if (!(glm::length(d) <= most)) {
            return Refusal{"control point " + written(index) + " is asked to move to " +
                               decimal(to) +
                               ", more than a million times the size of the object; the most is " +
                               decimal(most),
                           "points"};
        }
        if (const Done done = collector.add(index, d); !done) return done.refusal();
        if (!symmetry) continue;
        IVec3 opposite = index;
        opposite[symmetry->axis] = cage.counts()[symmetry->axis] - 1 - index[symmetry->axis];
        if (opposite == index &&
            std::abs(d[symmetry->axis]) > kSameCage * cage.cell[symmetry->axis]) {
            return Refusal{
                "control point " + written(index) +
                    " is on the symmetry plane and can only move within it, for instance to " +
                    decimal(symmetry->onto(to)) + "; or switch symmetry off",
                "points"};
        }
        if (opposite == index) continue;
        const Done done = collector.add(opposite, symmetry->image_of_vector(d));
        if (!done) return done.refusal();
    }
    return collector.take();
}

Done Session::State::begin_control(std::span<const IVec3> indices) {
    assert(!active_gesture);
    if (!has_object()) return no_object();
    if (indices.empty()) return needs_points();
    command::Control control;
    for (const IVec3& index : indices) {
        const auto& cage = lattice_settings.cage;
        const Vec3 to = cage ? cage->rest(cage->control_of_user_index(index)) : Vec3{0.0};
        control.points.push_back({index, to});
    }
    auto displacements = control_displacements(control);
    if (!displacements) return displacements.refusal();
    Stopwatch stopwatch;
    auto begun = std::make_unique<ActiveGesture>();
    begun->control = std::move(control);
    Warp warp{{LatticeField{*lattice_settings.cage, std::move(*displacements)}}};
    Box zone = warp.zone();
    if (symmetry) zone.include(symmetry->image(zone));  // they differ by rounding at most
    start_gesture(*begun, {.moving = face_tree().faces_meeting(with_error_margin(zone), *mesh)},
                  std::move(warp));
    begun->measured.seconds.begin = stopwatch.lap();
    active_gesture = std::move(begun);
    return {};
}

Done Session::State::control_to(std::span<const Vec3> targets) {
    assert(active_gesture && active_gesture->is_control() &&
           targets.size() == active_gesture->control.points.size());
    command::Control control = active_gesture->control;
    for (std::size_t i = 0; i < targets.size(); ++i) control.points[i].to = targets[i];
    auto displacements = control_displacements(control);
    if (!displacements) return displacements.refusal();
    active_gesture->control = std::move(control);
    update_frame(*displacements);
    return {};
}

std::optional<command::Control> Session::State::end_control() {
    assert(active_gesture && active_gesture->is_control());
    std::optional<command::Control> control = active_gesture->control;  // see end_drag()
    const std::vector<Vec3> displacements = *control_displacements(*control);
    const bool is_noop = std::all_of(displacements.begin(), displacements.end(),
                                     [](const Vec3& d) { return d == Vec3{0.0}; });
    commit(displacements, is_noop);
    if (is_noop) control.reset();
    return control;
}

Done Session::State::run(const command::Control& control) {
    if (has_object()) {
        const auto displacements = control_displacements(control);
        if (!displacements) return displacements.refusal();
    }
    std::vector<IVec3> indices;
    for (const auto& point : control.points) indices.push_back(point.index);
    if (Done done = begin_control(indices); !done) return done;
    active_gesture->control = control;
    try {
        end_control();
    } catch (...) {
        if (active_gesture) cancel_drag();
        throw;
    }
    return {};
}

}  // namespace pectin
