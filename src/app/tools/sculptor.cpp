#include "app/tools/sculptor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace pectin {
namespace {

// If sin² of the angle between ray and normal is smaller (about 12 degrees), the nearest point of
// the normal moves too far for a small motion of the cursor.
constexpr double kMinSquaredSine = 0.04;
// A ray meets the view plane only if the cosine of its angle to the view direction is larger.
constexpr double kMinCosine = 1e-6;

// The least distance of a dragged point from the plane of symmetry, in cells of the lattice. On the
// plane it would coincide with its image.
constexpr double kMinOffset = 0.05;

// Returns `to`, moved so that a point on the plane of symmetry stays on it, and any other point
// stays on its side.
Vec3 on_own_side(const Session& session, const Vec3& from, const Vec3& to) {
    const MirrorPlane& plane = *session.symmetry();
    const double cell = session.lattice_in_use()->cell[plane.axis];
    const double offset = plane.offset(from);
    if (std::abs(offset) <= kOnPlaneFraction * cell) return plane.onto(to);
    const double least = std::min(std::abs(offset), kMinOffset * cell);
    const double side = offset < 0.0 ? -1.0 : 1.0;
    Vec3 allowed = to;
    if (side * plane.offset(to) < least) allowed[plane.axis] = plane.at + side * least;
    return allowed;
}

}  // namespace

std::optional<Vec3> on_view_plane(const Camera& camera, const Vec3& from, const Ray& ray) {
    const Vec3 forward = camera.forward();
    const double slope = glm::dot(ray.direction, forward);
    if (!(slope > kMinCosine)) return {};
    return ray.at(glm::dot(from - ray.origin, forward) / slope);
}

Vec3 on_normal(const Camera& camera, const Vec3& from, const Vec3& normal, const Ray& first,
               const Ray& ray) {
    // The ray that grabbed the point decides, so that the rule does not change during a drag.
    const double towards = glm::dot(normal, first.direction);
    if (1.0 - towards * towards < kMinSquaredSine) {
        const std::optional<Vec3> now = on_view_plane(camera, from, ray);
        const double up = now ? glm::dot(*now - from, camera.true_up()) : 0.0;
        return from + up * normal;
    }
    const double cosine = glm::dot(normal, ray.direction), square = 1.0 - cosine * cosine;
    if (square < 0.25 * kMinSquaredSine) return from;
    const Vec3 to_ray = ray.origin - from;
    const double along =
        (glm::dot(to_ray, normal) - cosine * glm::dot(to_ray, ray.direction)) / square;
    return from + along * normal;
}

Done Sculptor::grab(Session& session, const Pick& pick, const Ray& ray, std::span<const Vec3> pins,
                    const DragOptions& options) {
    assert(!is_dragging());
    if (Done done = session.begin_drag(std::array{pick.point}, pins, options); !done) return done;
    grabbed_ = Grabbed{pick, ray, {pick.point}, {pick.point}};
    return {};
}

Result<bool> Sculptor::drag(Session& session, const Camera& camera, const Ray& ray, DragPath path) {
    assert(is_dragging());
    const Pick& pick = grabbed_->pick;
    std::optional<Vec3> to = path == DragPath::normal
                                 ? on_normal(camera, pick.point, pick.normal, grabbed_->ray, ray)
                                 : on_view_plane(camera, pick.point, ray);
    if (to && session.symmetry()) to = on_own_side(session, pick.point, *to);
    if (to) grabbed_->requested.to = *to;
    if (grabbed_->requested == grabbed_->applied) return false;
    if (Done done = session.drag_to(std::array{move_to(grabbed_->requested)}); !done) {
        grabbed_->requested = grabbed_->applied;
        return done.refusal();
    }
    grabbed_->applied = grabbed_->requested;
    return true;
}

Move Sculptor::move_to(const Goal& goal) const {
    Move move{.from = grabbed_->pick.point,
              .to = goal.to,
              .scale = std::pow(kScalePerStep, goal.scale_steps)};
    if (goal.degrees != 0.0) move.twist = {grabbed_->pick.normal, goal.degrees};
    return move;
}

double Sculptor::scale() const { return move_to(grabbed_->applied).scale; }

}  // namespace pectin
