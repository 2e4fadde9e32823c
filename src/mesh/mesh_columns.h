// The arrays of a TriMesh: one list of columns for each kind of element.
//
// Sizes, equality, memory, growth, clearing, copies and bake.cpp all go through these lists, so a
// new attribute is one member and one line here.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/error_ellipsoid.h"
#include "geometry/vec.h"
#include "mesh/growing_array.h"
#include "mesh/ids.h"
#include "mesh/slot_table.h"

namespace pectin {

// One side of an edge, seen from the face on that side.
struct HalfEdge {
    VertexId origin = kNone<VertexId>;
    HalfEdgeId twin = kNone<HalfEdgeId>;  // none on a boundary
    WedgeId wedge = kNone<WedgeId>;       // of the face's corner at `origin`
    EdgeId edge = kNone<EdgeId>;

    bool operator==(const HalfEdge&) const = default;
};

// Numbers of slots, both in use and free.
struct SlotCounts {
    std::uint32_t vertices = 0, wedges = 0, edges = 0, faces = 0;
    bool operator==(const SlotCounts&) const = default;
};

struct VertexColumns {
    using Id = VertexId;

    GrowingArray<Vec3> positions;         // world
    GrowingArray<HalfEdgeId> half_edges;  // an outgoing one, none at an isolated base vertex
    GrowingArray<std::uint16_t> levels;
    GrowingArray<std::uint8_t> deformed;  // 0 or 1
    GrowingArray<Vec3f> colors;           // empty where the mesh has none

    std::size_t size() const { return positions.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<Vec3>{Vec3{0.0}}, columns.positions...);
        visit(Column<HalfEdgeId>{kNone<HalfEdgeId>}, columns.half_edges...);
        visit(Column<std::uint16_t>{0}, columns.levels...);
        visit(Column<std::uint8_t>{0}, columns.deformed...);
        visit(Column<Vec3f>{.cleared = Vec3f{0.0f}, .is_optional = true}, columns.colors...);
    }
};

struct WedgeColumns {
    using Id = WedgeId;

    GrowingArray<Vec3f> normals;  // unit, or 0 where undefined
    GrowingArray<Vec2f> uvs;      // empty where the mesh has none

    std::size_t size() const { return normals.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<Vec3f>{Vec3f{0.0f}}, columns.normals...);
        visit(Column<Vec2f>{.cleared = Vec2f{0.0f}, .is_optional = true}, columns.uvs...);
    }
};

struct EdgeColumns {
    using Id = EdgeId;

    GrowingArray<HalfEdgeId> half_edges;  // one of the one or two
    GrowingArray<std::uint16_t> levels;
    GrowingArray<EdgeId> siblings;  // see TriMesh::sibling(); empty where nothing is cut

    std::size_t size() const { return half_edges.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<HalfEdgeId>{kNone<HalfEdgeId>}, columns.half_edges...);
        visit(Column<std::uint16_t>{0}, columns.levels...);
        visit(Column<OwnId>{.cleared = {}, .is_optional = true}, columns.siblings...);
    }
};

struct FaceColumns {
    using Id = FaceId;

    GrowingArray<HalfEdge> half_edges;    // three per face, counter-clockwise
    GrowingArray<FaceId> bases;           // the base face that the face is a piece of
    GrowingArray<ErrorEllipsoid> errors;  // see TriMesh::error(); empty where none was set

    std::size_t size() const { return bases.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<HalfEdge>{.cleared = {}, .per_slot = 3}, columns.half_edges...);
        visit(Column<FaceId>{kNone<FaceId>}, columns.bases...);
        visit(Column<ErrorEllipsoid>{.cleared = {}, .is_optional = true, .may_be_left_out = true},
              columns.errors...);
    }
};

}  // namespace pectin
