// The faces of a mesh by the base faces that they are pieces of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

// The live faces as they are when this is made, by base face, then by id: the order of a save.
class FacePieces {
  public:
    explicit FacePieces(const TriMesh& mesh);  // O(n)

    std::span<const FaceId> all() const { return faces_; }
    // Those of base faces first .. end - 1.
    std::span<const FaceId> of(std::uint32_t first, std::uint32_t end) const {
        return all().subspan(first_[first], first_[end] - first_[first]);
    }
    // Whether none of these base faces has been split.
    bool are_whole(std::uint32_t first, std::uint32_t end) const {
        return first_[end] - first_[first] == end - first;
    }

  private:
    std::vector<FaceId> faces_;
    std::vector<std::uint32_t> first_;  // n_base_faces + 1; into faces_
};

// The base faces and the outline of one input polygon after the other, in input order, also of
// those that have no faces.
class PolygonWalk {
  public:
    explicit PolygonWalk(const TriMesh& mesh) : mesh_(mesh) {}

    bool next();

    // Of the present polygon.
    std::uint32_t polygon() const { return polygon_; }
    std::uint32_t first_face() const { return first_face_; }  // base faces first .. end - 1
    std::uint32_t end_face() const { return end_face_; }
    bool has_outline() const { return has_outline_; }  // none: it is one triangle
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
