// The part of a mesh that a gesture may change: its rest state, and the log of what was done.
//
// Rest means as it was when the gesture began. A vertex that a split inserts rests at the
// midpoint of its ends' rest positions, its normals follow from theirs. Outside the active set
// rest and present are the same.
//
// Elements have entries (dense indices) in the order: vertices strictly inside the influenced
// zone by id, the other corners of the active faces by id, then inserted ones as they come.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/growing_array.h"
#include "mesh/mesh_change.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Keeps arrays as large as the mesh across gestures, so that beginning one costs only what it
// touches. Holds a reference to the mesh; both stay where they are.
class ActiveSet {
  public:
    static constexpr std::uint32_t kNoEntry = 0xffffffffu;

    explicit ActiveSet(TriMesh& mesh) : mesh_(mesh) {}
    ActiveSet(const ActiveSet&) = delete;
    ActiveSet& operator=(const ActiveSet&) = delete;

    // `faces`: live, sorted, each once. `zone`: only vertices strictly inside it will move.
    // Cost: O(faces); the first time, and when the mesh has grown, O(mesh).
    void begin(std::span<const FaceId> faces, const Box& zone);
    // Takes back all edits and gives every element its rest state. Allocates nothing.
    // Cost: O(touched).
    void roll_back() noexcept;
    // The same, and the end of the gesture.
    void cancel() noexcept;
    // Forgets a gesture that has not edited anything yet, also one whose begin has thrown.
    void abandon() noexcept;
    // What was done since begin, as one change, and the end of the gesture. Cost: O(touched).
    MeshChange finish();
    bool is_begun() const { return begun_; }

    TriMesh& mesh() { return mesh_; }
    const TriMesh& mesh() const { return mesh_; }
    const Box& zone() const { return zone_; }

    // --- Entries. vertex(i) is none where unsplit removed it.
    std::uint32_t vertex_entries() const { return static_cast<std::uint32_t>(vertices_.size()); }
    std::uint32_t influenced_at_begin() const { return influenced_; }
    std::uint32_t vertices_at_begin() const { return original_vertices_; }
    VertexId vertex(std::uint32_t entry) const { return vertices_[entry]; }
    std::span<const VertexId> vertices() const { return vertices_; }
    std::span<const Vec3> rest_positions() const { return rest_positions_; }
    const Vec3& rest_position_at(std::uint32_t entry) const { return rest_positions_[entry]; }
    std::span<const std::uint8_t> were_deformed() const { return was_deformed_; }  // 0 or 1
    bool was_deformed_at(std::uint32_t entry) const { return was_deformed_[entry] != 0; }
    bool is_influenced_at(std::uint32_t entry) const {
        return entry < influenced_ ||
               (entry >= original_vertices_ && zone_.contains_strictly(rest_positions_[entry]));
    }
    std::uint32_t wedge_entries() const { return static_cast<std::uint32_t>(wedges_.size()); }
    // Wedges of influenced vertices come first, as the vertices do.
    std::uint32_t influenced_wedges_at_begin() const { return influenced_wedges_; }
    WedgeId wedge(std::uint32_t entry) const { return wedges_[entry]; }
    std::span<const WedgeId> wedges() const { return wedges_; }
    std::span<const Vec3f> rest_normals() const { return rest_normals_; }
    std::span<const std::uint32_t> wedge_owners() const { return wedge_owners_; }
    const Vec3f& rest_normal_at(std::uint32_t entry) const { return rest_normals_[entry]; }
    std::uint32_t wedge_owner(std::uint32_t entry) const { return wedge_owners_[entry]; }
    // Edges of the active faces and of inserted vertices, each once; also those that unsplit has
    // removed, until a split uses their ids again.
    std::span<const EdgeId> edges() const { return edges_; }
    // Of each: 1 where one side says all about its end normals, since the other shares both wedges
    // or there is none; so it stays for all its pieces. 0 on creases and along cuts.
    std::span<const std::uint8_t> smooth_edges() const { return is_smooth_; }
    // A byte for each of them, for a pass to write and read; lost with the next edit.
    std::span<std::uint8_t> scratch_of_edges() {
        scratch_.resize(edges_.size());
        return scratch_;
    }

    // The active faces as they were at begin, then every slot that an edit made, cut or freed.
    std::span<const FaceId> faces() const { return faces_; }
    std::span<const FaceId> edited_faces() const {
        return std::span(faces_).subspan(original_faces_);
    }

    // The entry of a vertex or an edge, if it has one. O(1).
    std::optional<std::uint32_t> entry_of(EdgeId e) const {
        const std::uint32_t entry = edge_states_[index(e)].entry;
        return entry == kNoEntry ? std::nullopt : std::optional(entry);
    }
    std::optional<std::uint32_t> entry_of(VertexId v) const {
        const std::uint32_t entry = slot(vertex_entry_, v);
        return entry == kNoEntry ? std::nullopt : std::optional(entry);
    }

