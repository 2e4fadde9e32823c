// A triangle mesh whose edges split at their midpoint and whose splits undo exactly.
//
// Half-edges live in fixed slots of their face: face f has the half-edges 3f, 3f+1, 3f+2, in
// order round the face, counter-clockwise seen from outside. Positions belong to vertices;
// normals and texture coordinates belong to wedges (a vertex as one face corner sees it).
//
// Invariants (validate() checks exactly these):
//  1. A dead slot is cleared and stands once in its free list; every other slot is live.
//  2. A live face has three live, pairwise different vertices.
//  3. Twins are mutual, run in opposite directions and share their edge; no twin is a boundary.
//  4. A live edge's half-edge is live and carries the edge; it has one or two half-edges.
//  5. A live vertex that has a face names an outgoing half-edge of its own; only base vertices
//     may be without.
//  6. All corners of a wedge are at one vertex.
//  7. Base vertices and faces come first: ids below base_vertex_count() have level 0, ids from
//     there on a level above 0. Base faces stay live: splits cut them, but keep their slots.
//  8. Every position, colour and texture coordinate that was given is finite; normals are unit or
//     zero.
//  9. The half-edge of an inserted vertex m that unsplit would accept is m->c, in the face that
//     m's split made; where m lies on a cut, of the sheet whose bm has the lowest id.
// 10. Siblings are boundary edges with the same two ends, and their rings are closed.
// 11. Of the vertices that an unshared seam has joined only the representative has faces.
//
// Non-manifold input is cut into sheets by build_mesh: the edges along a cut are boundaries and
// siblings. Sheets share the vertices along it; siblings split and unsplit about one midpoint.
//
// Source: Gain & Dodgson 1999, section 4 and figure 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec.h"
#include "mesh/growing_array.h"
#include "mesh/ids.h"
#include "mesh/input_form.h"
#include "mesh/split.h"

namespace pectin {

struct HalfEdge {
    VertexId origin = kNone<VertexId>;
    HalfEdgeId twin = kNone<HalfEdgeId>;  // none on a boundary
    WedgeId wedge = kNone<WedgeId>;       // the corner at `origin`
    EdgeId edge = kNone<EdgeId>;

    bool operator==(const HalfEdge&) const = default;
};

// Slots in use or free; a mesh cut back to these has the slots it had then.
struct SlotCounts {
    std::uint32_t vertices = 0, wedges = 0, edges = 0, faces = 0;
    bool operator==(const SlotCounts&) const = default;
};

struct Baked;

class TriMesh {
  public:
    // --- Slots. Loops run over [0, *_slots()) and skip what is not live.
    std::uint32_t vertex_slots() const { return static_cast<std::uint32_t>(positions_.size()); }
    std::uint32_t wedge_slots() const { return static_cast<std::uint32_t>(normals_.size()); }
    std::uint32_t edge_slots() const { return static_cast<std::uint32_t>(edge_half_edges_.size()); }
    std::uint32_t face_slots() const { return static_cast<std::uint32_t>(face_bases_.size()); }
    SlotCounts slot_counts() const {
        return {vertex_slots(), wedge_slots(), edge_slots(), face_slots()};
    }
    std::uint32_t vertex_count() const;  // live ones
    std::uint32_t edge_count() const;
    std::uint32_t face_count() const;
    std::uint32_t base_vertex_count() const { return base_vertices_; }
    std::uint32_t base_face_count() const { return static_cast<std::uint32_t>(base_faces_.size()); }

    bool is_live(VertexId v) const {
        return index(v) < base_vertices_ || exists(vertex_half_edges_[index(v)]);
    }
    bool is_live(EdgeId e) const { return exists(edge_half_edges_[index(e)]); }
    bool is_live(FaceId f) const { return exists(half_edges_[3 * index(f)].origin); }
    bool is_base(VertexId v) const { return index(v) < base_vertices_; }

