#include "mesh/active_set.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "geometry/two_groups.h"
#include "mesh/array_bytes.h"
#include "mesh/sort_ids.h"

namespace pectin {

void ActiveSet::begin(std::span<const FaceId> faces, const Box& zone,
                      std::span<const FaceId> staying) {
    assert(!begun_);
    begun_ = true;
    ++roll_backs_;
    split_capacity_ = 0;
    log_.begin(faces, mesh_.slot_counts());
    rest_.begin(faces, zone);
    staying_.begin(staying, mesh_.face_slots());
}

void ActiveSet::roll_back() noexcept {
    ++roll_backs_;
    if (log_.edits().empty() && errors_.empty()) return rest_.restore_attributes(mesh_);
    log_.take_back(mesh_);
    assert(mesh_.slot_counts() == log_.slots_at_begin());
    rest_.restore(mesh_);
    errors_.restore(mesh_);
    errors_.clear();
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
    errors_.clear();
    log_.end();
    begun_ = false;
}

MeshChange ActiveSet::finish() {
    MeshChange change;
    change.slots_before = log_.slots_at_begin();
    rest_.record(change);
    errors_.describe(mesh_, edited_faces(), change);
    change.edits.assign(log_.edits().begin(), log_.edits().end());
    change.faces = changed_faces();
    forget();
    return change;
}

std::vector<FaceId> ActiveSet::changed_faces() const {
    const TwoGroups changed(static_cast<std::uint32_t>(faces().size()), [&](std::uint32_t i) {
        const bool is_edited = i >= log_.original_faces();
        return is_edited || rest_.has_changed(faces()[i]) ? Group::first : Group::none;
    });
    std::vector<FaceId> result(changed.size());
    changed.for_each([&](std::uint32_t i, std::uint32_t number) { result[number] = faces()[i]; });
    if (log_.edits().empty()) return result;
    sort_ids(std::span(result));
    result.erase(std::unique(result.begin(), result.end()), result.end());
    result.shrink_to_fit();
    return result;
}

void ActiveSet::forget() noexcept {
    rest_.end();
    errors_.clear();
    staying_.end(edited_faces());
    log_.end();
    begun_ = false;
}

std::size_t ActiveSet::memory_bytes() const {
    return rest_.memory_bytes() + log_.memory_bytes() + staying_.memory_bytes() +
           errors_.memory_bytes() + capacity_bytes(scratch_);
}

}  // namespace pectin
