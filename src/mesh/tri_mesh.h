// A triangle mesh whose edges split at their midpoint and whose splits can be undone exactly.
//
// Half-edges occupy fixed slots of their face: face f has the half-edges 3f, 3f+1 and 3f+2, in
// counter-clockwise order seen from outside. Positions belong to vertices; normals and texture
// coordinates belong to wedges. A wedge is a vertex as a face corner sees it. The corners at a
// vertex between which the surface is smooth share one wedge; along a crease or a UV seam the
// corners on its two sides have different ones.
//
// Non-manifold input is cut into sheets by build_mesh. The edges along a cut are boundary edges of
// their sheets, and they are siblings of each other: they have the same two ends, since the sheets
// share the vertices along the cut. Siblings split and unsplit together, about one midpoint. The
// sibling with the lowest id is their representative.
//
// Invariants (validate() checks exactly these; invariant 12 only while every edge may be split):
//  1. A dead slot is cleared and is listed once in its free list; every other slot is live.
//  2. A live face has three live, pairwise different vertices.
//  3. Twins are mutual, run in opposite directions and share their edge; no twin is a boundary.
//  4. A live edge's half-edge is live and carries the edge; it has one or two half-edges.
//  5. A live vertex that has a face names an outgoing half-edge of its own; only base vertices
//     may have no face.
//  6. All corners of a wedge are at one vertex.
//  7. Base vertices and faces come first: ids below base_vertex_count() have level 0, ids from
//     there on a level above 0. Base faces stay live: a split keeps the slot of the face it halves.
//  8. Every position, colour and texture coordinate that was given is finite; normals are unit or
//     zero.
//  9. The half-edge of an inserted vertex m that unsplit() would accept is m->c, in the face that
//     m's split made; where m lies on a cut, in the sheet whose bm has the lowest id.
// 10. Siblings are boundary edges with the same two ends, and their rings are closed.
// 11. Of the vertices that an unshared seam has joined only the representative has faces.
// 12. The free lists are stacks: unsplit() adds the slots of a split in the reverse of the order in
//     which the split took them (drawn in split.cpp), so the next split of the same edge gets the
//     same ids. Undo and redo need this: they repeat edits by the id of their edge alone and write
//     attributes by id, and unsplit() is the exact inverse of split() only if it restores the lists
//     as well. The order cannot be read off the lists; validate() unsplits and splits every
//     removable vertex of a copy and compares the ids and the lists.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999, section 4 and figure 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/error_ellipsoid.h"
#include "geometry/vec.h"
#include "mesh/concurrent_allocation.h"
#include "mesh/growing_array.h"
#include "mesh/ids.h"
#include "mesh/input_form.h"
#include "mesh/mesh_columns.h"
#include "mesh/slot_table.h"
#include "mesh/stencil.h"

namespace pectin {

class TriMesh {
  public:
    // --- Slots. Loops run over [0, *_slots()) and skip slots that are not live.
    std::uint32_t vertex_slots() const { return vertices_.slots(); }
    std::uint32_t wedge_slots() const { return wedges_.slots(); }
    std::uint32_t edge_slots() const { return edges_.slots(); }
    std::uint32_t face_slots() const { return faces_.slots(); }
    SlotCounts slot_counts() const {
        return {vertex_slots(), wedge_slots(), edge_slots(), face_slots()};
    }
    // Live elements.
    std::uint32_t vertex_count() const { return live_count(vertices_); }
    std::uint32_t edge_count() const { return live_count(edges_); }
    std::uint32_t face_count() const { return live_count(faces_); }
    std::uint32_t base_vertex_count() const { return base_vertices_; }
    std::uint32_t base_face_count() const { return static_cast<std::uint32_t>(base_faces_.size()); }

    bool is_live(VertexId v) const { return is_base(v) || exists(half_edge(v)); }
    bool is_live(EdgeId e) const { return exists(half_edge(e)); }
    bool is_live(FaceId f) const { return exists(origin(half_edge(f, 0))); }
    bool is_base(VertexId v) const { return index(v) < base_vertices_; }

