// Meshes to Wavefront OBJ.
#pragma once

#include <string>

#include "io/progress.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// The mesh as OBJ. First its material libraries, then all `v` (with colours where it has any): base
// vertices in input order, then the inserted ones by id. Then `vt` (where there are any) and `vn`,
// each value once, in the order in which the faces first use them; a corner without a UV
// refers to none. Where normals cancel out or vanish a corner gets that of its face, and where the
// face has no area none: files hold no zero normals. Then the polygons in input order: those none
// of whose faces is split with the corners that they had, also if these span no surface; of others
// the pieces, by base face, then id. Lines and points stand between the polygons as they did.
//
// o, g, usemtl and s stand where they change. Going back to none is a bare o, g or usemtl, which
// is how such a file must have said it, and s off.
//
// All numbers are the shortest that read back the same; the bytes depend on the mesh alone.
// Cost: O(n), O(n) memory besides the text.
std::string format_obj(const TriMesh& mesh);

// Writes that to the file, whole or not at all (AtomicFile). Throws FileError, Cancelled.
void write_obj(const TriMesh& mesh, const std::string& path, const Progress& progress = {});

}  // namespace pectin
