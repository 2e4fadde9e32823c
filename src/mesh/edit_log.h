// The edits of a gesture and the faces that they touched, for undo and for taking them back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/array_bytes.h"
#include "mesh/growing_array.h"
#include "mesh/mesh_change.h"
#include "mesh/tri_mesh.h"

namespace pectin {

class EditLog {
  public:
    static constexpr std::size_t kFacesPerSheet = 4;  // at most

    // `faces`: the active faces. `slots`: those of the mesh at the beginning.
    void begin(std::span<const FaceId> faces, const SlotCounts& slots) {
        slots_at_begin_ = slots;
        faces_.clear();
        faces_.append(faces);
        original_faces_ = faces_.size();
    }
    // Back to the state after begin().
    void clear() noexcept {
        edits_.clear();
        splits_ = 0;
        faces_.resize(original_faces_);
    }
    // Forgets the gesture.
    void end() noexcept {
        original_faces_ = 0;
        clear();
    }
    // Undoes all logged edits in the mesh, last first. Attributes are not restored. Allocates
    // nothing.
    void take_back(TriMesh& mesh) const noexcept {
        pectin::take_back(edits_, slots_at_begin_, mesh);
    }
    const SlotCounts& slots_at_begin() const { return slots_at_begin_; }
    std::span<const TopologyEdit> edits() const { return edits_; }
    std::uint64_t splits() const { return splits_; }
    std::uint64_t unsplits() const { return edits_.size() - splits_; }
    // The active faces at the beginning, then every slot that an edit made, changed or freed.
    std::span<const FaceId> faces() const { return faces_; }
    std::size_t original_faces() const { return original_faces_; }

    // Makes room for `count` splits of one sheet each; returns for how many there is room.
    std::size_t reserve_splits(std::size_t count) {
        reserve(count);
        return std::min(edits_.capacity() - edits_.size(),
                        (faces_.capacity() - faces_.size()) / kFacesPerSheet);
    }
    // TriMesh::prepare_splits() for the log.
    void prepare_splits(std::size_t count) {
        edits_.prepare(count);
        faces_.prepare(kFacesPerSheet * count);
    }
    // Makes room for edits of so many sheets in all.
    void reserve(std::size_t sheets) {
        edits_.reserve_additional(sheets);
        faces_.reserve_additional(kFacesPerSheet * sheets);
    }

    // --- Logging. Precondition: reserve() or reserve_splits() has made room.
    void log_split(EdgeId bc) {
        edits_.push_back_unchecked(TopologyEdit::split(bc));
        ++splits_;
    }
    void log_unsplit(EdgeId bc) { edits_.push_back_unchecked(TopologyEdit::unsplit(bc)); }
    void log_face(FaceId f) { faces_.push_back_unchecked(f); }

    // Reserves `count` edits, which the caller writes, possibly on several threads; returns the
    // index of the first. grow_faces() does the same with faces.
    std::size_t grow_splits(std::size_t count) {
        splits_ += count;
        return grow_unsplits(count);
    }
    std::size_t grow_unsplits(std::size_t count) {
        const std::size_t first = edits_.size();
        edits_.grow_unchecked(count);
        return first;
    }
    std::size_t grow_faces(std::size_t count) {
        const std::size_t first = faces_.size();
        faces_.grow_unchecked(count);
        return first;
    }
    void set_edit(std::size_t i, TopologyEdit edit) { edits_[i] = edit; }
    void set_face(std::size_t i, FaceId f) { faces_[i] = f; }

    std::size_t memory_bytes() const { return capacity_bytes(edits_) + capacity_bytes(faces_); }

  private:
    SlotCounts slots_at_begin_;
    GrowingArray<TopologyEdit> edits_;
    std::uint64_t splits_ = 0;
    GrowingArray<FaceId> faces_;
    std::size_t original_faces_ = 0;
};

}  // namespace pectin
