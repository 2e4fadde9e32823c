// An active set embedded in a warp: weights once a gesture, positions and normals every frame.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Sections 2 and 3 (equation 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ffd/lattice_evaluator.h"
#include "ffd/warp.h"
#include "geometry/stop_token.h"
#include "mesh/active_set.h"
#include "mesh/growing_array.h"

namespace pectin {

// Holds references to the active set and the warp. "Entries" are those of the active set. embed()
// has to be called first. After embed(), only the displacements of the last step of the warp may
// change. A warp without steps moves nothing.
class Embedding {
  public:
    Embedding(ActiveSet& active, const Warp& warp) : active_(active), warp_(warp) {}

    // Computes, for every influenced vertex, its position before the last step and its weights
    // there. Throws Stopped where `stop` asks for it. Cost: O(influenced vertices) for each step.
    void embed(const StopToken& stop = {});
    // Sets the positions, wedge normals and deformed marks of all influenced vertices from their
    // rest state, by the present displacements of the warp. Cost: O(influenced vertices),
    // streaming.
    void deform();
    // Adds space for the entries that splits have just added. embed_inserted() has to follow for
    // all of them. Does not throw if reserve_splits() has reserved space for as many splits.
    void fit_to_entries();
    // count: splits of smooth edges, each of which adds one vertex and one wedge.
    void reserve_splits(std::uint32_t count);
    // Computes weights, positions and normals of the vertices that splits have just inserted. A
    // vertex on a cut has an element for each sheet, one after another. Several threads may call
    // this at the same time, each for vertices of its own.
    void embed_inserted(std::span<const ActiveSet::Inserted> inserted) {
        std::vector<DragWeight> scratch(scratch_size());
        embed_inserted(inserted, scratch);
    }
    // The same with working memory from the caller: scratch_size() weights.
    void embed_inserted(std::span<const ActiveSet::Inserted> inserted,
                        std::span<DragWeight> scratch);
    std::size_t scratch_size() const;

    // The image of a point under the warp with its present displacements: where a vertex goes that
    // a split inserts there, if it moves. Several threads may call it at the same time.
    Vec3 image(const Vec3& rest) const;
    const Warp& warp() const { return warp_; }
    // Whether the warp has no steps, so that nothing moves.
    bool is_identity() const { return step_starts_.empty(); }
    // Whether the warp has several steps. Known before embed().
    bool is_composed() const { return warp_.steps.size() > 1; }
    // The number of influenced vertices with det J <= 0 in some step, at the present displacements.
    // Cost: O(entries).
    std::uint64_t folded_vertices() const;
    // An upper bound on the present length of all edges of the active set: the longest rest length
    // times the Lipschitz bound of the warp. Infinite if no Lipschitz bound is known: for several
    // steps, or where control points are moved by hand. Cost: O(1).
    double longest_edge_bound() const;
    std::size_t memory_bytes() const;

    // --- The states before the steps. The one before the first step is the rest state, and
    // step_count() stands for the present one.
    std::size_t step_count() const { return step_starts_.size(); }
    Vec3 position_before(std::size_t step, VertexId v) const;
    std::span<const Box> zones(std::size_t step) const { return step_starts_[step].zones; }
    bool steps_move_middles_most() const { return warp_.moves_middles_most; }

  private:
    // The state before a step.
    struct StepStart {
        GrowingArray<Vec3> positions;  // of the vertex entries; empty for the first step (rest)
        std::vector<Box> zones;        // of the step
    };

    std::size_t last() const { return step_starts_.size() - 1; }

    // --- A step before the last: `deformation` is that step. weights: those of the entry.
    template <typename D>
    void embed_before_last(const D& deformation, std::size_t step);
    template <typename D>
    void advance(const D& deformation, std::size_t step, std::uint32_t entry,
                 std::span<const DragWeight> weights);
    template <typename D>
    void transform_normal(const D& deformation, std::size_t step, std::uint32_t wedge,
                          std::span<const DragWeight> weights);
    void bring_to_last_step(std::span<const ActiveSet::Inserted> sheets,
                            std::span<DragWeight> scratch);

    // --- The last step, every frame: `deformation` is that step.
    template <typename D>
    void embed_vertex(const D& deformation, std::span<const ActiveSet::Inserted> sheets,
                      std::span<DragWeight> scratch);
    template <typename D>
    void embed_by_one_weight(const D& deformation, std::span<const ActiveSet::Inserted> sheets);
    template <typename D>
    void deform_vertices(const D& deformation, std::uint32_t first, std::uint32_t end);
    template <typename D>
    void deform_wedges(const D& deformation, std::uint32_t first, std::uint32_t end);
    const Vec3& start_position(std::size_t step, std::uint32_t entry) const;
    std::span<const Vec3> start_positions() const;  // of the last step
    std::span<const Vec3f> start_normals() const;
    std::span<DragWeight> weights_of(std::uint32_t entry);
    std::span<const DragWeight> weights(std::uint32_t entry) const;

    ActiveSet& active_;
    const Warp& warp_;
    std::vector<StepStart> step_starts_;  // one for each step
    std::size_t weight_count_ = 0;        // per vertex, in the last step
    GrowingArray<Vec3f> normals_;       // of the wedge entries before the last step; empty for one
    GrowingArray<DragWeight> weights_;  // of the last step: vertex entries x weight_count_
    std::vector<std::uint8_t> runs_;  // lasting_runs(), if the last step has one weight per vertex
    std::optional<LatticeEvaluator> evaluator_;  // if the last step is a lattice field
    GrowingArray<std::uint8_t> has_folded_;  // vertex entries: 1 if det J <= 0 in an earlier step
};

}  // namespace pectin
