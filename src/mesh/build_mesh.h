// From polygons as a file or a shape has them to a TriMesh.
#pragma once

#include <cstdint>

#include "mesh/build_report.h"
#include "mesh/indexed_face_set.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct BuildOptions {
    // Corners without a normal get one: smooth by corner angle across edges whose faces turn by
    // at most this much, in degrees. Not used where smoothing groups say what is smooth.
    double crease_angle = 45.0;
};

struct BuiltMesh {
    TriMesh mesh;
    BuildReport report;
};

// Positions become base vertices in input order, triangles base faces in input order. Corners
// at one vertex whose normal and texture coordinate are the same share a wedge. Two half-edges
// that run in opposite directions are twins; edges with more faces, or with two that disagree on
// direction, are cut: their half-edges become boundaries and siblings. Where the ends of a boundary
// edge coincide with those of other edges without being shared, they are joined at the vertex with
// the lowest index (UnsharedSeams), and the edges are then twins or siblings in the same way.
// Polygons keep their corners in InputForm; those without surface, lines and points are there
// alone. Precondition: indices in range, positions finite, fewer than 2^31 corners of triangles.
// Cost: O(n log n) at worst, O(n) where no vertex has many faces.
BuiltMesh build_mesh(IndexedFaceSet input, const BuildOptions& options = {});

}  // namespace pectin
