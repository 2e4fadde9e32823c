// An active set embedded in a warp: weights once a gesture, positions and normals every frame.
// Source: Gain & Dodgson 1999, sections 2 and 3 (equation 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ffd/lattice_evaluator.h"
#include "ffd/warp.h"
#include "mesh/active_set.h"
#include "mesh/growing_array.h"

namespace pectin {

// Entries are those of the active set. Holds references to both; call embed() first.
// Without steps nothing moves. Only the last step's displacements may change after embed().
class Embedding {
  public:
    Embedding(ActiveSet& active, const Warp& warp) : active_(active), warp_(warp) {}

    // Every influenced vertex as the last step finds it, and its weights there. Cost: O(influenced)
    // a step.
    void embed();
    // Positions, wedge normals and deformed marks of all influenced vertices from their rest
    // state, by the warp's present displacements. Cost: O(influenced), streaming.
    void deform();
    // For the entries that splits have just added; then embed_inserted(), for all of these. It does
    // not throw where reserve_splits has made room for as many splits of smooth edges.
    void fit_to_entries();
    void reserve_splits(std::uint32_t count);
    // Several threads may, each with its own: weights, positions and normals of what splits have
    // just inserted. A vertex has as many of these as there are sheets, one after another.
    void embed_inserted(std::span<const ActiveSet::Inserted> inserted) {
        std::vector<DragWeight> scratch(scratch_size());
        embed_inserted(inserted, scratch);
    }
    // The same, working in what each thread has of its own: so many weights.
    void embed_inserted(std::span<const ActiveSet::Inserted> inserted,
                        std::span<DragWeight> scratch);
    std::size_t scratch_size() const;

    // Where the warp takes a point, by its present displacements.
    Vec3 image(const Vec3& rest) const;
    // Whether there are no steps, so that nothing moves.
    bool is_identity() const { return stages_.empty(); }
    // Entries with det J <= 0 in some step, at the present displacements. Cost: O(entries).
    std::uint64_t folded_vertices() const;
    // No edge of the active set is longer now: its length at rest by the greatest stretch of the
    // warp. Infinite where none is known, after several steps or control points moved by hand.
    // O(1).
    double longest_edge_bound() const;
    std::size_t memory_bytes() const;

    // --- Between the steps.
    // Whether an edge of the face abc is longer than l_max where a step but the first finds it, and
    // the face meets that step's zone there: what the step does inside it would go unseen.
    bool is_long_between_steps(VertexId a, VertexId b, VertexId c, double l_max) const;

  private:
    // Where a step finds the entries.
    struct Stage {
        GrowingArray<Vec3> positions;  // of the vertex entries; empty in the first (rest)
        std::vector<Box> zones;        // of the step
    };

    std::size_t last() const { return stages_.size() - 1; }

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
    std::vector<Stage> stages_;         // one a step
    std::size_t weight_count_ = 0;      // of the last step
    GrowingArray<Vec3f> normals_;       // of the wedge entries before the last step, if several
    GrowingArray<DragWeight> weights_;  // of the last step: vertex entries x weight_count_
    std::vector<std::uint8_t> runs_;    // of blocks of entries where the last step has one weight
    std::optional<LatticeEvaluator> evaluator_;  // of the last step, where it has one
    GrowingArray<std::uint8_t> has_folded_;      // vertex entries, in a step before the last
};

}  // namespace pectin
