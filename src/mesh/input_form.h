// What a save needs, besides the triangles, to write the surface as the input had it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/vec.h"
#include "mesh/ids.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// A corner without a triangle: of a polygon without surface, of a line or of points.
struct LooseCorner {
    VertexId vertex = kNone<VertexId>;
    Vec2f uv{0.0f};      // NaN if it has none
    Vec3f normal{0.0f};  // unit, or 0 where undefined
};

// A corner of a polygon: either a corner of a base face that has not been split, or a loose one.
class OutlineCorner {
  public:
    static OutlineCorner of(HalfEdgeId h) { return OutlineCorner{index(h)}; }
    static OutlineCorner loose(std::uint32_t i) { return OutlineCorner{i | kLoose}; }

    bool is_loose() const { return (bits_ & kLoose) != 0; }
    HalfEdgeId half_edge() const { return HalfEdgeId{bits_}; }
    std::uint32_t loose_index() const {
        return bits_ & ~kLoose;
    }  // index into InputForm::loose_corners
    bool operator==(const OutlineCorner&) const = default;

  private:
    static constexpr std::uint32_t kLoose = 0x80000000u;  // half-edges of base faces are below this
    explicit OutlineCorner(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

// Seams where faces of the input meet without sharing vertices: open edges whose ends coincide with
// those of other edges, open or not. The mesh joins them, so that both sides move and are refined
// together: its faces use only one of the vertices that coincide, the representative. A save writes
// separate vertices for each side again (UnsharedVertices).
struct UnsharedSeams {
    std::vector<VertexId> representatives;  // n_base_vertices, or empty without seams
    std::vector<VertexId> corner_vertices;  // 3 n_base_faces, or empty; the vertices of the input
    std::vector<EdgeId> edges;              // base edges along seams, ascending

    bool is_empty() const { return representatives.empty(); }
    bool operator==(const UnsharedSeams&) const = default;
    std::size_t memory_bytes() const;
};

// Sculpting does not change any of this.
struct InputForm {
    std::vector<Part> parts;
    std::vector<std::string> material_libraries;

    // A polygon other than a single triangle. Outlines are in input order.
    struct Outline {
        std::uint32_t polygon = 0;        // of the input, ascending
        std::uint32_t part = 0;           // index into parts
        std::uint32_t corners_begin = 0;  // index into outline_corners
        bool operator==(const Outline&) const = default;
    };
    std::vector<Outline> outlines;
    std::vector<OutlineCorner> outline_corners;

    // Lines and points, in input order.
    using Element = IndexedFaceSet::Element;
    std::vector<Element> elements;
    std::vector<LooseCorner> element_corners;

    std::vector<LooseCorner> loose_corners;

    UnsharedSeams seams;

    std::span<const OutlineCorner> corners(std::size_t outline) const {
        const std::size_t begin = outlines[outline].corners_begin;
        const std::size_t end = outline + 1 < outlines.size() ? outlines[outline + 1].corners_begin
                                                              : outline_corners.size();
        return std::span(outline_corners).subspan(begin, end - begin);
    }
    std::span<const LooseCorner> corners(const Element& element) const {
        const std::size_t begin = &element == elements.data() ? 0 : (&element)[-1].corners_end;
        return std::span(element_corners).subspan(begin, element.corners_end - begin);
    }

    bool operator==(const InputForm&) const;
    std::size_t memory_bytes() const;
};

}  // namespace pectin
