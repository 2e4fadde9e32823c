#include "io/obj_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pectin {
namespace {

using Corner = IndexedFaceSet::Corner;
constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;

void drop_uv(Corner& corner, const IndexedFaceSet& faces, const AttributeLines& lines,
             ReadReport& report) {
    if (corner.uv == kNoIndex) return;
    if (corner.uv >= faces.uvs.size()) {
        report.missing_uvs.add(lines.missing_uv);
    } else if (std::isnan(faces.uvs[corner.uv].x)) {
        report.undefined_uvs.add(lines.undefined_uv);
    } else {
        return;
    }
    corner.uv = kNoIndex;
}

void drop_normal(Corner& corner, const IndexedFaceSet& faces, const AttributeLines& lines,
                 ReadReport& report) {
    if (corner.normal == kNoIndex) return;
    if (corner.normal >= faces.normals.size()) {
        report.missing_normals.add(lines.missing_normal);
    } else if (faces.normals[corner.normal] == Vec3f{0.0f}) {
        report.undefined_normals.add(lines.undefined_normal);
    } else {
        return;
    }
    corner.normal = kNoIndex;
}

}  // namespace

Vec3f unit_normal(const std::array<double, 3>& n) {
    const Vec3 direction{n[0], n[1], n[2]};
    const Vec3f as_read(direction);
    constexpr double kUnitTolerance = 1e-6;  // of the squared length; a few float roundings
    if (std::abs(glm::dot(Vec3(as_read), Vec3(as_read)) - 1.0) < kUnitTolerance) return as_read;

    const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
    if (largest == 0.0) return Vec3f{0.0f};
    const Vec3 scaled = direction / largest;  // so that the square neither overflows nor underflows
    return Vec3f(scaled / glm::length(scaled));
}

void drop_attributes(IndexedFaceSet& faces, const AttributeLines& lines, ReadReport& report) {
    if (lines.undefined_uv == 0 && lines.undefined_normal == 0 && lines.missing_uv == 0 &&
        lines.missing_normal == 0) {
        return;
    }
    for (std::vector<Corner>* corners : {&faces.corners, &faces.element_corners}) {
        for (Corner& corner : *corners) {
            drop_uv(corner, faces, lines, report);
            drop_normal(corner, faces, lines, report);
        }
    }
    for (Vec2f& uv : faces.uvs) {
        if (std::isnan(uv.x)) uv = Vec2f{0.0f};  // no corner refers to it any more
    }
}

}  // namespace pectin