    // --- Connectivity. O(1). half_edge() gives a record by its id, or an id by face, edge, vertex.
    const HalfEdge& half_edge(HalfEdgeId h) const { return faces_.half_edges[index(h)]; }
    VertexId origin(HalfEdgeId h) const { return half_edge(h).origin; }
    VertexId target(HalfEdgeId h) const { return origin(next(h)); }
    HalfEdgeId twin(HalfEdgeId h) const { return half_edge(h).twin; }
    WedgeId wedge(HalfEdgeId h) const { return half_edge(h).wedge; }
    EdgeId edge(HalfEdgeId h) const { return half_edge(h).edge; }
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
    HalfEdgeId half_edge(EdgeId e) const { return edges_.half_edges[index(e)]; }
    // An outgoing half-edge; none for an isolated base vertex.
    HalfEdgeId half_edge(VertexId v) const { return vertices_.half_edges[index(v)]; }
    // The next edge in the ring of e's siblings; e itself where it has none.
    EdgeId sibling(EdgeId e) const {
        return edges_.siblings.empty() ? e : edges_.siblings[index(e)];
    }
    // The one with the lowest id among e and its siblings. Cost: O(siblings).
    EdgeId representative(EdgeId e) const;
    // visit(HalfEdgeId): e's one or two half-edges, then those of its siblings, one each.
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
    // Whether e has two sides and they share the wedges at both ends: no crease, UV seam or
    // boundary. (ActiveSet::smooth_edges counts boundaries as smooth, too.)
    bool is_smooth(EdgeId e) const;

    // --- Attributes. O(1). Writing them changes no connectivity.
    const Vec3& position(VertexId v) const { return vertices_.positions[index(v)]; }
    void set_position(VertexId v, const Vec3& p) { vertices_.positions[index(v)] = p; }
    // The slots from `first` on, for writing many at once.
    std::span<Vec3> positions(VertexId first, std::size_t count) {
        return std::span(vertices_.positions).subspan(index(first), count);
    }
    std::span<std::uint8_t> deformed_marks(VertexId first, std::size_t count) {  // 0 or 1
        return std::span(vertices_.deformed).subspan(index(first), count);
    }
    std::span<Vec3f> normals(WedgeId first, std::size_t count) {
        return std::span(wedges_.normals).subspan(index(first), count);
    }
    const Vec3f& normal(WedgeId w) const { return wedges_.normals[index(w)]; }  // 0 if undefined
    void set_normal(WedgeId w, const Vec3f& n) { wedges_.normals[index(w)] = n; }
    bool has_colors() const { return !vertices_.colors.empty(); }
    const Vec3f& color(VertexId v) const { return vertices_.colors[index(v)]; }  // NaN if none
    bool has_uvs() const { return !wedges_.uvs.empty(); }
    const Vec2f& uv(WedgeId w) const { return wedges_.uvs[index(w)]; }  // NaN if none
    // Whether a committed gesture has ever moved v; a midpoint is deformed if one of its ends is.
    bool is_deformed(VertexId v) const { return vertices_.deformed[index(v)] != 0; }
    void set_deformed(VertexId v, bool deformed) {
        vertices_.deformed[index(v)] = deformed ? 1 : 0;
    }
    std::uint16_t level(VertexId v) const { return vertices_.levels[index(v)]; }
    std::uint16_t level(EdgeId e) const { return edges_.levels[index(e)]; }

    // Contains the vectors from the points of f to those of the exact surface, to which the
    // deformations so far have taken the original one (adapt/triggers/certified_error.h). Zero
    // where none was set. The pieces of a face inherit its error.
    ErrorEllipsoid error(FaceId f) const {
        return tracks_errors() ? faces_.errors[index(f)] : ErrorEllipsoid{};
    }
    bool tracks_errors() const { return !faces_.errors.empty(); }
    // Makes room for errors, which are 0. Throws std::bad_alloc before anything changes. O(faces).
    void track_errors() {
        if (tracks_errors()) return;
        faces_.errors.resize(face_slots());
        split_capacity_.splits = 0;
    }
    // Precondition: tracks_errors(). Safe to call concurrently for different faces.
    void set_error(FaceId f, const ErrorEllipsoid& error) { faces_.errors[index(f)] = error; }

    // The base face that f is a piece of; f itself if it is a base face.
    FaceId base_face(FaceId f) const { return faces_.bases[index(f)]; }
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
    // (b - a) x (c - a) of a face's corners. Its length is twice the area.
    Vec3 area_normal(FaceId f) const;

