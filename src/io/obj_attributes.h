// Texture coordinates and normals of OBJ files, and what becomes of those that mean nothing.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "geometry/vec.h"
#include "io/read_report.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// The unit float normal in the direction of n, or 0. What is unit already, as floats can be,
// stays as it was read: a file that is read and written again keeps its numbers.
Vec3f unit_normal(const std::array<double, 3>& n);

// Stands for a texture coordinate that is not made of finite numbers. A normal that is not is 0.
inline const Vec2f kUndefinedUv{std::numeric_limits<float>::quiet_NaN()};

// The lines of the first `vt` and `vn` that are undefined, and of the first corners that name a
// texture coordinate and a normal which the file does not have. 0 where there is none.
struct AttributeLines {
    std::size_t undefined_uv = 0, undefined_normal = 0;
    std::size_t missing_uv = 0, missing_normal = 0;
};

// Takes texture coordinates and normals that are missing or undefined away from all corners that
// name them, and reports them. Cost: O(corners) where a line is not 0, else O(1).
void drop_attributes(IndexedFaceSet& faces, const AttributeLines& lines, ReadReport& report);

}  // namespace pectin
