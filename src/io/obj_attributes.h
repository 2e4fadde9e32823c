// Normalises the normals of OBJ files and drops missing and undefined attributes.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "geometry/vec.h"
#include "io/read_report.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// The unit normal in the direction of n, or 0 if n is 0. A normal that is already unit within float
// precision is unchanged, so that a file that is read and written again keeps its numbers.
Vec3f unit_normal(const std::array<double, 3>& n);

// Marks a texture coordinate that has numbers that are not finite. Such a normal is 0.
inline const Vec2f kUndefinedUv{std::numeric_limits<float>::quiet_NaN()};

// The lines of the first undefined `vt` and `vn`, and of the first corners whose texture coordinate
// or normal the file does not have. Counted from 1; 0 if there is none.
struct AttributeLines {
    std::size_t undefined_uv = 0, undefined_normal = 0;
    std::size_t missing_uv = 0, missing_normal = 0;
};

// Removes missing and undefined texture coordinates and normals from all corners that refer to
// them, and reports them. Cost: O(corners) if one of the lines is not 0, else O(1).
void drop_attributes(IndexedFaceSet& faces, const AttributeLines& lines, ReadReport& report);

}  // namespace pectin
