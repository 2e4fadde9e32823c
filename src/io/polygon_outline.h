// The polygons that base faces were cut from.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

// Finds the polygon of neighbouring base faces; keeps its scratch memory from one to the next.
class PolygonOutline {
  public:
    explicit PolygonOutline(const TriMesh& mesh) : mesh_(mesh) {}

    // The half-edges round base faces first .. last, in order, such that build_mesh makes these
    // very faces of the polygon they describe; empty where there is no such polygon. Valid until
    // the next call.
    // Precondition: the faces have not been split. Cost: O(n log n), and triangulate's.
    std::span<const HalfEdgeId> find(FaceId first, FaceId last);

  private:
    void collect_border(FaceId first, FaceId last);
    bool chain_border();
    bool becomes(FaceId first, FaceId last);

    const TriMesh& mesh_;
    std::vector<HalfEdgeId> border_;   // sorted by origin
    std::vector<HalfEdgeId> outline_;  // in order
    std::vector<Vec3> corners_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace pectin
