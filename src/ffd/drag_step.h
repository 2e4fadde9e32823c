// A deformation of space by one drag, which may move several handles at once.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ffd/drag_field.h"
#include "ffd/lattice_field.h"
#include "ffd/symmetry.h"

namespace pectin {

// A drag field with the displacements of its weights. It is linear in the displacements, and its
// weights depend only on where a point is before the drag.
struct DragStep {
    DragField field;
    std::vector<Vec3> displacements;  // field.weight_count()
    std::optional<Symmetry> symmetry{};

    // out: field.weight_count(). Exactly zero where nothing moves.
    void weights(const Vec3& x, std::span<DragWeight> out) const {
        if (symmetry) {
            symmetric_weights(field, *symmetry, x, out);
        } else {
            field.weights(x, out);
        }
    }
    // The displaced lattices whose fields add up to the drag: one, or with symmetry that one and
    // its mirror image. Cost: O(constraints · weights + control points).
    std::vector<LatticeField> lattice_fields() const;
};

// --- What every deformation supplies; ffd/deformation.h explains each function.

inline const Lattice& lattice_of(const DragStep& drag) { return drag.field.lattice(); }
inline std::span<const Vec3> displacements_of(const DragStep& drag) { return drag.displacements; }
inline std::span<Vec3> displacements_of(DragStep& drag) { return drag.displacements; }
std::vector<Box> zones_of(const DragStep& drag);
inline double smallest_feature_extent(const DragStep& drag) {
    return drag.field.lattice().smallest_cell_extent();
}
std::vector<LatticeField> merged_lattices(const DragStep& drag);

inline std::size_t weight_count(const DragStep& drag) { return drag.displacements.size(); }
inline void weights_at(const DragStep& drag, const Vec3& x, std::span<DragWeight> out) {
    drag.weights(x, out);
}
inline Vec3 image(const DragStep& drag, const Vec3& x, std::span<const DragWeight> weights) {
    return displaced(x, weights, drag.displacements);
}
inline Mat3 jacobian(const DragStep& drag, const Vec3&, std::span<const DragWeight> weights) {
    return jacobian(weights, drag.displacements);
}
inline double jacobian_determinant(const DragStep& drag, const Vec3&,
                                   std::span<const DragWeight> weights) {
    return jacobian_determinant(weights, drag.displacements);
}
inline Vec3f covariant_normal(const DragStep& drag, const Vec3&,
                              std::span<const DragWeight> weights, const Vec3f& n) {
    return covariant_normal(n, weights, drag.displacements);
}

// With symmetry, the bounds of a point's own side and of the mirror image add up.
double reach_bound(const DragStep& drag);
double lipschitz_bound(const DragStep& drag);
double injective_limit(const DragStep& drag, double most = 1.0);

}  // namespace pectin
