#include "ffd/interpolation_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pectin {
namespace {

// What rounding may take from a bound, as a fraction of it.
constexpr double kRoundedUp = 1.0 + 1e-9;
// The rounding of weights to float, as a fraction of the reach; that of sums in double and of
// coordinates, as a fraction of the reach and of the largest coordinate.
constexpr double kWeightRounding = std::numeric_limits<float>::epsilon();
constexpr double kRounding = 64.0 * std::numeric_limits<double>::epsilon();
// The error of a Jacobian whose gradients are floats, as a fraction of |J| + 1.
constexpr double kJacobianRounding = 8.0 * std::numeric_limits<float>::epsilon();

// The least squared area, as a fraction of the square of the longest side's square, with which the
// circumscribed circle is exact to 1e-8 of its radius.
constexpr double kNeedle = 1e-16;

// How far displacements along a direction may be beside it, as a fraction of the reach.
constexpr double kBesideDirection = 1e-12;

constexpr double kRadiusRoundedUp = 1.0 + 1e-7;
constexpr double kRoughlyRoundedUp = 1.0 + 1e-6;
constexpr double kUnknown = std::numeric_limits<double>::infinity();
// Where a triangle may be farther from its image than this, nothing is said about it.
constexpr double kMostMargin = 1e100;

// A bound that has overflowed or is not a number says nothing.
double known_or_infinite(double bound) { return bound < kMostMargin ? bound : kUnknown; }

double largest_coordinate(const InterpolationError::Corners& corners) {
    double largest = 0.0;
    for (const Vec3& corner : corners) {
        const Vec3 size = glm::abs(corner);
        largest = std::max({largest, size.x, size.y, size.z});
    }
    return largest;
}

// Two orthonormal vectors of the plane of a triangle; any two if it has none.
std::array<Vec3, 2> plane_of(const InterpolationError::Corners& corners) {
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0],
               bc = corners[2] - corners[1];
    Vec3 p = ab;
    for (const Vec3& side : {ac, bc}) {
        if (glm::dot(side, side) > glm::dot(p, p)) p = side;
    }
    p = unit_or_zero(p);
    const Vec3 other = p == unit_or_zero(ab) ? ac : ab;
    Vec3 q = unit_or_zero(other - glm::dot(other, p) * p);
    q -= glm::dot(q, p) * p;
    if (glm::dot(q, q) > 0.25) return {p, unit_or_zero(q)};
    // Of a triangle without area, q was what rounding had left. Its line lies in many planes.
    const Vec3 size = glm::abs(p);
    Vec3 axis{0.0};
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
    return {p, unit_or_zero(axis - glm::dot(axis, p) * p)};
}

}  // namespace

// Of an obtuse triangle it is the circle about its longest side, otherwise the circumscribed one.
EnclosingCircle enclosing_circle(const std::array<Vec3, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
        if (glm::dot(b - a, c - a) > 0.0) continue;
        return {0.5 * b + 0.5 * c, 0.25 * glm::dot(c - b, c - b)};
    }
    const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec3 normal = glm::cross(u, v);
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), area = glm::dot(normal, normal);
    // Of a needle, rounding may have hidden that it is obtuse.
    const double longest = std::max({uu, vv, glm::dot(v - u, v - u)});
    if (!(area > kNeedle * longest * longest)) return {corners[0], longest};
    const Vec3 to_centre = glm::cross(uu * v - vv * u, normal) / (2.0 * area);
    return {corners[0] + to_centre, glm::dot(to_centre, to_centre)};
}

InterpolationError::Triangle::Triangle(const Corners& corners) : plane(plane_of(corners)) {
    const EnclosingCircle circle = enclosing_circle(corners);
    centre = circle.centre;
    radius = std::sqrt(circle.squared_radius) * kRadiusRoundedUp;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 side = corners[(i + 1) % 3] - corners[i];
        sides[i] = {glm::dot(side, plane[0]), glm::dot(side, plane[1])};
    }
}

double InterpolationError::Triangle::bulge(const PlaneBend& bend) const {
    return 0.5 * std::min(radius * radius * bend.most, squared_enclosing_radius(bend.form, sides));
}