    // --- Edits. O(1): they touch the one or two faces at the edge; along a cut O(sheets).
    //
    //          a                    a
    //         / \                  /|\.
    //        /   \     split      / | \.
    //       b-----c   ------->   b--m--c
    //        \   /    unsplit     \ | /
    //         \ /     <------      \|/
    //          d                    d
    //
    // Splits e and its siblings at their midpoint m. The position and the colour of m are the means
    // of those of b and c. A smooth edge gets one wedge at m; on a crease or a UV seam each side
    // gets its own, and on a boundary there is one side. Each new wedge has the mean of the texture
    // coordinates and the normalised sum of the normals of its side's two ends (plus the face
    // normal where that sum is shorter than 0.1). The level of m, am and dm is one above the
    // highest level of a, b, c and d; bm and mc keep that of bc. Precondition: may_split(e).
    Split split(EdgeId e);
    // Splits e, but leaves the position and the normals of m 0 for the caller to set.
    Split insert_midpoint(EdgeId e);
    // Makes room for `count` splits of edges outside cuts, so that these move no array.
    void reserve_splits(std::uint32_t count);
    // Takes memory from the system for as many splits of smooth edges, which would otherwise wait
    // for it.
    void prepare_splits(std::size_t count);
    // Whether the level of the midpoint fits in 16 bits.
    bool may_split(EdgeId e) const;
    // A sufficient condition for may_split() of all edges during the next `count` splits. O(1).
    bool has_levels_for(std::uint32_t count) const {
        return highest_level_ + std::size_t{count} < kMaxLevel;
    }

    // The surroundings of m if unsplit() accepts it: m is not a base vertex, it has exactly four
    // edges (three on a boundary or in each sheet along a cut), and the levels of its neighbours
    // are not higher than its own.
    std::optional<Star> removable(VertexId m) const;
    // The exact inverse of the split that inserted star.m: same ids, same bytes. Returns bc, the
    // representative of its siblings. Precondition: removable(m) has returned `star`.
    EdgeId unsplit(const Star& star);
    // visit(const Star&): m's surroundings in each sheet along a cut, `star` first. The sheets
    // share m and its two neighbours along the cut; b and c may be exchanged between sheets.
    // Precondition: removable(m) has returned `star`.
    template <typename Visit>
    void for_each_sheet(const Star& star, Visit visit) const {
        visit(star);
        if (!star.on_boundary()) return;
        const EdgeId first = edge(star.mc);
        for (EdgeId e = sibling(first); e != first; e = sibling(e)) visit(*sheet(star.m, e));
    }
    // visit(const Split&): what a split has just made in each sheet along a cut, that of the
    // representative first.
    template <typename Visit>
    void for_each_sheet(const Split& representative, Visit visit) const {
        visit(representative);
        const EdgeId first = representative.mc;
        for (EdgeId e = sibling(first); e != first; e = sibling(e)) {
            visit(split_of(*sheet(representative.m, e)));
        }
    }
    // While one exists, unsplit() removes a slot beyond `counts`, instead of adding it to the free
    // list, if it is the last one and no other of its kind is free. If the edits made since the
    // mesh had `counts` slots are taken back, last first, it ends with the same slots and the same
    // free lists as then, and nothing is allocated.
    class RollbackScope {
      public:
        RollbackScope(TriMesh& mesh, const SlotCounts& counts) : mesh_(mesh) {
            mesh_.set_kept_slots(counts);
        }
        ~RollbackScope() { mesh_.set_kept_slots(kAllSlots); }
        RollbackScope(const RollbackScope&) = delete;
        RollbackScope& operator=(const RollbackScope&) = delete;

      private:
        TriMesh& mesh_;
    };

    // --- Edits on several threads (concurrent_allocation.h). Two of them may run at the same time
    // if their stencils share no vertex.
    //
    // Reserves the slots of splits.size() splits of smooth edges. Throws std::bad_alloc before
    // anything changes. The mesh is incomplete until insert_midpoint() has been called with each.
    void allocate_splits(std::span<SplitIds> splits);
    // Preconditions: may_split(e), is_smooth(e).
    Split insert_midpoint(EdgeId e, const SplitIds& ids);
    // Undoes the split that inserted star.m. The returned ids stay allocated until they are passed
    // to free_split(), exactly once each. Preconditions: those of unsplit(); bm and mc are smooth.
    SplitIds remove_midpoint(const Star& star);
    // Reserves entries in the free lists for the slots of `splits` splits, in the order of the
    // calls. Does not throw after reserve_unsplits() of as many.
    FreedSlots allocate_freed(std::size_t splits);
    // Writes the slots of the i-th split that `first` has been reserved for. May run concurrently
    // with itself and with remove_midpoint().
    void free_split(const SplitIds& ids, const FreedSlots& first, std::size_t i);
    // Makes room in the free lists for `count` unsplits outside cuts.
    void reserve_unsplits(std::size_t count);