    // --- Connectivity. O(1).
    const HalfEdge& half_edge(HalfEdgeId h) const { return half_edges_[index(h)]; }
    VertexId origin(HalfEdgeId h) const { return half_edges_[index(h)].origin; }
    VertexId target(HalfEdgeId h) const { return origin(next(h)); }
    HalfEdgeId twin(HalfEdgeId h) const { return half_edges_[index(h)].twin; }
    WedgeId wedge(HalfEdgeId h) const { return half_edges_[index(h)].wedge; }
    EdgeId edge(HalfEdgeId h) const { return half_edges_[index(h)].edge; }
    static HalfEdgeId next(HalfEdgeId h) {
        const std::uint32_t i = index(h);
        return HalfEdgeId{i % 3 == 2 ? i - 2 : i + 1};
    }
    static HalfEdgeId prev(HalfEdgeId h) {
        const std::uint32_t i = index(h);
        return HalfEdgeId{i % 3 == 0 ? i + 2 : i - 1};
    }
    static FaceId face(HalfEdgeId h) { return FaceId{index(h) / 3}; }
    static HalfEdgeId half_edge(FaceId f, int corner) {
        return HalfEdgeId{3 * index(f) + static_cast<std::uint32_t>(corner)};
    }
    HalfEdgeId half_edge(EdgeId e) const { return edge_half_edges_[index(e)]; }
    // The next of the edges that lie along e where a cut parts their sheets; e itself where none.
    EdgeId sibling(EdgeId e) const { return siblings_.empty() ? e : siblings_[index(e)]; }
    // Of e and its siblings the one with the lowest id. Cost: O(siblings).
    EdgeId representative(EdgeId e) const;
    // visit(HalfEdgeId): e's one or two half-edges, then its siblings' (each has one).
    template <typename Visit>
    void for_each_side(EdgeId e, Visit visit) const {
        const HalfEdgeId h = half_edge(e);
        visit(h);
        if (exists(twin(h))) {
            visit(twin(h));
        } else {
            for (EdgeId s = sibling(e); s != e; s = sibling(s)) visit(half_edge(s));
        }
    }
    // An outgoing half-edge; none for an isolated base vertex.
    HalfEdgeId half_edge(VertexId v) const { return vertex_half_edges_[index(v)]; }

    // --- Attributes. O(1). Writing them changes no connectivity.
    const Vec3& position(VertexId v) const { return positions_[index(v)]; }
    void set_position(VertexId v, const Vec3& p) { positions_[index(v)] = p; }
    // Slots from `first` on, to write many at once.
    std::span<Vec3> positions(VertexId first, std::size_t count) {
        return std::span(positions_).subspan(index(first), count);
    }
    std::span<std::uint8_t> deformed_marks(VertexId first, std::size_t count) {  // 0 or 1
        return std::span(deformed_).subspan(index(first), count);
    }
    std::span<Vec3f> normals(WedgeId first, std::size_t count) {
        return std::span(normals_).subspan(index(first), count);
    }
    const Vec3f& normal(WedgeId w) const { return normals_[index(w)]; }  // unit, or 0: undefined
    void set_normal(WedgeId w, const Vec3f& n) { normals_[index(w)] = n; }
    bool has_colors() const { return !colors_.empty(); }
    const Vec3f& color(VertexId v) const { return colors_[index(v)]; }  // NaN where it has none
    bool has_uvs() const { return !uvs_.empty(); }
    const Vec2f& uv(WedgeId w) const { return uvs_[index(w)]; }  // NaN where a corner has none
    // Whether a committed gesture has ever moved it; midpoints inherit it from either end.
    bool is_deformed(VertexId v) const { return deformed_[index(v)] != 0; }
    void set_deformed(VertexId v, bool deformed) { deformed_[index(v)] = deformed ? 1 : 0; }
    std::uint16_t level(VertexId v) const { return vertex_levels_[index(v)]; }
    std::uint16_t level(EdgeId e) const { return edge_levels_[index(e)]; }

    // The base face that f is a piece of; f itself where it is a base face.
    FaceId base_face(FaceId f) const { return face_bases_[index(f)]; }
    const Part& part(FaceId f) const { return form_.parts[part_index(f)]; }
    std::uint32_t part_index(FaceId f) const { return base_faces_[index(base_face(f))].part; }
    std::uint32_t polygon(FaceId f) const { return base_faces_[index(base_face(f))].polygon; }
    const InputForm& input_form() const { return form_; }

