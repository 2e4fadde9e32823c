// Wavefront OBJ files to polygons.
#pragma once

#include <string>
#include <string_view>

#include "mesh/indexed_face_set.h"

namespace pectin {

// Reads v, vn, vt, f, o, g, usemtl, s and mtllib; other statements are ignored, as are a fourth
// coordinate and colours of `v` and a third coordinate of `vt`. Positions are the doubles,
// texture coordinates the floats nearest to the text; normals are made unit. Relative indices
// and indices of what comes later in the file are followed; faces of fewer than three corners
// carry no surface and are left out.
//
// o, g, usemtl and s hold until the next of the same kind, alone until a bare one takes the name
// away; names are kept whatever the material libraries say, which are not read. Parts are listed
// in the order of their first faces.
//
// Throws FileError: read_whole_file's; with the line for a malformed or missing number, one that
// is not finite, an index that is malformed, 0 or out of range; a text without faces or over 4 GB.
// Cost: O(n), a small multiple of the text in memory.
IndexedFaceSet read_obj(const std::string& path);

// The same from memory; `name` stands for the path in messages.
IndexedFaceSet parse_obj(std::string_view text, const std::string& name);

}  // namespace pectin
