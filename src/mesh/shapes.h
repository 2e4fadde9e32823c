// The shapes that the program can create, centred on the origin, with +y up.
#pragma once

#include <cstdint>

#include "mesh/indexed_face_set.h"

namespace pectin {

enum class ShapeKind { sphere, cube, plane, torus, cylinder };

// The largest resolution of each kind. All have fewer than six million triangles.
int max_resolution(ShapeKind kind);

// Precondition: 0 <= resolution <= max_resolution(kind), and at least 1 for all but the sphere.
//  sphere    radius 1, icosphere of 20 * 4^resolution triangles; its vertices include +-x,
//            +-y and +-z from resolution 1 on
//  cube      side 2, resolution x resolution quads per side, shared vertices, one normal per side
//  plane     side 2 in y = 0, facing +y, resolution x resolution quads
//  torus     around y, radii 1 and 0.4, 4 resolution quads around the axis, 2 resolution around
//            the tube (resolution 1 is raised to 2)
//  cylinder  around y, radius 1, height 2, 4 resolution quads around, resolution along the axis,
//            caps of resolution rings
IndexedFaceSet make_shape(ShapeKind kind, int resolution);

}  // namespace pectin