    double squared_length(EdgeId e) const {
        const HalfEdgeId h = half_edge(e);
        const Vec3 along = position(target(h)) - position(origin(h));
        return glm::dot(along, along);
    }
    double length(EdgeId e) const { return glm::sqrt(squared_length(e)); }
    Box bounding_box() const;  // of the live vertices that have faces; O(n)
    // (b - a) x (c - a) of a face's corners, or of the given points: twice the area long.
    Vec3 area_normal(FaceId f) const;

    // --- Edits. O(1), touching the one or two faces at the edge; along a cut O(sheets).
    //
    //          a                    a
    //         / \                  /|\.
    //        /   \     split      / | \.
    //       b-----c   ------->   b--m--c
    //        \   /    unsplit     \ | /
    //         \ /     <------      \|/
    //          d                    d
    //
    // The midpoint gets the mean of its ends' positions and colours and, per wedge on each side,
    // the mean of their texture coordinates and the normalised sum of their normals (with the face
    // normal added where that sum is shorter than 0.1). Its level, and that of am and dm, is one
    // above the highest of a, b, c, d; bm and cm keep bc's. e's siblings are split with it, about
    // the same midpoint. Precondition: may_split(e).
    Split split(EdgeId e);
    // The same, but leaves the midpoint's position and normals 0 for the caller to set.
    Split insert_midpoint(EdgeId e);
    // Room for `count` splits of edges with one or two sides, so that these move no array.
    void reserve_splits(std::uint32_t count);
    // Whether the level of the midpoint would still fit in 16 bits.
    bool may_split(EdgeId e) const;
    // Whether it would for any edge, also after `count` splits. O(1); false says little.
    bool has_levels_for(std::uint32_t count) const;

    // --- Splits on several threads. allocate_splits takes what so many splits of smooth edges
    // would, or throws std::bad_alloc and has changed nothing; the mesh is whole again when
    // insert_midpoint has been called once with each.
    // Two such calls may run at the same time if no corner of the one's faces is one of the
    // other's; then all comes out as if they went one after another, in the order of their ids.
    // Preconditions: may_split(e), is_smooth(e).
    void allocate_splits(std::span<SplitIds> splits);
    Split insert_midpoint(EdgeId e, const SplitIds& ids);
    // Whether e has two sides that share the corners at both ends.
    bool is_smooth(EdgeId e) const;
    // The inverse, likewise. What it returns is free when free_split has had it, which may be
    // called at the same time, too: once with each of those that allocate_freed has taken places
    // for, whose order counts. Precondition: as unsplit's, and bm and mc are smooth.
    SplitIds remove_midpoint(const Star& star);
    FreedSlots allocate_freed(std::size_t splits);
    void free_split(const SplitIds& ids, const FreedSlots& first, std::size_t i);
    // Room for what so many unsplits of one sheet free, so that none of all this throws.
    void reserve_unsplits(std::size_t count);

    // m's surroundings, if it may go: not a base vertex, exactly four edges (three on a
    // boundary, as many in each sheet along a cut), and all neighbours at its level or lower.
    std::optional<Star> removable(VertexId m) const;
    // visit(const Star&): m's surroundings in each sheet along a cut, star's own first. They share
    // m and its two neighbours along the cut, each in its own direction. Precondition: star is what
    // removable(m) says.
    template <typename Visit>
    void for_each_sheet(const Star& star, Visit visit) const {
        visit(star);
        if (!star.on_boundary()) return;
        const EdgeId first = edge(star.mc);
        for (EdgeId e = sibling(first); e != first; e = sibling(e)) visit(*sheet(star.m, e));
    }
    // visit(const Split&): what a split has just made in each sheet along a cut, its
    // representative's first.
    template <typename Visit>
    void for_each_sheet(const Split& representative, Visit visit) const {
        visit(representative);
        if (sibling(representative.mc) == representative.mc) return;
        for (EdgeId e = sibling(representative.mc); e != representative.mc; e = sibling(e)) {
            visit(split_of(*sheet(representative.m, e)));
        }
    }
    // The exact inverse of the split that made star.m: same ids, same bytes. Returns bc, the
    // representative of its siblings. Precondition: star is what removable(m) says.
    EdgeId unsplit(const Star& star);
    // While one exists, unsplit() removes the slots that splits had added beyond `counts`, instead
    // of adding them to the free lists. So edits that are taken back last first leave the mesh as
    // it was, and nothing is allocated: the free lists were as long before.
    class RollbackScope {
      public:
        RollbackScope(TriMesh& mesh, const SlotCounts& counts) : mesh_(mesh) {
            mesh_.kept_slots_ = counts;
        }
        ~RollbackScope() { mesh_.kept_slots_ = kAllSlots; }
        RollbackScope(const RollbackScope&) = delete;
        RollbackScope& operator=(const RollbackScope&) = delete;

