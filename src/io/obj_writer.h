// Writes meshes as Wavefront OBJ files.
#pragma once

#include <string>

#include "io/progress.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// The mesh as the text of an OBJ file, in this order:
// - The material libraries.
// - All v, with colours if the mesh has any: base vertices in input order, then inserted ones by
// id.
// - All vt and vn. Each value is written once, in the order in which the faces first use it.
// Corners
//   without a UV refer to none. If a normal is zero or undefined, its corners get the normal of
//   their face, or none if the face has no area; files contain no zero normals.
// - The polygons in input order. A polygon without split faces has its original corners, even if it
//   spans no surface. Other polygons are written as triangles, by base face, then id. Lines and
//   points keep their places between the polygons.
//
// o, g, usemtl and s are written where they change. A bare o, g or usemtl resets the name, as it
// did in the input; s off ends a smoothing group.
//
// All numbers are the shortest decimals that read back the same. The bytes depend only on the mesh.
// Cost: O(n), and O(n) memory besides the text.
std::string format_obj(const TriMesh& mesh);

// Writes this text to a file, completely or not at all (AtomicFile). Throws FileError, Cancelled.
void write_obj(const TriMesh& mesh, const std::string& path, const Progress& progress = {});

}  // namespace pectin
