// Assigns wedges to the corners of a mesh under construction, and computes missing normals.
// Source: G. Thürmer, C. A. Wüthrich. Computing Vertex Normals from Polygonal Facets. Journal of
// Graphics Tools 3 (1998).
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

// Corners at one vertex share a wedge if their normals and texture coordinates are the same. Wedges
// are ordered by vertex. A corner's normal is that of the input if it has one. Otherwise it is the
// mean of the normals of the faces around the vertex that are connected to the corner's face across
// smooth edges, weighted by corner angle (Thürmer & Wüthrich 1998). An edge is smooth if it lies
// inside a polygon; if its faces share a smoothing group other than 0; or, where the input has no
// smoothing groups, if its faces' normals differ by at most options.crease_angle. `mesh`: faces,
// twins and positions are set. `corner_of`: 3 n_faces, index into input.corners.
// Cost: O(n log n) at worst, O(n) if no vertex has many corners.
CornerWedges corner_wedges(const TriMesh& mesh, const IndexedFaceSet& input,
                           std::span<const std::uint32_t> corner_of, const BuildOptions& options);

}  // namespace pectin
