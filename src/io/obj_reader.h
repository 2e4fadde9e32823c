// Reads Wavefront OBJ files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/progress.h"
#include "io/read_report.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// Limits that keep ids within 32 bits.
struct ObjLimits {
    // Of the text. Texts up to this size have fewer than 2^31 elements, polygons and corners.
    std::size_t bytes = std::size_t{4} << 30;
    // Into which the polygons are triangulated. Each has three half-edges, of which a mesh has
    // fewer than 2^31.
    std::uint32_t triangles = 0x7fffffffu / 3;
};

// Reads the statements v, vn, vt, f, l, p, o, g, usemtl, s and mtllib and ignores all others. It
// also ignores f, l and p without corners and a third coordinate of vt. Positions are the doubles
// nearest to the text; texture coordinates and colours are the nearest floats; normals become unit.
// Relative indices and indices of elements that come later in the file are resolved. Faces of one
// or two corners and faces with repeated vertices are kept as written.
//
// Three or more numbers after the coordinates of v are a colour (r g b; further ones, such as
// alpha, are ignored). One number is w, which is ignored. Two numbers have no meaning and are
// ignored. Vertices without a colour get the one in ZBrush's #MRGB comments (ObjPolypaint).
//
// Texture coordinates, normals and colours are optional. A corner loses an attribute if the file
// does not have it, if it has numbers that are not finite, or if the normal is zero. The report
// counts these corners and names the first line.
//
// An o, g, usemtl or s holds until the next of the same kind; without a name it resets the name.
// Material libraries are not read, so names of unknown materials are kept. Parts are listed in the
// order of their first faces, lines or points.
//
// report: receives what was dropped and which axis is up, if not null; unchanged if the function
// throws.
//
// Throws FileError as read_whole_file() does; with the line if a position is malformed, missing or
// not finite, or its index is malformed, 0 or out of range; and for a text that has no faces or is
// beyond the limits. Throws Cancelled.
// Cost: O(n). Memory: at most a small multiple of the size of the text, which is freed on return.
IndexedFaceSet read_obj(const std::string& path, const Progress& progress = {},
                        ReadReport* report = nullptr);

// Reads the text of an OBJ file. name: used as the path in messages.
IndexedFaceSet parse_obj(std::string_view text, const std::string& name,
                         const Progress& progress = {}, const ObjLimits& limits = {},
                         ReadReport* report = nullptr);

}  // namespace pectin