InterpolationError::InterpolationError(const Warp& warp) : warp_(warp) {
    for (const Deformation& step : warp.steps) steps_.push_back(bounded(step));
    if (warp.steps.empty()) return;
    const std::span<const Vec3> d = displacements_of(warp.steps.back());
    known_.assign(d.begin(), d.end());
    if (warp.steps.size() > 1 || weight_count(warp.steps.back()) != 1) return;
    Deformation unit = warp.steps.back();
    displacements_of(unit).front() = Vec3{1.0, 0.0, 0.0};
    unit_step_.emplace(merged_lattices(unit));
    unit_step_->tabulate();
}

InterpolationError::Step InterpolationError::bounded(const Deformation& step) {
    Step result{DerivativeBounds(merged_lattices(step)), zones_of(step)};
    const double reach = reach_bound(step);
    // A deformation without weights computes in double.
    const bool has_weights = weight_count(step) > 0;
    result.rounding =
        has_weights ? (kWeightRounding + kRounding) * reach : kRounding * result.bounds.reach();
    return result;
}

void InterpolationError::update() {
    if (steps_.empty()) return;
    const std::span<const Vec3> d = displacements_of(warp_.steps.back());
    if (std::ranges::equal(d, known_)) return;
    steps_.back() = bounded(warp_.steps.back());
    known_.assign(d.begin(), d.end());
}

double InterpolationError::rounding_of(std::size_t step, const Corners& corners) const {
    return steps_[step].rounding + kRounding * largest_coordinate(corners);
}

bool InterpolationError::moves(const Step& step, const DerivativeBounds::Region& region) const {
    const auto& [a, b, c] = region.corners;
    const Vec3 low = glm::min(glm::min(a, b), c) - region.margin,
               high = glm::max(glm::max(a, b), c) + region.margin;
    return std::ranges::any_of(step.zones, [&](const Box& zone) {
        return glm::all(glm::lessThanEqual(low, zone.max)) &&
               glm::all(glm::greaterThanEqual(high, zone.min));
    });
}

double InterpolationError::slope(const Corners& rest) const {
    const Triangle triangle(rest);
    const auto& [p, q] = triangle.plane;
    const double slope = triangle.bulge(unit_step_->bend({rest, 0.0}, p, q)) * kRoundedUp;
    return std::min(slope, slope_estimate(rest));
}

double InterpolationError::slope_estimate(const Corners& rest) const {
    const double radius = std::sqrt(enclosing_circle(rest).squared_radius) * kRadiusRoundedUp;
    return 0.5 * radius * radius * unit_step_->estimate(rest) * kRoundedUp;
}

double InterpolationError::displacement() const { return glm::length(known_.front()); }

double InterpolationError::bound(std::span<const Corners> before) const {
    if (!is_proportional()) return walk(before);
    const Corners& rest = before.front();
    if (!moves(steps_.front(), {rest, 0.0})) return 0.0;
    return known_or_infinite(displacement() * slope(rest) + rounding(rest));
}

double InterpolationError::rough_bound(const Corners& rest) const {
    if (steps_.size() > 1) return kUnknown;
    if (steps_.empty() || !moves(steps_.front(), {rest, 0.0})) return 0.0;
    const double radius = std::sqrt(enclosing_circle(rest).squared_radius) * kRadiusRoundedUp;
    return (0.5 * radius * radius * steps_.front().bounds.bend_everywhere() + rounding(rest)) *
           kRoughlyRoundedUp;
}

double InterpolationError::walk(std::span<const Corners> before) const {
    assert(before.size() == steps_.size());
    if (steps_.empty()) return 0.0;
    const Triangle triangle(before.front());
    Path path{.centre = triangle.centre, .plane = triangle.plane};
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const DerivativeBounds::Region region{before[k], triangle.bulge(path.bend) + path.rounding};
        if (!(region.margin < kMostMargin)) return kUnknown;
        if (!moves(steps_[k], region)) continue;
        const bool is_last = k + 1 == steps_.size();
        if (is_last && path.bend.most == 0.0 && path.rounding == 0.0) {
            path.bend = steps_[k].bounds.bend(region, path.plane[0], path.plane[1]);
        } else {
            advance(path, steps_[k].bounds.over(region, path.plane[0], path.plane[1]),
                    triangle.radius);
        }
        path.rounding += rounding_of(k, before[k]);
        if (!is_last) move(path, warp_.steps[k]);
    }
    return known_or_infinite((triangle.bulge(path.bend) + path.rounding) * kRoundedUp);
}

