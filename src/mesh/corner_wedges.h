// Wedges for the corners of a mesh under construction, with normals where the input has none.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/build_mesh.h"

namespace pectin {

inline constexpr Vec2f kNoUv{std::numeric_limits<float>::quiet_NaN()};

struct CornerWedges {
    std::vector<WedgeId> of_half_edge;  // 3 n_faces
    std::vector<Vec3f> normals;         // n_wedges
    std::vector<Vec2f> uvs;             // n_wedges, or empty where the input has none
};

// Corners at one vertex share a wedge if their normals and texture coordinates are the same; wedges
// lie in memory as their vertices do. A corner's normal is the input's where it has one, else the
// mean of the faces round the vertex, weighted by corner angle (Thürmer & Wüthrich 1998), over
// those joined to it across smooth edges. An edge is smooth if it lies inside a polygon, if its
// faces share a smoothing group (other than 0), or, where the input has no smoothing groups, turn
// by at most options.crease_angle. `mesh`: faces, twins and positions are set. `corner_of`: 3
// n_faces, into input.corners. Cost: O(n log n) at worst, O(n) where no vertex has many corners.
CornerWedges corner_wedges(const TriMesh& mesh, const IndexedFaceSet& input,
                           std::span<const std::uint32_t> corner_of, const BuildOptions& options);

}  // namespace pectin