    // The same surface with all that splits have inserted made base (bake.cpp). Vertices and faces
    // are in the order in which a save would write them, wedges and edges are ordered by id. A
    // polygon of which no face was split stays a polygon; each piece of any other is a polygon of
    // its own. Deformed vertices stay marked. O(n).
    TriMesh baked() const;

    // One line for each violated invariant; empty if all hold. O(n).
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

    // A lower bound on the number of two-sided splits for which all arrays have room. A copy has
    // none, since its arrays have no spare capacity.
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

    template <typename Table>
    static std::uint32_t live_count(const Table& table) {
        return table.slots() - static_cast<std::uint32_t>(table.free_slots().size());
    }
    void set_kept_slots(const SlotCounts& counts);

    // reserve.cpp, concurrent_allocation.cpp
    void reserve_for_split(EdgeId e);
    void reserve_for_sides(std::size_t sides);
    bool has_slots_for_split(EdgeId e);
    bool has_free_slots() const;
    SplitIds allocate_split();

    // split.cpp
    Split insert_into_sheet(EdgeId e, VertexId m);
    Split before_split(EdgeId e) const;
    void describe_midpoint(EdgeId e, VertexId m);
    void describe_edge(EdgeId e, std::uint16_t level);
    void describe_wedge(const Split::Side& side);
    void record_level(std::uint16_t level);
    void connect(const Split& split);
    void connect_left(const Split& split);
    void connect_right(const Split& split);
    void move_half_edge(HalfEdgeId from, HalfEdgeId to);
    void link(HalfEdgeId h, HalfEdgeId twin);
    std::uint16_t highest_level_around(EdgeId e) const;

    // unsplit.cpp
    std::optional<Star> star_from(HalfEdgeId mc) const;
    EdgeId unsplit_sheet(const Star& star);
    SplitIds ids_of(const Star& star) const;
    void disconnect_left(const Star& star, const SplitIds& ids);
    void disconnect_right(const Star& star, const SplitIds& ids);

    // siblings.cpp
    void insert_into_siblings(const Split& representative);
    void unsplit_siblings(const Star& representative);
    std::optional<Star> sheet(VertexId m, EdgeId along_cut) const;
    Split split_of(const Star& star) const;

    static constexpr std::uint16_t kMaxLevel = 0xffff;
    static constexpr SlotCounts kAllSlots{0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu};

    SlotTable<VertexColumns> vertices_;
    SlotTable<WedgeColumns> wedges_;
    SlotTable<EdgeColumns> edges_;
    SlotTable<FaceColumns> faces_;
    std::vector<BaseFace> base_faces_;  // n_base_faces
    InputForm form_;
    std::uint32_t base_vertices_ = 0;
    std::uint16_t highest_level_ = 0;  // upper bound of all vertex levels; not part of equality
    SplitCapacity split_capacity_;
    // Scratch of unsplit_siblings(). A split makes it large enough, so that undoing the split
    // allocates nothing.
    std::vector<Star> sheets_;
};

// Moves a half-edge with its origin, wedge and edge from slot `from` to slot `to`, and updates its
// twin, vertex and edge, which refer to it. The slot `from` keeps its bytes.
inline void TriMesh::move_half_edge(HalfEdgeId from, HalfEdgeId to) {
    HalfEdge& moved = faces_.half_edges[index(to)];
    moved = half_edge(from);
    if (exists(moved.twin)) faces_.half_edges[index(moved.twin)].twin = to;
    HalfEdgeId& of_vertex = vertices_.half_edges[index(moved.origin)];
    if (of_vertex == from) of_vertex = to;
    HalfEdgeId& of_edge = edges_.half_edges[index(moved.edge)];
    if (of_edge == from) of_edge = to;
}

inline void TriMesh::link(HalfEdgeId h, HalfEdgeId twin) {
    faces_.half_edges[index(h)].twin = twin;
    faces_.half_edges[index(twin)].twin = h;
}

}  // namespace pectin
