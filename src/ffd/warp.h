// Deformations one after the other: the warp of space that a gesture applies.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "ffd/drag_field.h"
#include "ffd/lattice_field.h"
#include "ffd/symmetry.h"

namespace pectin {

// One drag: linear in its displacements, with weights that depend on where a point is before it.
struct DragStep {
    DragField field;
    std::vector<Vec3> displacements;  // field.move_count()
    std::optional<Symmetry> symmetry{};

    // out: field.move_count(). Exactly zero where nothing moves.
    void weights(const Vec3& x, std::span<DragWeight> out) const {
        if (symmetry) {
            symmetric_weights(field, *symmetry, x, out);
        } else {
            field.weights(x, out);
        }
    }
    // Bounds of the present drag over all of space, as DragField has them. The image's share comes
    // on top of a point's own.
    double reach_bound() const { return (symmetry ? 2.0 : 1.0) * field.reach_bound(displacements); }
    double lipschitz_bound() const {
        return 1.0 + (symmetry ? 2.0 : 1.0) * (field.lipschitz_bound(displacements) - 1.0);
    }
    // The same as control points of one lattice, or of two whose displacements add up.
    std::vector<LatticeField> lattice_fields() const;
};

// Step k acts on where the steps before it have brought a point; each has a lattice of its own.
// A plain drag is one step; control points moved by hand are one LatticeField.
struct Warp {
    using Step = std::variant<DragStep, LatticeField>;
    std::vector<Step> steps;

    // Where something may move: the influenced zones of all lattices, each once.
    std::vector<Box> zones() const;
    // A box about all of them, outside which nothing moves.
    Box zone() const;
    // The smallest cell extent of its lattices; infinite without steps.
    double smallest_cell_extent() const;
};

inline const Lattice& lattice_of(const Warp::Step& step) {
    const auto* drag = std::get_if<DragStep>(&step);
    return drag ? drag->field.lattice() : std::get<LatticeField>(step).lattice();
}
// The displacements of a step: of the moves of a drag, or of all control points of a lattice.
inline std::span<const Vec3> displacements_of(const Warp::Step& step) {
    const auto* drag = std::get_if<DragStep>(&step);
    return drag ? std::span<const Vec3>(drag->displacements)
                : std::get<LatticeField>(step).displacements();
}
// A drag of more moves than kMostWeights as its displaced lattice: 64 terms for each point in place
// of one weight for each point and move. It stays a drag where its field is the sum of two lattices
// that differ. Cost: O(constraints · moves + control points).
inline constexpr std::size_t kMostWeights = 32;
Warp::Step compact(DragStep step);
// The displaced lattices of one step, whose fields add up: one, or two of a symmetric drag. Where
// these are the same, as of a cage about the plane, one with the displacements of both.
std::vector<LatticeField> lattice_fields(const Warp::Step& step);
// The influenced zones of one step: one, or two of a symmetric drag.
std::vector<Box> zones_of(const Warp::Step& step);

}  // namespace pectin