    // --- Rest state of anything in the mesh. O(1).
    const Vec3& rest_position(VertexId v) const {
        const std::uint32_t entry = slot(vertex_entry_, v);
        return entry == kNoEntry ? mesh_.position(v) : rest_positions_[entry];
    }
    const Vec3f& rest_normal(WedgeId w) const {
        const std::uint32_t entry = slot(wedge_entry_, w);
        return entry == kNoEntry ? mesh_.normal(w) : rest_normals_[entry];
    }
    // Rounded to float and remembered, so that an edge has one rest length for a gesture; the
    // halves of a split have exactly half of it.
    float rest_length(EdgeId e) {
        if (index(e) < edge_states_.size()) {
            const float known = edge_states_[index(e)].rest_length;
            if (known != kUnmeasured) return known;
        }
        return measure(e);
    }
    // The same, but remembers it of active edges alone. Several threads may ask, each of edges that
    // no other asks for. Precondition: e was there when the gesture began, or is active.
    float cached_rest_length(EdgeId e) {
        EdgeState& state = edge_states_[index(e)];
        if (state.rest_length != kUnmeasured) return state.rest_length;
        const float length = distance_of_rest_ends(e);
        if (state.entry != kNoEntry) state.rest_length = length;
        return length;
    }
    // The same, but remembers nothing, so that several threads may ask for any edge.
    float uncached_rest_length(EdgeId e) const {
        if (index(e) < edge_states_.size()) {
            const float known = edge_states_[index(e)].rest_length;
            if (known != kUnmeasured) return known;
        }
        return distance_of_rest_ends(e);
    }
    // No active edge is longer at rest, nor has any been in this gesture. O(1).
    double longest_rest_length() const { return std::sqrt(longest_square_); }

    // --- Edits, logged.
    // What a split has made in one sheet: entries, and edges round the new vertex. All is at rest.
    // Where there are more sheets, they share the vertex; the first of them stands for it and for
    // the edges along the cut.
    struct Inserted {
        std::uint32_t vertex_entry = kNoEntry;
        bool is_first_sheet = true;
        bool is_smooth = true;  // the edge that was split, and so its halves (smooth_edges)
        std::array<std::uint32_t, 2> wedge_entries{kNoEntry, kNoEntry};  // the second on a crease
        std::array<EdgeId, 4> edges{kNone<EdgeId>, kNone<EdgeId>, kNone<EdgeId>, kNone<EdgeId>};
    };
    // Splits e and its siblings; appends what that made. Cost: O(1), with siblings O(siblings).
    Split split(EdgeId e, std::vector<Inserted>& inserted);
    Split split(EdgeId e) {
        std::vector<Inserted> inserted;
        return split(e, inserted);
    }
    // Room for `count` splits of edges with one or two sides, here and in the mesh, so that these
    // move no array.
    void reserve_splits(std::uint32_t count);
    // --- The same on several threads, of active edges that are smooth; TriMesh says which may go
    // at the same time. allocate_splits takes ids, entries and room in the log for so many, or
    // throws std::bad_alloc and has changed nothing. Until concurrent_split has been called once
    // with each, in any order, nothing else may be asked of what it took. That changes no array's
    // size.
    struct ReservedSlots {
        struct Entries {
            std::uint32_t vertex, wedge;
            std::array<std::uint32_t, 3> edges;  // mc, am, dm
        };
        std::vector<SplitIds> ids;
        std::vector<Entries> entries;        // of each
        std::size_t first_edit, first_face;  // in the log, of the first
    };
    void allocate_splits(std::uint32_t count, ReservedSlots& slots);
    Inserted concurrent_split(EdgeId e, const ReservedSlots& slots, std::size_t i);
    // The length of the edge from an apex to the midpoint m, both at rest, as rest_length has it.
    float spoke_rest_length(VertexId apex, const Vec3& m) const {
        return static_cast<float>(glm::distance(rest_position(apex), m));
    }

    // Precondition: star.m has an entry. Throws std::bad_alloc before anything is changed.
    void unsplit(const Star& star);
    // --- The same on several threads. Two calls may run at the same time if no corner of the one's
    // faces is one of the other's. What they return is logged, and what they removed is free, when
    // log_unsplits has had it. Precondition: may_unsplit_concurrently(star).
    struct Unsplit {
        SplitIds ids;
        EdgeId bc = kNone<EdgeId>;
        std::array<FaceId, 2> kept_faces{};
        std::uint32_t vertex_entry = kNoEntry, wedge_entry = kNoEntry;
    };
    Unsplit concurrent_unsplit(const Star& star);
    // Takes places in the log for the next ones, behind those taken before; log_unsplits may then
    // be called with them while others are, and has to be before anything else is asked of the log.
    // count, log_unsplits: O(unsplits). allocate_unsplits: O(1).
    struct UnsplitCount {
        std::size_t unsplits = 0, vertex_entries = 0, wedge_entries = 0;  // entries that get free
    };
    struct ReservedLogSlots {  // of the first
        std::size_t edit = 0, face = 0, vertex_entry = 0, wedge_entry = 0;
        FreedSlots freed{};
    };
    UnsplitCount count(std::span<const Unsplit> unsplits) const;
    ReservedLogSlots allocate_unsplits(const UnsplitCount& count);
    void log_unsplits(std::span<const Unsplit> unsplits, ReservedLogSlots at);
    // Room for so many, so that none of all this throws.
    void reserve_unsplits(std::size_t count);
    // Whether bm and mc are smooth, and star.m, its wedge and bm have entries.
    bool may_unsplit_concurrently(const Star& star) const;
    std::uint64_t edit_count() const { return edits_.size(); }
    std::uint64_t splits() const { return splits_; }
    std::uint64_t unsplits() const { return edits_.size() - splits_; }

