// Rest state of the elements that a gesture may change: positions, normals and edge lengths.
//
// Rest means as it was when the gesture began. A vertex that a split inserts rests at the midpoint
// of its ends' rest positions, and its rest normals follow from theirs. Elements outside the active
// set cannot move, so their present state is their rest state.
//
// Active elements have entries (dense indices). Vertices come in the order: those strictly inside
// the influenced zone by id, the other corners of the active faces by id, then inserted ones in the
// order of their insertion. Wedges follow the order of their vertices.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "mesh/growing_array.h"
#include "mesh/mesh_change.h"
#include "mesh/slot_table.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct RestVertexColumns {
    using Id = std::uint32_t;  // entry

    GrowingArray<VertexId> ids;  // none where unsplit has removed the vertex
    GrowingArray<Vec3> positions;
    GrowingArray<std::uint8_t> was_deformed;  // 0 or 1
    GrowingArray<std::uint8_t> stays;         // 1 for midpoints inserted into faces that stay

    std::size_t size() const { return ids.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<VertexId>{kNone<VertexId>}, columns.ids...);
        visit(Column<Vec3>{Vec3{0.0}}, columns.positions...);
        visit(Column<std::uint8_t>{0}, columns.was_deformed...);
        visit(Column<std::uint8_t>{0}, columns.stays...);
    }
};

struct RestWedgeColumns {
    using Id = std::uint32_t;  // entry

    GrowingArray<WedgeId> ids;  // none where unsplit has removed the wedge
    GrowingArray<Vec3f> normals;
    GrowingArray<std::uint32_t> owners;  // vertex entries

    std::size_t size() const { return ids.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<WedgeId>{kNone<WedgeId>}, columns.ids...);
        visit(Column<Vec3f>{Vec3f{0.0f}}, columns.normals...);
        visit(Column<std::uint32_t>{0}, columns.owners...);
    }
};

struct RestEdgeColumns {
    using Id = std::uint32_t;  // entry

    GrowingArray<EdgeId> ids;  // an edge keeps its entry when unsplit removes it
    // 1 for edges without a normal discontinuity: both sides share their wedges, or there is only
    // one side. 0 on creases and along cuts. The halves of a smooth edge are smooth.
    GrowingArray<std::uint8_t> is_smooth;

    std::size_t size() const { return ids.size(); }
    template <typename Visit, typename... C>
    static void for_each_column(Visit visit, C&... columns) {
        visit(Column<EdgeId>{kNone<EdgeId>}, columns.ids...);
        visit(Column<std::uint8_t>{0}, columns.is_smooth...);
    }
};

class RestState {
  public:
    static constexpr std::uint32_t kNoEntry = 0xffffffffu;

    explicit RestState(const TriMesh& mesh) : mesh_(mesh) {}

    // --- Duration of a gesture. ActiveSet documents preconditions and cost.
    void begin(std::span<const FaceId> faces, const Box& zone);
    // Removes the entries of inserted elements and writes the rest state of the others to the mesh.
    // Precondition: all edits have been taken back.
    void restore(TriMesh& mesh) noexcept;
    // The same if there were no edits, which is faster.
    void restore_attributes(TriMesh& mesh) const noexcept;
    void end() noexcept;
    // Like end(), but also if begin() has thrown.
    void abandon() noexcept;
    // Writes what differs from rest, or is gone, or new, to change.before and change.after, which
    // are empty.
    void record(MeshChange& change) const;
    // Whether f is gone, or a corner's position or normal differs from rest.
    bool has_changed(FaceId f) const;

    // --- Entries.
    const RestVertexColumns& vertices() const { return vertices_; }
    const RestWedgeColumns& wedges() const { return wedges_; }
    const RestEdgeColumns& edges() const { return edges_; }
    std::uint32_t influenced_vertices() const { return influenced_vertices_; }
    std::uint32_t influenced_wedges() const { return influenced_wedges_; }
    std::uint32_t original_vertices() const { return original_vertices_; }
    std::uint32_t original_wedges() const { return original_wedges_; }
    const Box& zone() const { return zone_; }
    bool is_influenced_at(std::uint32_t vertex) const {
        return vertex < influenced_vertices_ ||
               (vertex >= original_vertices_ && vertices_.stays[vertex] == 0 &&
                zone_.contains_strictly(vertices_.positions[vertex]));
    }
    std::uint32_t entry(VertexId v) const { return lookup(vertex_entry_, v); }
    std::uint32_t entry(WedgeId w) const { return lookup(wedge_entry_, w); }
    std::uint32_t entry(EdgeId e) const { return edge_states_[index(e)].entry; }