      private:
        TriMesh& mesh_;
    };
    // Cuts the slots back to `counts` where all edits made since then have been undone in
    // reverse order: the slots they had added are then free, below all others in the free lists.
    void shrink(const SlotCounts& counts);

    // The same surface with all that splits have inserted made base (bake.cpp). O(n).
    Baked baked() const;

    // Every violated invariant in one line each, empty if all hold. O(n).
    std::vector<std::string> validate() const;

    // Same slots, same bytes, same free lists.
    bool operator==(const TriMesh&) const;
    std::size_t memory_bytes() const;

  private:
    friend class MeshBuilder;
    friend class MeshBaker;
    class Validator;

    struct BaseFace {
        std::uint32_t part = 0;     // into form_.parts
        std::uint32_t polygon = 0;  // of the input
        bool operator==(const BaseFace&) const = default;
    };

    // How many two-sided splits find all arrays large enough, at least. The arrays of a copy are as
    // large as they have to be.
    struct SplitCapacity {
        std::uint32_t splits = 0;
        SplitCapacity() = default;
        SplitCapacity(const SplitCapacity&) {}
        SplitCapacity& operator=(const SplitCapacity&) {
            splits = 0;
            return *this;
        }
        SplitCapacity(SplitCapacity&& other) noexcept : splits(std::exchange(other.splits, 0)) {}
        SplitCapacity& operator=(SplitCapacity&& other) noexcept {
            splits = std::exchange(other.splits, 0);
            return *this;
        }
    };

    VertexId allocate_vertex();
    WedgeId allocate_wedge();
    EdgeId allocate_edge();
    FaceId allocate_face();
    SplitIds allocate_split();
    bool has_free_slots() const;
    bool has_slots_for_split(EdgeId e);
    static bool removes(std::uint32_t slot, std::uint32_t slots, std::uint32_t kept,
                        std::size_t free);
    void clear(VertexId v);
    void clear(WedgeId w);
    void clear(EdgeId e);
    void clear(FaceId f);
    void release(VertexId v);
    void release(WedgeId w);
    void release(EdgeId e);
    void release(FaceId f);

    void move_half_edge(HalfEdgeId from, HalfEdgeId to);
    void link(HalfEdgeId h, HalfEdgeId twin);
    void reserve_for_split(EdgeId e);
    void reserve_for_sides(std::size_t sides);
    // visit(array of slots)
    template <typename Visit>
    void for_each_array_of_vertices(Visit visit);
    template <typename Visit>
    void for_each_array_of_wedges(Visit visit);
    template <typename Visit>
    void for_each_array_of_edges(Visit visit);
    template <typename Visit>
    void for_each_array_of_splits(Visit visit);
    Split insert_into_sheet(EdgeId e, VertexId m);
    Split before_split(EdgeId e) const;
    void describe_midpoint(EdgeId e, VertexId m);
    void describe_edge(EdgeId e, std::uint16_t level);
    void describe_wedge(const Split::Side& side);
    void record_level(std::uint16_t level);
    void connect(const Split& split);
    void connect_left(const Split& split);
    void connect_right(const Split& split);
    void insert_into_siblings(const Split& representative);
    std::uint16_t highest_level_around(EdgeId e) const;
    std::optional<Star> star_from(HalfEdgeId mc) const;
    std::optional<Star> sheet(VertexId m, EdgeId along_cut) const;
    Split split_of(const Star& star) const;
    EdgeId unsplit_sheet(const Star& star);
    SplitIds ids_of(const Star& star) const;
    void disconnect_left(const Star& star, const SplitIds& ids);
    void disconnect_right(const Star& star, const SplitIds& ids);
    void unsplit_siblings(const Star& representative);

