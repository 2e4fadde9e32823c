// Slots reserved for splits and unsplits that several threads make at the same time.
//
// Two edits are independent if their stencils share no vertex: then they write different elements
// of every array. What remains shared is where new elements go and in which order slots are freed
// and edits are logged. So one thread reserves slots for all edits first and numbers them; each
// edit then uses the slots of its number, and no array changes its size. The result is the same as
// that of serial edits in the order of their numbers.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mesh/ids.h"

namespace pectin {

// The elements that the split of a smooth edge adds, in the order of their allocation.
struct SplitIds {
    VertexId m = kNone<VertexId>;
    WedgeId wedge = kNone<WedgeId>;
    EdgeId mc = kNone<EdgeId>, am = kNone<EdgeId>, dm = kNone<EdgeId>;
    FaceId face3 = kNone<FaceId>, face4 = kNone<FaceId>;
};

// Reserved entries in the free lists of a mesh, for the slots that several unsplits free: the
// indices of those of the first unsplit. Each unsplit frees 1 vertex, 1 wedge, 3 edges and 2 faces.
struct FreedSlots {
    std::size_t vertex = 0, wedge = 0, edge = 0, face = 0;
};

// The ids reserved for several splits. Every one has to be taken exactly once, by the split that
// uses it, before the allocation is destroyed or renewed: until then the mesh is incomplete. Debug
// builds check this.
class ConcurrentAllocation {
  public:
    ConcurrentAllocation() = default;
    ConcurrentAllocation(const ConcurrentAllocation&) = delete;
    ConcurrentAllocation& operator=(const ConcurrentAllocation&) = delete;
    ~ConcurrentAllocation() { assert(are_all_taken()); }

    // Makes space for the ids of `splits` splits, which TriMesh::allocate_splits() then writes.
    // Throws std::bad_alloc before anything changes.
    void resize(std::size_t splits) {
        assert(are_all_taken());
        ids_.resize(splits);
    }
    std::size_t size() const { return ids_.size(); }
    std::span<SplitIds> ids() { return ids_; }
    // Several threads may call this, each with numbers of its own.
    SplitIds take(std::size_t i) {
#ifndef NDEBUG
        assert(exists(ids_[i].m));
        return std::exchange(ids_[i], SplitIds{});
#else
        return ids_[i];
#endif
    }

  private:
#ifndef NDEBUG
    bool are_all_taken() const {
        for (const SplitIds& ids : ids_) {
            if (exists(ids.m)) return false;
        }
        return true;
    }
#endif

    std::vector<SplitIds> ids_;
};

}  // namespace pectin