    // --- Rest state of any element of the mesh. O(1).
    const Vec3& position(VertexId v) const {
        const std::uint32_t i = entry(v);
        return i == kNoEntry ? mesh_.position(v) : vertices_.positions[i];
    }
    const Vec3f& normal(WedgeId w) const {
        const std::uint32_t i = entry(w);
        return i == kNoEntry ? mesh_.normal(w) : wedges_.normals[i];
    }
    Vec3 area_normal(VertexId p, VertexId q, VertexId r) const;
    // The three kinds of length() return the same value, rounded to float: an edge has one rest
    // length during a gesture, and each half of a split has exactly half of it.
    // This one stores the lengths that it measures.
    float length(EdgeId e) {
        if (index(e) < edge_states_.size()) {
            const float known = edge_states_[index(e)].length;
            if (known != kUnmeasured) return known;
        }
        return measure(e);
    }
    // Stores only lengths of active edges. Several threads may call it, each with other edges.
    // Precondition: e existed when the gesture began, or is active.
    float cached_length(EdgeId e) {
        EdgeState& state = edge_states_[index(e)];
        if (state.length != kUnmeasured) return state.length;
        const float length = distance_of_ends(e);
        if (state.entry != kNoEntry) state.length = length;
        return length;
    }
    // Stores nothing, so several threads may call it with any edge.
    float uncached_length(EdgeId e) const {
        if (index(e) < edge_states_.size()) {
            const float known = edge_states_[index(e)].length;
            if (known != kUnmeasured) return known;
        }
        return distance_of_ends(e);
    }
    // The length of the edge from an apex to a midpoint that rests at m.
    float spoke_length(VertexId apex, const Vec3& m) const {
        return static_cast<float>(glm::distance(position(apex), m));
    }
    // An upper bound of the rest lengths of all active edges, also of former ones. O(1).
    double longest_length() const { return std::sqrt(longest_square_); }

    // --- Changes by edits, for ActiveSet.
    // Makes room for `count` splits of edges outside cuts; returns for how many there is room.
    std::size_t reserve_splits(std::size_t count);
    // TriMesh::prepare_splits() for the rest state.
    void prepare_splits(std::size_t count);
    // Makes room for what unsplits of `sheets` sheets free.
    void reserve_unsplits(std::size_t sheets);
    // Makes room for what else an unsplit of `sheets` sheets adds at the rim of the active set.
    void reserve_rim(std::size_t sheets);
    // Allocates an entry, which enter() then writes. Precondition: reserve_splits() has made room.
    std::uint32_t allocate(VertexId v);
    std::uint32_t allocate(WedgeId w);
    // Allocates an entry, or returns the one that e's id already has.
    std::uint32_t allocate(EdgeId e, bool smooth);
    void enter(std::uint32_t entry, VertexId v, const Vec3& position, bool was_deformed,
               bool stays);
    void enter(std::uint32_t entry, WedgeId w, const Vec3f& normal, std::uint32_t owner);
    void enter(std::uint32_t entry, EdgeId e, float length);
    // Enters am or dm.
    void enter_spoke(std::uint32_t entry, EdgeId e, VertexId apex, const Vec3& m);
    // Removes an element; returns its entry. If is_inserted_vertex(entry) or is_inserted_wedge(),
    // the caller then frees it: push_free() or set_free() of vertex_table() or wedge_table().
    std::uint32_t remove(VertexId v);
    std::uint32_t remove(WedgeId w);
    // Removes a wedge that may have no entry; its normal is then kept for restore().
    void remove_or_keep(WedgeId w);
    bool is_inserted_vertex(std::uint32_t entry) const { return entry >= original_vertices_; }
    bool is_inserted_wedge(std::uint32_t entry) const { return entry >= original_wedges_; }
    void set_length(EdgeId e, float length) { edge_states_[index(e)].length = length; }
    void forget_length(EdgeId e) { set_length(e, kUnmeasured); }
    // Enters an edge that an unsplit has restored and that has no entry.
    void enter_restored(EdgeId e) {
        if (entry(e) == kNoEntry) enter(allocate(e, has_smooth_normals(e)), e, kUnmeasured);
    }
    // Raises the bound of longest_length(). Safe to call concurrently.
    void record_length(float length);
    // The free entries, for edits on several threads: see SlotTable.
    SlotTable<RestVertexColumns>& vertex_table() { return vertices_; }
    SlotTable<RestWedgeColumns>& wedge_table() { return wedges_; }

    std::size_t memory_bytes() const;

  private:
    static constexpr float kUnmeasured = -1.0f;

    struct EdgeState {
        std::uint32_t entry = kNoEntry;
        float length = kUnmeasured;
    };

