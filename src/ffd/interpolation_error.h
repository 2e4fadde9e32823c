// How far a flat triangle with deformed corners may be from the exact image of the flat triangle at
// rest: a proven bound.
// Sources: S. Waldron. The error in linear interpolation at the vertices of a simplex. SIAM Journal
// on Numerical Analysis 35(3), 1998. E. F. D'Azevedo, R. B. Simpson. On Optimal Interpolation
// Triangle Incidences. SIAM Journal on Scientific and Statistical Computing 10(6), 1989.
//
// Let Π F interpolate F linearly at the corners v_i of a triangle T, and let Q be a quadratic form
// of its plane with |D²F(u, u)| ≤ Q(u) on T, for all vectors u in the plane. By Taylor's theorem at
// the point x of T with barycentric coordinates λ_i, where the linear terms cancel,
//
//     |F(x) − Π F(x)| ≤ ½ Σ_i λ_i Q(v_i − x) = ½ Σ_{i<j} λ_i λ_j Q(v_i − v_j) ≤ ½ R²,
//
// where R is the radius of the smallest circle that encloses T if Q measures the squares of
// lengths. With one bound M of |D²F(u, u)| for all unit vectors u this is Waldron's ½ M R², R as
// usual. It is larger where F bends in one direction more than in another, but M is found more
// exactly than Q, so both are computed and the smaller one counts.
//
// F is the warp, F_n ∘ … ∘ F_1. Let G = F_k ∘ … ∘ F_1 be its first steps, M and Q such bounds of
// D²G, c the centre of the circle, and A = DG(c) on the plane of T. Then DG(x)u differs from A u by
// at most δ|u|, δ = M R, and the next step F maps to
//
//     D²(F ∘ G)(u, u) = DF · D²G(u, u) + D²F(DG u, DG u),
//     Q'(u) = L Q(u) + P(u) + K (2 |A| δ + δ²) |u|²,    P(u) ≥ |D²F(A u, A u)|,
//
// and M' likewise. L bounds |DF| and K bounds |D²F| over the image G(T), which lies no farther from
// the flat triangle of its corners than the bound up to there. So each step is bounded where the
// triangle is, and in the directions that it has there.
//
// Corners are rounded: weights of drags are stored as floats. Each step adds its rounding to what
// the next ones make of that of the steps before.
//
// Of an error v that earlier deformations have left at a point p of the triangle, a step makes
//
//     F(p + v) − F(p) = DF(c) v + r,
//     |r| ≤ sup |(DF(x) − DF(c)) v| over T + ½ sup |D²F(v, v)| over the points within |v| of T,
//
// to which it adds its own error, ½ R². If all displacements have one direction, r and its own
// error have that direction, too. No error grows by more than the displacements of two points
// differ, plus the step's own error.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "ffd/derivative_bounds.h"
#include "ffd/warp.h"
#include "geometry/error_ellipsoid.h"

namespace pectin {

// The smallest circle that encloses a triangle, in its plane. Its centre lies in the triangle.
struct EnclosingCircle {
    Vec3 centre{0.0};
    double squared_radius = 0.0;
};
EnclosingCircle enclosing_circle(const std::array<Vec3, 3>& corners);

class InterpolationError {
  public:
    using Corners = std::array<Vec3, 3>;

    // Keeps a reference to the warp. Cost: O(control points) for each step.
    explicit InterpolationError(const Warp& warp);
    // Takes over the displacements of the last step if they have changed; those of the other steps
    // must not. Cost: O(control points) of the last step.
    void update();

    // An upper bound of the distance of the flat triangle of the deformed corners, as an Embedding
    // computes them, from the image of the flat triangle at rest: point by point, with the same
    // barycentric coordinates. before: the corners before each step; those before the first are at
    // rest. Several threads may call this. Cost: that of DerivativeBounds::over() for each step in
    // whose zone the triangle is.
    double bound(std::span<const Corners> before) const;

    // A bound that is many times as large and costs O(1), from those over all of space;
    // infinite for a warp of several steps. It is never below bound().
    double rough_bound(const Corners& rest) const;

    // What the steps make of errors: contains the vectors from the points of the flat deformed
    // triangle to the images of points that were off the triangle at rest by vectors in `error`.
    // Point by point, with the same barycentric coordinates. own_bound: bound(before). Cost: some
    // three times that of bound() where there is an error.
    ErrorEllipsoid accumulated(const ErrorEllipsoid& error, double own_bound,
                               std::span<const Corners> before) const;

    // Of a warp of one step with one weight, the bound is |d| times a number, plus the rounding:
    // its displacement is d. Then `slope` is that number, which does not change with d.
    bool is_proportional() const { return unit_step_.has_value(); }
    double slope(const Corners& rest) const;
    // An upper bound of slope(), several times as large and much faster.
    double slope_estimate(const Corners& rest) const;
    double displacement() const;  // |d|
    double rounding(const Corners& corners) const { return rounding_of(0, corners); }

  private:
    struct Step {
        DerivativeBounds bounds;
        std::vector<Box> zones;
        double rounding = 0.0;  // of the displacements of corners
    };
    // A triangle before a step.
    struct Triangle {
        explicit Triangle(const Corners& corners);
        // An upper bound of the interpolation error of a function with this second derivative.
        double bulge(const PlaneBend& bend) const;

        Vec3 centre;                // of the smallest circle that encloses it
        double radius;              // of that circle
        std::array<Vec3, 2> plane;  // orthonormal
        PlaneSides sides;           // along these vectors
    };
    // What is known about a triangle before a step.
    struct Path {
        Vec3 centre;                // where the warp has taken the centre of its circle
        std::array<Vec3, 2> plane;  // the columns of A
        PlaneBend bend{};           // of D²G
        double rounding = 0.0;      // of the corners
        double plane_rounding = 0.0;
    };
    static Step bounded(const Deformation& step);
    double walk(std::span<const Corners> before) const;
    ErrorEllipsoid after_step(std::size_t k, const ErrorEllipsoid& error, double own_bound,
                              const Corners& corners, double& longest) const;
    void advance(Path& path, const DerivativeBounds::Bound& over, double radius) const;
    static void move(Path& path, const Deformation& step);
    bool moves(const Step& step, const DerivativeBounds::Region& region) const;
    double rounding_of(std::size_t step, const Corners& corners) const;

    const Warp& warp_;
    std::vector<Step> steps_;
    std::vector<Vec3> known_;                    // displacements of the last step
    std::optional<DerivativeBounds> unit_step_;  // by a displacement of unit length
};

}  // namespace pectin
