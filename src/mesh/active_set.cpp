#include "mesh/active_set.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "mesh/array_bytes.h"
#include "mesh/sort_ids.h"

namespace pectin {

void ActiveSet::begin(std::span<const FaceId> faces, const Box& zone,
                      std::span<const FaceId> staying) {
    assert(!begun_);
    begun_ = true;
    split_capacity_ = 0;
    log_.begin(faces, mesh_.slot_counts());
    rest_.begin(faces, zone);
    staying_.begin(staying, mesh_.face_slots());
}

void ActiveSet::roll_back() noexcept {
    log_.take_back(mesh_);
    assert(mesh_.slot_counts() == log_.slots_at_begin());
    rest_.restore(mesh_);
    staying_.restore(edited_faces());
    log_.clear();
}

void ActiveSet::cancel() noexcept {
    roll_back();
    forget();
}

void ActiveSet::abandon() noexcept {
    rest_.abandon();
    staying_.abandon();
    log_.end();
    begun_ = false;
}

MeshChange ActiveSet::finish() {
    MeshChange change;
    change.slots_before = log_.slots_at_begin();
    rest_.record(change);
    change.edits.assign(log_.edits().begin(), log_.edits().end());
    for (std::size_t i = 0; i < faces().size(); ++i) {
        const FaceId f = faces()[i];
        if (i >= log_.original_faces() || rest_.has_changed(f)) change.faces.push_back(f);
    }
    sort_ids(std::span(change.faces));
    change.faces.erase(std::unique(change.faces.begin(), change.faces.end()), change.faces.end());
    change.faces.shrink_to_fit();
    forget();
    return change;
}

void ActiveSet::forget() noexcept {
    rest_.end();
    staying_.end(edited_faces());
    log_.end();
    begun_ = false;
}

std::size_t ActiveSet::memory_bytes() const {
    return rest_.memory_bytes() + log_.memory_bytes() + staying_.memory_bytes() +
           capacity_bytes(scratch_);
}

}  // namespace pectin