// What a step makes of the second derivative along the plane, and of rounding.
void InterpolationError::advance(Path& path, const DerivativeBounds::Bound& over,
                                 double radius) const {
    const auto& [p, q] = path.plane;
    const double pp = glm::dot(p, p), qq = glm::dot(q, q);
    const double length = std::sqrt(0.5 * (pp + qq) + std::hypot(0.5 * (pp - qq), glm::dot(p, q)));
    const double deviation = radius * path.bend.most + path.plane_rounding;
    const double rest = over.bend_any * deviation * (2.0 * length + deviation);
    path.bend.most = over.stretch * path.bend.most + over.bend.most + rest;
    path.bend.form = over.stretch * path.bend.form;
    path.bend.form += over.bend.form;
    path.bend.form += PlaneForm::circular(rest);
    path.plane_rounding = over.stretch * path.plane_rounding +
                          kJacobianRounding * (1.0 + over.stretch) * length +
                          over.bend_any * path.rounding * length;
    path.rounding *= over.stretch;
}

void InterpolationError::move(Path& path, const Deformation& step) {
    const Mat3 j = jacobian(step, path.centre);
    for (Vec3& direction : path.plane) direction = j * direction;
    path.centre = image(step, path.centre);
}

ErrorEllipsoid InterpolationError::accumulated(const ErrorEllipsoid& error, double own_bound,
                                               std::span<const Corners> before) const {
    assert(before.size() == steps_.size());
    const bool is_only = steps_.size() == 1;
    ErrorEllipsoid sum = error;
    double longest = error.radius();  // what the steps make of this length, in any direction
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        sum = after_step(k, sum, is_only ? own_bound : kUnknown, before[k], longest);
    }
    // This is better where derivatives change much over the triangle.
    longest = (longest + own_bound) * kRoundedUp;
    return longest < sum.radius() ? ErrorEllipsoid::ball(longest) : sum;
}

// own_bound: of the step, if it is known. longest: a distance to transport.
ErrorEllipsoid InterpolationError::after_step(std::size_t k, const ErrorEllipsoid& error,
                                              double own_bound, const Corners& corners,
                                              double& longest) const {
    const Step& step = steps_[k];
    const double size = error.radius();
    if (!(size < kMostMargin)) {
        longest = kUnknown;
        return error;
    }
    if (!moves(step, {corners, size})) return error;
    const Triangle triangle(corners);
    const auto& [p, q] = triangle.plane;
    double around = rounding_of(k, corners) + kBesideDirection * step.bounds.reach();
    double along =
        own_bound < kUnknown ? own_bound : triangle.bulge(step.bounds.bend({corners, 0.0}, p, q));
    ErrorEllipsoid moved = error;
    if (!error.is_zero()) {
        const auto [jacobian_there, rest, stretch] = step.bounds.transport(
            {corners, size}, jacobian(warp_.steps[k], triangle.centre), error.matrix());
        moved = ErrorEllipsoid::image(jacobian_there, error);
        along += rest;
        longest = std::min(longest * stretch, longest + step.bounds.range()) * kRoundedUp;
    }
    const std::optional<Vec3>& direction = step.bounds.direction();
    const ErrorEllipsoid added =
        direction ? ErrorEllipsoid::sum(ErrorEllipsoid::segment(along * kRoundedUp * *direction),
                                        ErrorEllipsoid::ball(around * kRoundedUp))
                  : ErrorEllipsoid::ball((along + around) * kRoundedUp);
    return ErrorEllipsoid::sum(moved, added);
}

}  // namespace pectin
