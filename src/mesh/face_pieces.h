// Groups the faces of a mesh by the base faces that they are pieces of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

// The live faces at the time of construction, ordered by base face, then by id. A save uses this
// order.
class FacePieces {
  public:
    explicit FacePieces(const TriMesh& mesh);  // O(n)

    std::span<const FaceId> all() const { return faces_; }
    // The pieces of the base faces first .. end - 1.
    std::span<const FaceId> of(std::uint32_t first, std::uint32_t end) const {
        return all().subspan(first_[first], first_[end] - first_[first]);
    }
    // Whether none of these base faces has been split.
    bool are_whole(std::uint32_t first, std::uint32_t end) const {
        return first_[end] - first_[first] == end - first;
    }

  private:
    std::vector<FaceId> faces_;
    std::vector<std::uint32_t> first_;  // n_base_faces + 1; index into faces_
};

// Iterates over the input polygons in input order, including those without faces, and gives the
// base faces and the outline of each.
class PolygonWalk {
  public:
    explicit PolygonWalk(const TriMesh& mesh) : mesh_(mesh) {}

    bool next();

    // The current polygon. Precondition: next() has returned true.
    std::uint32_t polygon() const { return polygon_; }
    std::uint32_t first_face() const { return first_face_; }  // base faces first .. end - 1
    std::uint32_t end_face() const { return end_face_; }
    bool has_outline() const { return has_outline_; }  // false if it is a single triangle
    std::span<const OutlineCorner> outline() const {
        return mesh_.input_form().corners(outline_end_ - 1);
    }
    std::uint32_t part() const { return part_; }

  private:
    const TriMesh& mesh_;
    std::uint32_t polygon_ = 0, part_ = 0;
    std::uint32_t first_face_ = 0, end_face_ = 0;
    std::uint32_t outline_end_ = 0;
    bool has_outline_ = false;
};

}  // namespace pectin