    GrowingArray<Vec3> positions_;                // n_vertex_slots, world
    GrowingArray<HalfEdgeId> vertex_half_edges_;  // n_vertex_slots
    GrowingArray<std::uint16_t> vertex_levels_;   // n_vertex_slots
    GrowingArray<std::uint8_t> deformed_;         // n_vertex_slots
    GrowingArray<Vec3f> colors_;                  // n_vertex_slots, or empty
    GrowingArray<Vec3f> normals_;                 // n_wedge_slots
    GrowingArray<Vec2f> uvs_;                     // n_wedge_slots, or empty
    GrowingArray<HalfEdgeId> edge_half_edges_;    // n_edge_slots
    GrowingArray<std::uint16_t> edge_levels_;     // n_edge_slots
    GrowingArray<EdgeId> siblings_;               // n_edge_slots, or empty where nothing is cut
    GrowingArray<HalfEdge> half_edges_;           // 3 n_face_slots
    GrowingArray<FaceId> face_bases_;             // n_face_slots
    std::vector<BaseFace> base_faces_;            // n_base_faces
    InputForm form_;
    std::uint32_t base_vertices_ = 0;

    std::uint16_t highest_level_ = 0;  // that any vertex has had, at least; not what makes it equal

    GrowingArray<VertexId> free_vertices_;
    GrowingArray<WedgeId> free_wedges_;
    GrowingArray<EdgeId> free_edges_;
    GrowingArray<FaceId> free_faces_;
    SplitCapacity split_capacity_;
    static constexpr std::uint32_t kAll = 0xffffffffu;
    static constexpr SlotCounts kAllSlots{kAll, kAll, kAll, kAll};
    SlotCounts kept_slots_ = kAllSlots;  // see RollbackScope
    // Scratch of unsplit_siblings(). A split makes it large enough, so that undoing it allocates
    // nothing.
    std::vector<Star> sheets_;
};

// A mesh of which everything is base: vertices in the order that a save would give them, faces too,
// wedges and edges by id. Polygons of which no face was split stay polygons, every piece of the
// others is one of its own. What has been deformed stays marked so.
struct Baked {
    TriMesh mesh;
    std::vector<EdgeId>
        edges;  // n_edge_slots of the mesh it was made from: what they became, or none
};

template <typename Visit>
void TriMesh::for_each_array_of_vertices(Visit visit) {
    visit(positions_);
    visit(vertex_half_edges_);
    visit(vertex_levels_);
    visit(deformed_);
    if (has_colors()) visit(colors_);
}

template <typename Visit>
void TriMesh::for_each_array_of_wedges(Visit visit) {
    visit(normals_);
    if (has_uvs()) visit(uvs_);
}

template <typename Visit>
void TriMesh::for_each_array_of_edges(Visit visit) {
    visit(edge_half_edges_);
    visit(edge_levels_);
    if (!siblings_.empty()) visit(siblings_);
}

// Gives half-edge `from` the slot `to`; whatever names it follows. Its origin, wedge and edge go
// along, its own face is the caller's business.
inline void TriMesh::move_half_edge(HalfEdgeId from, HalfEdgeId to) {
    HalfEdge& moved = half_edges_[index(to)];
    moved = half_edges_[index(from)];
    if (exists(moved.twin)) half_edges_[index(moved.twin)].twin = to;
    HalfEdgeId& of_vertex = vertex_half_edges_[index(moved.origin)];
    if (of_vertex == from) of_vertex = to;
    HalfEdgeId& of_edge = edge_half_edges_[index(moved.edge)];
    if (of_edge == from) of_edge = to;
}

inline void TriMesh::link(HalfEdgeId h, HalfEdgeId twin) {
    half_edges_[index(h)].twin = twin;
    half_edges_[index(twin)].twin = h;
}

}  // namespace pectin
