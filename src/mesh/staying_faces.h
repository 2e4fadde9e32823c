// The faces in the zone of a gesture that it does not move, and all pieces of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/array_bytes.h"
#include "mesh/growing_array.h"
#include "mesh/ids.h"

namespace pectin {

// A drag of a connected part leaves other faces in its zone where they are. Longest-edge
// propagation from the part may reach them from outside the zone and split them.
class StayingFaces {
  public:
    // `faces`: live. `slots`: all face slots of the mesh. Cost: O(faces); the first time, and when
    // the mesh has grown, O(mesh).
    void begin(std::span<const FaceId> faces, std::uint32_t slots) {
        faces_.clear();
        faces_.append(faces);
        if (faces_.empty()) return;
        if (marks_.size() < slots) marks_.resize(slots);
        mark(faces_, 1);
    }
    // Returns to the state after begin(). `edited`: every slot that an edit made, changed or freed.
    void restore(std::span<const FaceId> edited) noexcept {
        if (faces_.empty()) return;
        mark(edited, 0);
        mark(faces_, 1);
    }
    void end(std::span<const FaceId> edited) noexcept {
        if (faces_.empty()) return;
        mark(edited, 0);
        mark(faces_, 0);
        faces_.clear();
    }
    // Forgets everything, also if begin() has thrown.
    void abandon() noexcept {
        faces_.clear();
        marks_.clear();
    }

    bool empty() const { return faces_.empty(); }
    bool contains(FaceId f) const { return !faces_.empty() && marks_[index(f)] != 0; }
    // Makes room for the faces of a mesh with so many slots. Throws std::bad_alloc.
    void fit(std::size_t slots) {
        if (!faces_.empty() && marks_.size() < slots) marks_.resize(slots);
    }
    // `piece` is a new face that a split has cut from `whole`. Calls for different pieces may run
    // concurrently. Precondition: fit() has made room.
    void record_piece(FaceId whole, FaceId piece) {
        if (!faces_.empty()) marks_[index(piece)] = marks_[index(whole)];
    }

    std::size_t memory_bytes() const { return capacity_bytes(faces_) + capacity_bytes(marks_); }

  private:
    void mark(std::span<const FaceId> faces, std::uint8_t value) noexcept {
        for (FaceId f : faces) {
            if (index(f) < marks_.size()) marks_[index(f)] = value;
        }
    }

    GrowingArray<FaceId> faces_;  // at the beginning
    GrowingArray<std::uint8_t> marks_;
};

}  // namespace pectin
