// Builds a TriMesh from the polygons of a file or a shape.
#pragma once

#include <cstdint>

#include "geometry/stop_token.h"
#include "mesh/build_report.h"
#include "mesh/indexed_face_set.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct BuildOptions {
    // In degrees. Corners without a normal share one across edges whose faces' normals differ by
    // at most this much. Not used if the input has smoothing groups.
    double crease_angle = 45.0;
};

struct BuiltMesh {
    TriMesh mesh;
    BuildReport report;
};

// Positions become base vertices, and triangles base faces, in input order. Corners at one vertex
// with the same normal and texture coordinate share a wedge. Two half-edges that run in opposite
// directions are twins. Edges with more than two faces, or with two faces that disagree on the
// direction, are cut: their half-edges become boundaries, and their edges siblings. Where the ends
// of a boundary edge coincide with those of other edges without being shared, they are joined at
// the vertex with the lowest index (UnsharedSeams), and the edges become twins or siblings by the
// same rule. InputForm keeps the corners of polygons, and also polygons without surface, lines and
// points. Precondition: indices in range, positions finite, fewer than 2^31 corners of triangles.
// Throws Stopped where `stop` asks for it, which it does between its steps.
// Cost: O(n log n) at worst, O(n) if no vertex has many faces.
BuiltMesh build_mesh(IndexedFaceSet input, const BuildOptions& options = {},
                     const StopToken& stop = {});

}  // namespace pectin
