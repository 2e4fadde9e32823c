// An active set embedded in a warp: weights once a gesture, positions and normals every frame.
// Source: Gain & Dodgson 1999, sections 2 and 3 (equation 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ffd/warp.h"
#include "mesh/active_set.h"

namespace pectin {

// Entries are those of the active set. Holds references to both; call embed() first.
// Without steps nothing moves.
class Embedding {
  public:
    Embedding(ActiveSet& active, const Warp& warp) : active_(active), warp_(warp) {}

    // Weights of every influenced vertex. Cost: O(influenced).
    void embed();
    // Positions, wedge normals and deformed marks of all influenced vertices from their rest
    // state, by the warp's present displacements. Cost: O(influenced), streaming.
    void deform();
    // Weights, position and normals of a vertex that a split has just inserted.
    void place(const ActiveSet::Inserted& inserted);

    // Entries with det J <= 0 in some step, at the present displacements. Cost: O(entries).
    std::uint64_t folded_vertices() const;
    std::size_t memory_bytes() const;

  private:
    // One step of the warp: where the entries are before it, and their weights in it.
    struct Stage {
        std::vector<Vec3> positions;      // of the vertex entries; empty in the first stage (rest)
        std::vector<Vec3f> normals;       // of the wedge entries; empty in the first stage (rest)
        std::vector<DragWeight> weights;  // vertex entries x moves, entry-major
    };

    void resize();
    void embed_entry(std::size_t step, std::uint32_t entry);
    void deform_vertices(std::size_t step, std::uint32_t first, std::uint32_t last);
    void deform_wedges(std::size_t step, std::uint32_t first, std::uint32_t last);
    const Vec3& start_position(std::size_t step, std::uint32_t entry) const;
    const Vec3f& start_normal(std::size_t step, std::uint32_t entry) const;
    std::span<const DragWeight> weights(std::size_t step, std::uint32_t entry) const;

    ActiveSet& active_;
    const Warp& warp_;
    std::vector<Stage> stages_;
};

}  // namespace pectin
