#include "ffd/deformation.h"

#include <array>
#include <utility>

namespace pectin {
namespace {

// Calls evaluate(deformation as the type it is, its weights at x). Allocates only for a drag that
// compact() has not seen.
template <typename Evaluate>
auto with_weights(const Deformation& deformation, const Vec3& x, const Evaluate& evaluate) {
    return dispatch(deformation, [&](const auto& d) {
        std::array<DragWeight, kMostWeights> few;
        std::vector<DragWeight> many;
        const std::size_t count = weight_count(d);
        if (count > few.size()) many.resize(count);
        const std::span<DragWeight> weights =
            count > few.size() ? std::span(many) : std::span(few).first(count);
        weights_at(d, x, weights);
        return evaluate(d, std::span<const DragWeight>(weights));
    });
}

}  // namespace

const Lattice& lattice_of(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) -> const Lattice& { return lattice_of(d); });
}

std::span<const Vec3> displacements_of(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return displacements_of(d); });
}

std::span<Vec3> displacements_of(Deformation& deformation) {
    return std::visit([](auto& d) { return displacements_of(d); }, deformation);
}

std::vector<Box> zones_of(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return zones_of(d); });
}

double smallest_feature_extent(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return smallest_feature_extent(d); });
}

std::vector<LatticeField> merged_lattices(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return merged_lattices(d); });
}

std::size_t weight_count(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return weight_count(d); });
}

double reach_bound(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return reach_bound(d); });
}

double lipschitz_bound(const Deformation& deformation) {
    return dispatch(deformation, [](const auto& d) { return lipschitz_bound(d); });
}

double injective_limit(const Deformation& deformation, double most) {
    return dispatch(deformation, [&](const auto& d) { return injective_limit(d, most); });
}

Vec3 image(const Deformation& deformation, const Vec3& x) {
    return with_weights(deformation, x,
                        [&](const auto& d, const auto& weights) { return image(d, x, weights); });
}

Mat3 jacobian(const Deformation& deformation, const Vec3& x) {
    return with_weights(deformation, x, [&](const auto& d, const auto& weights) {
        return jacobian(d, x, weights);
    });
}

Vec3f covariant_normal(const Deformation& deformation, const Vec3& x, const Vec3f& n) {
    return with_weights(deformation, x, [&](const auto& d, const auto& weights) {
        return covariant_normal(d, x, weights, n);
    });
}

const LatticeField* streamed_lattice(const Deformation& deformation) {
    return std::get_if<LatticeField>(&deformation);
}

Deformation compact(DragStep drag) {
    if (weight_count(drag) <= kMostWeights) return drag;
    std::vector<LatticeField> fields = merged_lattices(drag);
    if (fields.size() == 1) return std::move(fields.front());
    return SymmetricLattice{std::move(fields.front()), drag.symmetry->plane};
}

}  // namespace pectin
