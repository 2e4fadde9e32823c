// From polygons as a file or a shape has them to a TriMesh.
#pragma once

#include <cstdint>

#include "mesh/indexed_face_set.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct BuildOptions {
    // Corners without a normal get one: smooth by corner angle across edges whose faces turn by
    // at most this much, in degrees. Not used where smoothing groups say what is smooth.
    double crease_angle = 45.0;
};

// What had to be done to make triangles and manifold sheets of the input.
struct BuildReport {
    std::uint32_t triangulated_polygons = 0;  // polygons with more than three corners
    std::uint32_t skipped_polygons = 0;       // fewer than three different vertices
    std::uint32_t cut_edges = 0;  // more than two faces, or two that disagree on direction
    std::uint32_t isolated_vertices = 0;
};

struct BuiltMesh {
    TriMesh mesh;
    BuildReport report;
};

// Positions become base vertices in input order, triangles base faces in input order. Corners
// at one vertex whose normal and texture coordinate are the same share a wedge.
// Precondition: indices in range, positions finite. Cost: O(n), and
// quadratic in the wedges of one vertex.
BuiltMesh build_mesh(const IndexedFaceSet& input, const BuildOptions& options = {});

}  // namespace pectin
