// Reserving memory for splits, so that a split either has all it needs or changes nothing.
#include <algorithm>
#include <limits>

#include "mesh/tri_mesh.h"

namespace pectin {

// Reserves the most that the split of e adds, before it changes anything. Throws std::bad_alloc.
void TriMesh::reserve_for_split(EdgeId e) {
    const bool along_cut = sibling(e) != e;
    if (!along_cut && split_capacity_.splits > 0) {
        --split_capacity_.splits;
        return;
    }
    std::size_t sides = 0;
    for_each_side(e, [&](HalfEdgeId) { ++sides; });
    if (along_cut) sheets_.reserve(sides);
    if (has_slots_for_split(e)) {
        split_capacity_.splits = 0;  // this split uses an unknown part of the capacity
        return;
    }
    reserve_for_sides(std::max<std::size_t>(sides, 2));
    split_capacity_.splits = along_cut ? 0 : split_capacity_.splits - 1;
}

// Whether the split of e needs no memory. This holds when a split takes back an unsplit of e.
bool TriMesh::has_slots_for_split(EdgeId e) {
    std::size_t wedges = 0, edges = 0, faces = 0;
    EdgeId sheet = e;
    do {
        const std::size_t sides = exists(twin(half_edge(sheet))) ? 2 : 1;
        wedges += sides == 2 && !is_smooth(sheet) ? 2 : 1;
        edges += 1 + sides;
        faces += sides;
        sheet = sibling(sheet);
    } while (sheet != e);
    return vertices_.can_allocate(1) && wedges_.can_allocate(wedges) &&
           edges_.can_allocate(edges) && faces_.can_allocate(faces);
}

// Makes room for a split with `sides` sides, and counts for how many splits with two sides there is
// room afterwards. Each side adds at most 1 vertex, 1 wedge, 2 edges and 1 face.
void TriMesh::reserve_for_sides(std::size_t sides) {
    std::size_t splits = std::numeric_limits<std::uint32_t>::max();
    const auto reserve = [&](auto& table, std::size_t per_side) {
        table.reserve_additional(per_side * sides);
        splits = std::min(splits, table.spare_capacity() / (2 * per_side));
    };
    reserve(vertices_, 1);
    reserve(wedges_, 1);
    reserve(edges_, 2);
    reserve(faces_, 1);
    split_capacity_.splits = static_cast<std::uint32_t>(splits);
}

void TriMesh::reserve_splits(std::uint32_t count) {
    if (split_capacity_.splits < count) reserve_for_sides(2 * std::size_t{count});
}

void TriMesh::prepare_splits(std::size_t count) {
    vertices_.prepare(count);
    wedges_.prepare(count);
    edges_.prepare(3 * count);
    faces_.prepare(2 * count);
}

void TriMesh::reserve_unsplits(std::size_t count) {
    vertices_.reserve_free(count);
    wedges_.reserve_free(2 * count);
    edges_.reserve_free(3 * count);
    faces_.reserve_free(2 * count);
}

}  // namespace pectin