    template <typename Id>
    static std::uint32_t lookup(const GrowingArray<std::uint32_t>& entries, Id id) {
        return index(id) < entries.size() ? entries[index(id)] : kNoEntry;
    }
    void fit_to_mesh();
    struct Elements;
    Elements mark(std::span<const FaceId> faces);
    void mark_on_all_threads(std::span<const FaceId> faces);
    void enter_edges(const Elements& elements);
    void enter_vertices(const Elements& elements);
    void enter_wedges(const Elements& elements);
    void record_vertices(MeshChange& change) const;
    void record_wedges(MeshChange& change) const;
    void drop_inserted() noexcept;
    bool has_smooth_normals(EdgeId e) const;
    float measure(EdgeId e);
    float distance_of_ends(EdgeId e) const;

    const TriMesh& mesh_;
    Box zone_;
    std::uint32_t influenced_vertices_ = 0, influenced_wedges_ = 0;
    std::uint32_t original_vertices_ = 0, original_wedges_ = 0, original_edges_ = 0;

    SlotTable<RestVertexColumns> vertices_;
    SlotTable<RestWedgeColumns> wedges_;
    SlotTable<RestEdgeColumns> edges_;
    GrowingArray<VertexId> original_vertex_ids_;  // of the entries at the beginning
    GrowingArray<WedgeId> original_wedge_ids_;
    // Wedges without entries that unsplit has removed, with their normals: the wedges of a removed
    // vertex on a side where no face is active.
    GrowingArray<WedgeId> kept_wedges_;
    GrowingArray<Vec3f> kept_normals_;
    GrowingArray<std::uint32_t> flipped_smooth_;  // original edge entries whose mark has changed
    GrowingArray<EdgeId> measured_edges_;         // edges without entries with a stored length
    double longest_square_ = 0.0;

    // As large as the mesh. All but the elements of the current gesture have the initial value.
    GrowingArray<std::uint32_t> vertex_entry_, wedge_entry_;
    GrowingArray<EdgeState> edge_states_;
};

inline std::uint32_t RestState::allocate(VertexId v) {
    if (index(v) == vertex_entry_.size()) vertex_entry_.grow_unchecked(1);
    return vertices_.allocate();
}

inline std::uint32_t RestState::allocate(WedgeId w) {
    if (index(w) == wedge_entry_.size()) wedge_entry_.grow_unchecked(1);
    return wedges_.allocate();
}

inline std::uint32_t RestState::allocate(EdgeId e, bool smooth) {
    const std::uint8_t mark = smooth ? 1 : 0;
    const bool is_new = index(e) == edge_states_.size();
    if (is_new) edge_states_.grow_unchecked(1);
    if (is_new || entry(e) == kNoEntry) {
        edges_.ids.push_back(e);
        edges_.is_smooth.push_back(mark);
        return edges_.slots() - 1;
    }
    const std::uint32_t i = entry(e);
    if (edges_.is_smooth[i] != mark) {
        if (i < original_edges_) flipped_smooth_.push_back(i);
        edges_.is_smooth[i] = mark;
    }
    return i;
}

inline void RestState::enter(std::uint32_t entry, VertexId v, const Vec3& position,
                             bool was_deformed, bool stays) {
    vertex_entry_[index(v)] = entry;
    vertices_.ids[entry] = v;
    vertices_.positions[entry] = position;
    vertices_.was_deformed[entry] = was_deformed ? 1 : 0;
    vertices_.stays[entry] = stays ? 1 : 0;
}

inline void RestState::enter(std::uint32_t entry, WedgeId w, const Vec3f& normal,
                             std::uint32_t owner) {
    wedge_entry_[index(w)] = entry;
    wedges_.ids[entry] = w;
    wedges_.normals[entry] = normal;
    wedges_.owners[entry] = owner;
}

inline void RestState::enter(std::uint32_t entry, EdgeId e, float length) {
    edge_states_[index(e)] = {entry, length};
}

inline void RestState::enter_spoke(std::uint32_t entry, EdgeId e, VertexId apex, const Vec3& m) {
    const float length = spoke_length(apex, m);
    enter(entry, e, length);
    record_length(length);
}

inline std::uint32_t RestState::remove(VertexId v) {
    const std::uint32_t entry = std::exchange(vertex_entry_[index(v)], kNoEntry);
    vertices_.ids[entry] = kNone<VertexId>;
    return entry;
}

inline std::uint32_t RestState::remove(WedgeId w) {
    const std::uint32_t entry = std::exchange(wedge_entry_[index(w)], kNoEntry);
    wedges_.ids[entry] = kNone<WedgeId>;
    return entry;
}

}  // namespace pectin
