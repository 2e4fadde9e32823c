// The deformations of space that a warp may consist of, and the operations that all of them share.
//
// To add a deformation, write a type with the functions that the concept SpaceDeformation lists, as
// overloads beside the type, and add the type to the variant Deformation below. No other file asks
// which alternative a Deformation holds.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "ffd/drag_step.h"
#include "ffd/lattice_field.h"
#include "ffd/symmetric_lattice.h"
#include "geometry/box.h"

namespace pectin {

// What every deformation x ↦ x + D(x) supplies. All of it is in world space.
//
// Some deformations are linear in their displacements, D(x) = Σ_c w_c(x) d_c. Such a deformation
// has a weight_count() above 0, one weight for each displacement, and an embedding evaluates the
// weights of each vertex only once in a gesture. The functions with the parameter w then work with
// the weights of x. All other deformations have a weight_count() of 0 and ignore w.
template <typename D>
concept SpaceDeformation = requires(const D& deformation, D& changing, const Vec3& x,
                                    const Vec3f& normal, std::span<const DragWeight> w,
                                    std::span<DragWeight> out, double most) {
    // The lattice that shows and measures the deformation.
    { lattice_of(deformation) } -> std::convertible_to<const Lattice&>;
    // The displacements of the drag's weights, or of the control points. They may change between
    // the frames of a gesture; everything else stays.
    { displacements_of(deformation) } -> std::convertible_to<std::span<const Vec3>>;
    { displacements_of(changing) } -> std::convertible_to<std::span<Vec3>>;
    // Boxes outside which nothing moves, bit for bit.
    { zones_of(deformation) } -> std::convertible_to<std::vector<Box>>;
    // The extent of the smallest feature that the deformation can give a surface: L_max.
    { smallest_feature_extent(deformation) } -> std::same_as<double>;
    // Displaced lattices whose fields add up to D, for display: equal lattices are merged into one.
    { merged_lattices(deformation) } -> std::convertible_to<std::vector<LatticeField>>;

    { weight_count(deformation) } -> std::same_as<std::size_t>;
    weights_at(deformation, x, out);  // out: weight_count()
    // x + D(x).
    { image(deformation, x, w) } -> std::convertible_to<Vec3>;
    // J = ∂(x + D)/∂x, its determinant, and normalise(cof(J)·n): equation 3.
    { jacobian(deformation, x, w) } -> std::convertible_to<Mat3>;
    { jacobian_determinant(deformation, x, w) } -> std::same_as<double>;
    { covariant_normal(deformation, x, w, normal) } -> std::convertible_to<Vec3f>;

    // Upper bounds over all of space at the present displacements, infinite where none is known: of
    // |D|, and of how many times longer the deformation makes a short edge.
    { reach_bound(deformation) } -> std::same_as<double>;
    { lipschitz_bound(deformation) } -> std::same_as<double>;
    // The largest t in (0, most] for which x + t·D(x) is proven one to one; 0 if nothing is proven.
    { injective_limit(deformation, most) } -> std::same_as<double>;
};

// A drag, a displaced lattice, or a displaced lattice with its mirror image. The concept is checked
// here, before a Deformation itself could stand in for a function that an alternative lacks.
template <SpaceDeformation... Alternatives>
using OneOf = std::variant<Alternatives...>;
using Deformation = OneOf<DragStep, LatticeField, SymmetricLattice>;

// Calls pass with the deformation as the type it is, whose functions are then called directly. A
// loop over many points stands inside pass, so that it pays for the dispatch only once.
template <typename Pass>
decltype(auto) dispatch(const Deformation& deformation, Pass&& pass) {
    return std::visit(std::forward<Pass>(pass), deformation);
}

// --- The same functions for whichever deformation it is.

const Lattice& lattice_of(const Deformation& deformation);
std::span<const Vec3> displacements_of(const Deformation& deformation);
std::span<Vec3> displacements_of(Deformation& deformation);
std::vector<Box> zones_of(const Deformation& deformation);
double smallest_feature_extent(const Deformation& deformation);
std::vector<LatticeField> merged_lattices(const Deformation& deformation);
std::size_t weight_count(const Deformation& deformation);
double reach_bound(const Deformation& deformation);
double lipschitz_bound(const Deformation& deformation);
double injective_limit(const Deformation& deformation, double most = 1.0);
// These evaluate the weights themselves.
Vec3 image(const Deformation& deformation, const Vec3& x);
Mat3 jacobian(const Deformation& deformation, const Vec3& x);
Vec3f covariant_normal(const Deformation& deformation, const Vec3& x, const Vec3f& n);

// --- Fast paths.

// The displaced lattice with which a LatticeEvaluator evaluates this deformation at many points at
// once; null where there is none. For a deformation with one weight ffd/drag_stream.h does so.
const LatticeField* streamed_lattice(const Deformation& deformation);

// A drag with more weights than kMostWeights is faster as its displaced lattice: 64 terms for each
// point instead of one weight for each point and displacement. With symmetry, it is one lattice if
// that is its own mirror image, and otherwise a SymmetricLattice. Cost: O(constraints · weights +
// control points).
inline constexpr std::size_t kMostWeights = 32;
Deformation compact(DragStep drag);

}  // namespace pectin
