// Upper bounds of the first and second derivatives of a deformation over a small region.
// Source: G. Farin. Curves and Surfaces for CAGD. Morgan Kaufmann 2002 (Bernstein form, blossoms,
// convex hull property).
//
// Between the knots the displacement D is a polynomial of degree (3, 3, 3), and so is every entry
// of its gradient and of its second derivative, with the degree raised where differentiation has
// lowered it:
//
//     D²D(x) = Σ_i B_i(x) S_i,    B_i ≥ 0,  Σ_i B_i = 1,    S_i the 64 Bernstein coefficients.
//
// A norm is convex, so its greatest value over the coefficients bounds it over the box to which the
// coefficients belong (see also ffd/plane_bend.h). The region's own box is taken, divided at knots:
// over the whole cells of a lattice the bound would be ten times as large or more.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ffd/cubic_basis.h"
#include "ffd/lattice_field.h"
#include "ffd/plane_bend.h"
#include "geometry/box.h"

namespace pectin {

class DerivativeBounds {
  public:
    // The points that are no farther than `margin` from a triangle, along each axis.
    struct Region {
        std::array<Vec3, 3> corners{};
        double margin = 0.0;
    };
    // Of F(x) = x + D(x). All are upper bounds over a region, in world units.
    struct Bound {
        double stretch = 1.0;   // of |J v|, for all unit vectors v
        PlaneBend bend;         // of |D²F(u, u)|, for u in the plane of p and q
        double bend_any = 0.0;  // of |D²F(u, v)|, for all unit vectors u and v
    };

    // The lattices whose fields add up to D. Copies the displacements.
    // Cost: O(control points).
    explicit DerivativeBounds(std::span<const LatticeField> sum);

    // Cost: about 5000 multiplications for each cell that the region's box meets, and three times
    // as many where control points move in different directions. From some hundred cells on it is
    // a constant time, and the bounds are those over all of space.
    Bound over(const Region& region, const Vec3& p, const Vec3& q) const;
    // What F makes of the ellipsoid of s, that is, of all v with v vᵀ ≼ s: for each point x of the
    // triangle F(x + v) − F(x) is jacobian · v and a vector no longer than `rest`, which is
    // parallel to direction() if there is one. The margin has to contain the ellipsoid. at_centre:
    // the Jacobian at a point of the triangle. Cost: twice that of over().
    struct Transport {
        Mat3 jacobian{1.0};  // at_centre, without what is beside direction()
        double rest = 0.0;
        double stretch = 1.0;  // see Bound
    };
    Transport transport(const Region& region, const Mat3& at_centre, const Mat3& s) const;
    // The bend alone.
    PlaneBend bend(const Region& region, const Vec3& p, const Vec3& q) const;
    // Prepares estimate(), if D is the field of one lattice that is not too large.
    // Cost: eight bounds for each cell of the influenced zone.
    void tabulate();
    // Bounds what bend().most bounds, for a region without a margin and orthonormal p and q, from
    // the table of bounds over the eighths of cells: several times as large, and much faster.
    // Without a table it is the bound over all of space. Cost: O(eighths that the region's box
    // meets).
    double estimate(const std::array<Vec3, 3>& corners) const;
    // Upper bounds of |D²F(u, u)|, for unit vectors u, and of |D(x)| over all of space.
    double bend_everywhere() const { return everywhere_.second; }
    double reach() const { return reach_; }
    // An upper bound of |D(x) − D(y)|, for all points x and y.
    double range() const { return range_; }
    // A unit vector to which all displacements are parallel, up to 1e-13 of the longest; none if
    // there is none.
    const std::optional<Vec3>& direction() const { return direction_; }

  private:
    // The displaced control points of one lattice and the static ones around them, from (−3, −3,
    // −3) on, i fastest. Where all move along one direction `along` has their lengths, otherwise
    // `points` has them.
    struct Field {
        Lattice lattice;
        std::array<std::size_t, 3> steps{};  // distances of neighbours along the axes
        std::vector<double> along;
        std::vector<Vec3> points;
    };
    struct Interval;
    struct Pieces;
    // Upper bounds over all of space.
    struct Everywhere {
        double gradient = 0.0, second = 0.0;  // Frobenius norms
    };

    template <typename T>
    const std::vector<T>& values_of(const Field& field) const;
    template <typename T>
    Everywhere everywhere(const Field& field) const;
    template <typename T>
    void add_field(const LatticeField& from);
    bool divide(const Region& region, Pieces& pieces) const;
    template <typename T, typename Measure, typename Still>
    void for_each_piece(const Region& region, const Pieces& pieces, const Measure& measure,
                        const Still& still) const;
    template <typename T>
    void transport_over(const Region& region, Pieces& pieces, const std::array<T, 3>& from,
                        const Mat3& s, Transport& result) const;
    template <typename T>
    bool gather(const Pieces& pieces, const std::array<std::size_t, 3>& piece, std::size_t field,
                std::array<T, 64>& values) const;
    template <typename T>
    Bound bound_over(const Region& region, const Pieces& pieces, const Vec3& p, const Vec3& q,
                     bool only_bend) const;
    Bound bound(const Region& region, const Vec3& p, const Vec3& q, bool only_bend) const;

    std::vector<Field> fields_;
    std::optional<Vec3> direction_;  // a unit vector to which all displacements are parallel
    Everywhere everywhere_;
    double reach_ = 0.0, range_ = 0.0;
    std::vector<double> table_;  // bend_any of the eighths of cells from (−2, −2, −2) on; or empty
    IVec3 table_size_{0};
};

}  // namespace pectin
