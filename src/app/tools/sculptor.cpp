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

// A drag that is shorter than this share of the distance from the eye, about a pixel, has no
// direction yet.
constexpr double kShortestDrag = 1e-3;

// The least distance of a dragged point from the plane of symmetry, in cells of the lattice. On the
// plane it would coincide with its image.
constexpr double kMinOffset = 0.05;

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

std::optional<Vec3> on_plane_across(const Camera& camera, const Vec3& from, int axis,
                                    const Ray& first, const Ray& ray) {
    const double first_slope = first.direction[axis];
    if (first_slope * first_slope < kMinSquaredSine) {
        std::optional<Vec3> nearest = on_view_plane(camera, from, ray);
        if (nearest) (*nearest)[axis] = from[axis];
        return nearest;
    }
    const double slope = ray.direction[axis];
    const double distance = (from[axis] - ray.origin[axis]) / slope;
    // Beyond the horizon of the plane the ray does not meet it.
    if (!(slope * first_slope > 0.0) || !(slope * slope > 0.01 * kMinSquaredSine)) return {};
    if (!(distance > 0.0)) return {};
    Vec3 meeting = ray.at(distance);
    meeting[axis] = from[axis];
    return meeting;
}

std::optional<Vec3> on_constraint(const DragConstraint& constraint, const Camera& camera,
                                  const Vec3& from, const Ray& first, const Ray& ray) {
    const int axis = *constraint.axis();
    if (constraint.is_plane()) return on_plane_across(camera, from, axis, first, ray);
    Vec3 along{0.0};
    along[axis] = 1.0;
    return on_normal(camera, from, along, first, ray);
}

Vec3 on_own_side(const MirrorPlane& plane, double cell, const Vec3& from, const Vec3& to) {
    const double offset = plane.offset(from);
    if (std::abs(offset) <= kOnPlaneFraction * cell) return plane.onto(to);
    const double least = std::min(std::abs(offset), kMinOffset * cell);
    const double side = offset < 0.0 ? -1.0 : 1.0;
    Vec3 allowed = to;
    if (side * plane.offset(to) < least) allowed[plane.axis] = plane.at + side * least;
    return allowed;
}

Done Sculptor::grab(Session& session, const Pick& pick, const Ray& ray, std::span<const Vec3> pins,
                    const DragOptions& options) {
    assert(!is_dragging());
    if (Done done = session.begin_drag(std::array{pick.point}, pins, options); !done) return done;
    grabbed_ = Grabbed{pick, ray, {pick.point}, {pick.point}, {pins.begin(), pins.end()}, options};
    return {};
}

std::optional<Vec3> Sculptor::under_cursor(const Camera& camera, const Ray& ray,
                                           DragPath path) const {
    const auto& [pick, first, requested, applied, pins, options] = *grabbed_;
    if (constraint_.axis()) return on_constraint(constraint_, camera, pick.point, first, ray);
    if (path == DragPath::normal) return on_normal(camera, pick.point, pick.normal, first, ray);
    return on_view_plane(camera, pick.point, ray);
}

Result<bool> Sculptor::drag(Session& session, const Camera& camera, const Ray& ray, DragPath path,
                            double strength) {
    assert(is_dragging());
    const Pick& pick = grabbed_->pick;
    std::optional<Vec3> to = under_cursor(camera, ray, path);
    if (to && strength != 1.0) to = pick.point + strength * (*to - pick.point);
    if (constraint_.is_typing()) {
        const Vec3 cursor = to ? *to - pick.point : Vec3{0.0};
        const double shortest = kShortestDrag * glm::distance(camera.eye, pick.point);
        to = pick.point + constraint_.displacement(cursor, shortest * pick.normal);
    }
    if (to && session.symmetry()) {
        const MirrorPlane& plane = *session.symmetry();
        to = on_own_side(plane, session.lattice_in_use()->cell[plane.axis], pick.point, *to);
    }
    if (to) grabbed_->requested.to = *to;
    if (grabbed_->requested == grabbed_->applied) return false;
    if (Done done = session.drag_to(std::array{move_to(grabbed_->requested)}); !done) {
        grabbed_->requested = grabbed_->applied;
        return done.refusal();
    }
    grabbed_->applied = grabbed_->requested;
    return true;
}

bool Sculptor::press_key(Session& session, Key key, bool shift) {
    if (!constraint_.press(key, shift)) return false;
    straighten(session);
    return true;
}

bool Sculptor::type(Session& session, unsigned int character) {
    if (!constraint_.type(character)) return false;
    straighten(session);
    return true;
}

// Takes back the way that the drag has gone so far. If it cannot begin again, which it could
// before, it ends.
void Sculptor::straighten(Session& session) {
    if (session.active_drag().via.empty()) return;
    session.cancel_drag();
    const Pick& pick = grabbed_->pick;
    if (session.begin_drag(std::array{pick.point}, grabbed_->pins, grabbed_->options)) {
        grabbed_->applied = {pick.point};
    } else {
        end();
    }
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