    std::size_t memory_bytes() const;

  private:
    static constexpr float kUnmeasured = -1.0f;

    struct EdgeState {
        std::uint32_t entry = kNoEntry;
        float rest_length = kUnmeasured;
    };

    template <typename Id>
    static std::uint32_t slot(const GrowingArray<std::uint32_t>& entries, Id id) {
        return index(id) < entries.size() ? entries[index(id)] : kNoEntry;
    }
    void fit_to_mesh();
    void collect(std::span<const FaceId> faces);
    std::uint32_t allocate_vertex_entry(VertexId v);
    std::uint32_t allocate_wedge_entry(WedgeId w);
    std::uint32_t allocate_edge_entry(EdgeId e, bool smooth);
    void enter(std::uint32_t entry, VertexId v, const Vec3& rest, bool was_deformed);
    void enter(std::uint32_t entry, WedgeId w, const Vec3f& rest, std::uint32_t owner);
    void enter(std::uint32_t entry, EdgeId e, float rest_length);
    void enter_spoke(std::uint32_t entry, EdgeId e, VertexId apex, const Vec3& m);
    void reserve_for_split(EdgeId e);
    template <typename Visit>
    void for_each_array_of_splits(Visit visit);
    void insert_sheet(const Split& split, std::uint32_t vertex_entry, float half_length,
                      Inserted& made);
    template <typename AreaNormal>
    void insert_side(const Split::Side& side, std::uint32_t entry, std::uint32_t owner,
                     const AreaNormal& area_normal);
    void log_faces(std::size_t first, const Split& split);
    Vec3 rest_area_normal(VertexId p, VertexId q, VertexId r) const;
    float measure(EdgeId e);
    float distance_of_rest_ends(EdgeId e) const;
    void drop_sheet(const Star& star);
    void drop_wedge(WedgeId w);
    bool has_smooth_normals(EdgeId e) const;
    void record_length(float rest_length);
    void drop_inserted() noexcept;
    void forget() noexcept;
    void record_states(MeshChange& change) const;
    bool has_changed(FaceId original) const;

    TriMesh& mesh_;
    Box zone_;
    bool begun_ = false;
    SlotCounts slots_at_begin_;
    std::uint32_t influenced_ = 0, influenced_wedges_ = 0;
    std::uint32_t original_vertices_ = 0, original_wedges_ = 0, original_edges_ = 0;

    GrowingArray<FaceId> faces_;  // at begin, then those that splits made
    std::size_t original_faces_ = 0;
    GrowingArray<VertexId> vertices_;          // entries
    GrowingArray<VertexId> original_ids_;      // entries at begin, whatever became of them
    GrowingArray<Vec3> rest_positions_;        // entries, world
    GrowingArray<std::uint8_t> was_deformed_;  // entries
    GrowingArray<WedgeId> wedges_;             // entries
    GrowingArray<WedgeId> original_wedge_ids_;
    GrowingArray<Vec3f> rest_normals_;
    GrowingArray<std::uint32_t> wedge_owners_;  // vertex entries
    // A removed vertex may have a wedge on the side where no face is active: as it was.
    GrowingArray<WedgeId> lost_wedges_;
    GrowingArray<Vec3f> lost_normals_;
    GrowingArray<EdgeId> edges_;
    GrowingArray<std::uint8_t> is_smooth_;  // of edges_
    GrowingArray<std::uint32_t>
        flipped_smooth_;  // entries at begin, of ids that other edges took over
    GrowingArray<std::uint8_t> scratch_;
    GrowingArray<EdgeId> measured_edges_;  // not in edges_, but their rest length is remembered
    GrowingArray<std::uint32_t> free_vertex_entries_, free_wedge_entries_;  // inserted and gone

    GrowingArray<TopologyEdit> edits_;
    std::uint64_t splits_ = 0;
    std::uint32_t split_capacity_ =
        0;  // for how many splits of edges that lie along no cut, at least
    double longest_square_ = 0.0;

    // As large as the mesh; as initialised but for what the gesture has touched.
    GrowingArray<std::uint32_t> vertex_entry_, wedge_entry_;
    GrowingArray<EdgeState> edge_states_;
};

}  // namespace pectin
