// Polygons with shared positions, normals and texture coordinates: what files and shapes hand to
// build_mesh. Any topology is allowed here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

// What a run of faces belongs to; one entry for each distinct combination.
struct Part {
    std::string object;                 // OBJ `o`, empty if none
    std::string group;                  // OBJ `g`, names separated by one space, empty if none
    std::string material;               // OBJ `usemtl`, empty if none
    std::uint32_t smoothing_group = 0;  // OBJ `s`; 0 is off

    bool operator==(const Part&) const = default;
};

struct IndexedFaceSet {
    static constexpr std::uint32_t kNoIndex = 0xffffffffu;

    struct Corner {
        std::uint32_t position = 0;       // < positions.size()
        std::uint32_t normal = kNoIndex;  // < normals.size(), or kNoIndex
        std::uint32_t uv = kNoIndex;      // < uvs.size(), or kNoIndex
    };

    // Lines and points (OBJ `l` and `p`). They carry no surface and are kept as they are.
    struct Element {
        enum class Kind : std::uint8_t { line, points };
        Kind kind = Kind::line;
        std::uint32_t before_polygon = 0;  // stands ahead of this polygon in the input
        std::uint32_t part = 0;            // index into parts
        std::uint32_t corners_end = 0;     // into element_corners; begins where the one before ends
        bool operator==(const Element&) const = default;
    };

    std::vector<Vec3> positions;
    std::vector<Vec3f> colors;   // n_positions, or empty; NaN where a vertex has none
    std::vector<Vec3f> normals;  // unit, or zero where undefined
    std::vector<Vec2f> uvs;
    std::vector<Corner> corners;                  // of all polygons, one after the other
    std::vector<std::uint32_t> polygon_end;       // n_polygons; polygon p has the corners
                                                  // [polygon_end[p - 1], polygon_end[p]), also
                                                  // fewer than three
    std::vector<std::uint32_t> polygon_part;      // n_polygons; index into parts
    std::vector<Part> parts;                      // at least one where there are polygons
    std::vector<Element> elements;                // in input order
    std::vector<Corner> element_corners;          // of all elements, one after the other
    std::vector<std::string> material_libraries;  // OBJ `mtllib`, as read

    std::uint32_t polygon_begin(std::size_t polygon) const {
        return polygon == 0 ? 0 : polygon_end[polygon - 1];
    }
    std::size_t polygon_count() const { return polygon_end.size(); }
};

}  // namespace pectin
