// The errors of faces (TriMesh::error) that a gesture has overwritten.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "mesh/array_bytes.h"
#include "mesh/growing_array.h"
#include "mesh/ids.h"
#include "mesh/mesh_change.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// A split hands the error of a face on to its pieces, so that taking it back changes nothing. What
// an unsplit or the end of the gesture overwrites is recorded here, in order. A face that did not
// exist when the gesture began may be recorded, too; it does not exist when errors are restored.
class ErrorLog {
  public:
    bool empty() const { return faces_.empty(); }
    void clear() noexcept {
        faces_.clear();
        errors_.clear();
    }

    // Makes room for so many records.
    void reserve(std::size_t count) {
        faces_.reserve_additional(count);
        errors_.reserve_additional(count);
    }
    // Precondition of these: reserve() has made room.
    void record(FaceId f, const ErrorEllipsoid& error) {
        faces_.push_back_unchecked(f);
        errors_.push_back_unchecked(error);
    }
    // Reserves records, which the caller sets, possibly on several threads; returns the index of
    // the first.
    std::size_t grow(std::size_t count) {
        const std::size_t first = faces_.size();
        faces_.grow_unchecked(count);
        errors_.grow_unchecked(count);
        return first;
    }
    void set(std::size_t i, FaceId f, const ErrorEllipsoid& error) {
        faces_[i] = f;
        errors_[i] = error;
    }

    // Restores the errors that there were at the beginning, once all edits have been taken back.
    void restore(TriMesh& mesh) const noexcept {
        for (std::size_t i = faces_.size(); i-- > 0;) {
            if (is_live(mesh, faces_[i])) mesh.set_error(faces_[i], errors_[i]);
        }
    }
    // Writes what has changed. edited: the slots that edits made, changed or freed.
    void describe(const TriMesh& mesh, std::span<const FaceId> edited, MeshChange& change) const {
        if (empty()) return;
        std::vector<std::size_t> first(faces_.size());
        for (std::size_t i = 0; i < first.size(); ++i) first[i] = i;
        std::stable_sort(first.begin(), first.end(),
                         [this](std::size_t x, std::size_t y) { return faces_[x] < faces_[y]; });
        const auto is_same = [this](std::size_t x, std::size_t y) {
            return faces_[x] == faces_[y];
        };
        first.erase(std::unique(first.begin(), first.end(), is_same), first.end());
        change.before.grow_faces(first.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            change.before.set(k, faces_[first[k]], errors_[first[k]]);
        }
        std::vector<FaceId> after(edited.begin(), edited.end());
        for (std::size_t i : first) after.push_back(faces_[i]);
        std::erase_if(after, [&](FaceId f) { return !is_live(mesh, f); });
        std::sort(after.begin(), after.end());
        after.erase(std::unique(after.begin(), after.end()), after.end());
        change.after.grow_faces(after.size());
        for (std::size_t k = 0; k < after.size(); ++k) {
            change.after.set(k, after[k], mesh.error(after[k]));
        }
    }

    std::size_t memory_bytes() const { return capacity_bytes(faces_) + capacity_bytes(errors_); }

  private:
    static bool is_live(const TriMesh& mesh, FaceId f) {
        return index(f) < mesh.face_slots() && mesh.is_live(f);
    }

    GrowingArray<FaceId> faces_;
    GrowingArray<ErrorEllipsoid> errors_;
};

}  // namespace pectin
