// The part of TriMesh that reserves slots for splits and unsplits on several threads.
#include "mesh/concurrent_allocation.h"

#include "mesh/tri_mesh.h"

namespace pectin {

// Takes the slots of the split of one smooth edge, in the order of TriMesh::insert_midpoint(e).
SplitIds TriMesh::allocate_split() {
    SplitIds ids;
    ids.m = vertices_.allocate();
    ids.wedge = wedges_.allocate();
    ids.mc = edges_.allocate();
    ids.am = edges_.allocate();
    ids.dm = edges_.allocate();
    ids.face3 = faces_.allocate();
    ids.face4 = faces_.allocate();
    return ids;
}

bool TriMesh::has_free_slots() const {
    return vertices_.has_free_slots() || wedges_.has_free_slots() || edges_.has_free_slots() ||
           faces_.has_free_slots();
}

void TriMesh::allocate_splits(std::span<SplitIds> splits) {
    reserve_splits(static_cast<std::uint32_t>(splits.size()));
    split_capacity_.splits -= static_cast<std::uint32_t>(splits.size());
    while (has_free_slots() && !splits.empty()) {
        splits.front() = allocate_split();
        splits = splits.subspan(1);
    }
    // Nothing is free any more: what follows would add slots one by one.
    const SlotCounts first = slot_counts();
    const auto count = static_cast<std::uint32_t>(splits.size());
    vertices_.grow(count);
    wedges_.grow(count);
    edges_.grow(3 * std::size_t{count});
    faces_.grow(2 * std::size_t{count});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t e = first.edges + 3 * i, f = first.faces + 2 * i;
        splits[i] = {VertexId{first.vertices + i},
                     WedgeId{first.wedges + i},
                     EdgeId{e},
                     EdgeId{e + 1},
                     EdgeId{e + 2},
                     FaceId{f},
                     FaceId{f + 1}};
    }
}

FreedSlots TriMesh::allocate_freed(std::size_t splits) {
    return {vertices_.grow_free(splits), wedges_.grow_free(splits), edges_.grow_free(3 * splits),
            faces_.grow_free(2 * splits)};
}

// In the order of TriMesh::unsplit().
void TriMesh::free_split(const SplitIds& ids, const FreedSlots& first, std::size_t i) {
    faces_.set_free(first.face + 2 * i, ids.face4);
    faces_.set_free(first.face + 2 * i + 1, ids.face3);
    edges_.set_free(first.edge + 3 * i, ids.dm);
    edges_.set_free(first.edge + 3 * i + 1, ids.am);
    edges_.set_free(first.edge + 3 * i + 2, ids.mc);
    wedges_.set_free(first.wedge + i, ids.wedge);
    vertices_.set_free(first.vertex + i, ids.m);
}

}  // namespace pectin
