// Wavefront OBJ files to polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/progress.h"
#include "io/read_report.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// What the 32-bit ids of a mesh can tell apart.
struct ObjLimits {
    // Shorter texts have fewer than 2^31 elements, polygons and corners, each of them.
    std::size_t bytes = std::size_t{4} << 30;
    // That polygons can be cut into: three half-edges each, of which there are less than 2^31.
    std::uint32_t triangles = 0x7fffffffu / 3;
};

// Reads v, vn, vt, f, l, p, o, g, usemtl, s and mtllib; other statements are ignored, and so are
// f, l and p without corners and a third coordinate of `vt`. Positions are the doubles, texture
// coordinates and colours the floats nearest to the text; normals are made unit. Relative indices
// and indices of what comes later in the file are followed. Faces of one or two corners and faces
// with repeated vertices are polygons as they are written.
//
// What follows the three coordinates of `v` is a colour from three numbers on (r g b; more, such as
// alpha, are ignored); one number is w, which is ignored, and so are two, which mean nothing.
// Vertices without a colour get that of ZBrush's #MRGB comments (ObjPolypaint).
//
// A face can do without texture coordinates, normals and colours. Corners that name one that the
// file does not have, or that is not made of finite numbers, or a normal that is zero, have none;
// the report says how many and where.
//
// o, g, usemtl and s hold until the next of the same kind, alone until a bare one takes the name
// away; names are kept whatever the material libraries say, which are not read. Parts are listed
// in the order of their first faces, lines or points.
//
// report: what was dropped; it is not changed where this throws.
//
// Throws FileError: read_whole_file's; with the line for a position that is malformed, missing or
// not finite, and for its index where that is malformed, 0 or out of range; for a text without
// faces or beyond the limits. Throws Cancelled.
// Cost: O(n). Memory: a small multiple of the text's size, whatever it says; the text itself is
// gone on return.
IndexedFaceSet read_obj(const std::string& path, const Progress& progress = {},
                        ReadReport* report = nullptr);

// The same from memory; `name` stands for the path in messages.
IndexedFaceSet parse_obj(std::string_view text, const std::string& name,
                         const Progress& progress = {}, const ObjLimits& limits = {},
                         ReadReport* report = nullptr);

}  // namespace pectin
