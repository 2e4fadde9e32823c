// The shapes the program can make by itself, about the origin, +y up.
#pragma once

#include <cstdint>

#include "mesh/indexed_face_set.h"

namespace pectin {

enum class ShapeKind { sphere, cube, plane, torus, cylinder };

// The largest resolution of each kind: all stay below six million triangles.
int max_resolution(ShapeKind kind);

// Precondition: 0 <= resolution <= max_resolution(kind), and at least 1 for all but the sphere.
//  sphere    radius 1, icosphere of 20 * 4^resolution triangles; from resolution 1 on +-x, +-y
//            and +-z are among its vertices
//  cube      side 2, resolution x resolution quads a side, vertices shared, normals by side
//  plane     side 2 in y = 0, facing +y, resolution x resolution quads
//  torus     about y, radii 1 and 0.4, 4 resolution quads round the axis, 2 resolution round
//            the tube (resolution 1 is raised to 2)
//  cylinder  about y, radius 1, height 2, 4 resolution quads round, resolution up, caps of
//            resolution rings about their centre
IndexedFaceSet make_shape(ShapeKind kind, int resolution);

}  // namespace pectin
