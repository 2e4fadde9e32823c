// The part of a mesh that a gesture may change: its rest state (rest_state.h) and the log of its
// edits (edit_log.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/concurrent_allocation.h"
#include "mesh/edit_log.h"
#include "mesh/error_log.h"
#include "mesh/growing_array.h"
#include "mesh/mesh_change.h"
#include "mesh/rest_state.h"
#include "mesh/staying_faces.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Keeps arrays as large as the mesh between gestures, so that beginning one costs only what it
// touches. Holds a reference to the mesh; neither object may be moved.
class ActiveSet {
  public:
    static constexpr std::uint32_t kNoEntry = RestState::kNoEntry;

    explicit ActiveSet(TriMesh& mesh) : mesh_(mesh), rest_(mesh) {}
    ActiveSet(const ActiveSet&) = delete;
    ActiveSet& operator=(const ActiveSet&) = delete;

    // Begins a gesture. `faces`: live, sorted, each once. `zone`: only vertices strictly inside it
    // will move. `staying`: the faces that reach into the zone and do not move. No edge that lies
    // strictly inside has faces of both kinds. Cost: O(faces); the first time, and when the mesh
    // has grown, O(mesh).
    void begin(std::span<const FaceId> faces, const Box& zone,
               std::span<const FaceId> staying = {});
    // Takes back all edits and gives every element its rest state. Allocates nothing.
    // Cost: O(touched).
    void roll_back() noexcept;
    // Rolls back and ends the gesture.
    void cancel() noexcept;
    // Ends a gesture that has not edited anything yet, also one whose begin() has thrown.
    void abandon() noexcept;
    // Ends the gesture and returns all that happened since begin(). Cost: O(touched).
    MeshChange finish();
    bool is_begun() const { return begun_; }

    TriMesh& mesh() { return mesh_; }
    const TriMesh& mesh() const { return mesh_; }
    const RestState& rest() const { return rest_; }
    const Box& zone() const { return rest_.zone(); }

    // --- Entries of RestState. vertex(i) is none where unsplit has removed the vertex.
    std::uint32_t vertex_entries() const { return static_cast<std::uint32_t>(vertices().size()); }
    std::uint32_t influenced_at_begin() const { return rest_.influenced_vertices(); }
    std::uint32_t vertices_at_begin() const { return rest_.original_vertices(); }
    VertexId vertex(std::uint32_t entry) const { return rest_.vertices().ids[entry]; }
    std::span<const VertexId> vertices() const { return rest_.vertices().ids; }
    std::span<const Vec3> rest_positions() const { return rest_.vertices().positions; }
    const Vec3& rest_position_at(std::uint32_t entry) const {
        return rest_.vertices().positions[entry];
    }
    std::span<const std::uint8_t> were_deformed() const {  // 0 or 1
        return rest_.vertices().was_deformed;
    }
    bool was_deformed_at(std::uint32_t entry) const { return were_deformed()[entry] != 0; }
    bool is_influenced_at(std::uint32_t entry) const { return rest_.is_influenced_at(entry); }
    std::uint32_t wedge_entries() const { return static_cast<std::uint32_t>(wedges().size()); }
    // Wedges of influenced vertices come first.
    std::uint32_t influenced_wedges_at_begin() const { return rest_.influenced_wedges(); }
    WedgeId wedge(std::uint32_t entry) const { return rest_.wedges().ids[entry]; }
    std::span<const WedgeId> wedges() const { return rest_.wedges().ids; }
    std::span<const Vec3f> rest_normals() const { return rest_.wedges().normals; }
    std::span<const std::uint32_t> wedge_owners() const { return rest_.wedges().owners; }
    const Vec3f& rest_normal_at(std::uint32_t entry) const { return rest_normals()[entry]; }
    std::uint32_t wedge_owner(std::uint32_t entry) const { return wedge_owners()[entry]; }
    // The edges of the active faces and of inserted vertices, each once. Edges that unsplit has
    // removed stay until a split uses their ids again.
    std::span<const EdgeId> edges() const { return rest_.edges().ids; }
    // One mark per entry of edges(): RestEdgeColumns::is_smooth.
    std::span<const std::uint8_t> smooth_edges() const { return rest_.edges().is_smooth; }
    // One byte per entry of edges() for a pass to write and read. The next edit invalidates it.
    std::span<std::uint8_t> scratch_of_edges() {
        scratch_.resize(edges().size());
        return scratch_;
    }
    // The entry of an edge or a vertex, if it has one. O(1).
    std::optional<std::uint32_t> entry_of(EdgeId e) const { return optional(rest_.entry(e)); }
    std::optional<std::uint32_t> entry_of(VertexId v) const { return optional(rest_.entry(v)); }

    // The active faces at the beginning, then every slot that an edit made, changed or freed.
    std::span<const FaceId> faces() const { return log_.faces(); }
    // Whether f is one of the faces that stay, or a piece of one.
    bool stays(FaceId f) const { return staying_.contains(f); }
    std::span<const FaceId> edited_faces() const { return faces().subspan(log_.original_faces()); }

    // --- Rest state of any element of the mesh. O(1). RestState documents the lengths.
    const Vec3& rest_position(VertexId v) const { return rest_.position(v); }
    const Vec3f& rest_normal(WedgeId w) const { return rest_.normal(w); }
    float rest_length(EdgeId e) { return rest_.length(e); }
    float cached_rest_length(EdgeId e) { return rest_.cached_length(e); }
    float uncached_rest_length(EdgeId e) const { return rest_.uncached_length(e); }
    float spoke_rest_length(VertexId apex, const Vec3& m) const {
        return rest_.spoke_length(apex, m);
    }
    double longest_rest_length() const { return rest_.longest_length(); }

    // --- Edits, logged.
    // What a split has made in one sheet: entries, and the edges at the new vertex, all at rest.
    // Sheets along a cut share the vertex and the edges along the cut; only the first sheet's
    // record lists these edges.
    struct Inserted {
        std::uint32_t vertex_entry = kNoEntry;
        bool is_first_sheet = true;
        bool is_smooth = true;  // whether the edge that was split is, and hence its halves
        std::array<std::uint32_t, 2> wedge_entries{kNoEntry, kNoEntry};  // the second on a crease
        std::array<EdgeId, 4> edges{kNone<EdgeId>, kNone<EdgeId>, kNone<EdgeId>, kNone<EdgeId>};
    };
    // Splits e and its siblings; appends one record per sheet. Throws std::bad_alloc before
    // anything changes. Cost: O(1), with siblings O(siblings).
    Split split(EdgeId e, std::vector<Inserted>& inserted);
    Split split(EdgeId e) {
        std::vector<Inserted> inserted;
        return split(e, inserted);
    }
    // Makes room for `count` splits of edges outside cuts, here and in the mesh, so that these move
    // no array.
    void reserve_splits(std::uint32_t count);
    // Takes memory from the system for the first `count` splits of the next gesture, which would
    // otherwise wait for it. Only between gestures. Throws std::bad_alloc; the mesh is then
    // unchanged. Cost: O(count), and O(mesh) the first time.
    void prepare_splits(std::uint32_t count);
    // Precondition: star.m has an entry. Throws std::bad_alloc before anything changes.
    void unsplit(const Star& star);

    // Sets the errors of live faces. Throws std::bad_alloc before anything changes. faces, errors:
    // the same number. Precondition: the mesh tracks errors.
    void set_errors(std::span<const FaceId> faces, std::span<const ErrorEllipsoid> errors);
    // The error at rest of the face on the side of h, once the split of star.m has been undone: it
    // contains those of its two pieces, and the vector from the middle of bc to m at rest. h:
    // star.bm, or star.mb.
    ErrorEllipsoid merged_error(const Star& star, HalfEdgeId h) const;
    // Whether undoing the split of star.m leaves the surface at rest, and its errors, as they are.
    bool merges_exactly(const Star& star) const;

    // --- Edits on several threads (concurrent_allocation.h), of active smooth edges.
    //
    // Slots of several splits: in the mesh, among the entries, and in the log.
    struct ReservedSlots {
        struct Entries {
            std::uint32_t vertex, wedge;
            std::array<std::uint32_t, 3> edges;  // mc, am, dm
        };
        ConcurrentAllocation ids;
        std::vector<Entries> entries;                // one per split
        std::size_t first_edit = 0, first_face = 0;  // in the log, of the first split
    };
    // Reserves slots for `count` splits. Throws std::bad_alloc before anything changes. Until
    // concurrent_split() has been called once with each, in any order, the reserved elements are
    // incomplete and must not be read.
    void allocate_splits(std::uint32_t count, ReservedSlots& slots);
    // Changes no array's size. Two calls may run at the same time if their stencils share no
    // vertex.
    Inserted concurrent_split(EdgeId e, ReservedSlots& slots, std::size_t i);

    // What an unsplit has removed.
    struct Unsplit {
        SplitIds ids;
        EdgeId bc = kNone<EdgeId>;
        std::array<FaceId, 2> kept_faces{};
        std::uint32_t vertex_entry = kNoEntry, wedge_entry = kNoEntry;
    };
    // The errors of kept_faces, face 3 and face 4 before an unsplit. They stand apart, since they
    // are larger than all of Unsplit and are needed only if the mesh tracks errors.
    using FormerErrors = std::array<ErrorEllipsoid, 4>;
    // Two calls may run at the same time if their stencils share no vertex. The removed slots are
    // freed, and the edit is logged, by log_unsplits(). errors: null if the mesh tracks none.
    // Precondition: may_unsplit_concurrently().
    Unsplit concurrent_unsplit(const Star& star, FormerErrors* errors);
    // Whether bm and mc are smooth, and star.m, its wedge and bm have entries.
    bool may_unsplit_concurrently(const Star& star) const;
    struct UnsplitCount {
        std::size_t unsplits = 0, vertex_entries = 0, wedge_entries = 0;  // entries to be freed
    };
    // Reserved parts of the log and of the free lists: the indices of the first.
    struct ReservedLogSlots {
        std::size_t edit = 0, face = 0, vertex_entry = 0, wedge_entry = 0, error = 0;
        FreedSlots freed{};
    };
    // count() and log_unsplits() may run concurrently for different groups of unsplits, in
    // O(unsplits). allocate_unsplits(), in O(1), reserves what one group needs, behind all earlier
    // groups: the order of these calls is the order in which the edits are logged. Nothing else
    // may read or write the log until every group has been logged.
    UnsplitCount count(std::span<const Unsplit> unsplits) const;
    ReservedLogSlots allocate_unsplits(const UnsplitCount& count);
    // errors: one for each unsplit; not used if the mesh tracks none.
    void log_unsplits(std::span<const Unsplit> unsplits, std::span<const FormerErrors> errors,
                      ReservedLogSlots at);
    // Makes room for unsplits of `sheets` sheets in all. After that the four functions above do not
    // throw. Throws std::bad_alloc.
    void reserve_unsplits(std::size_t sheets);

    // How often a gesture has begun or was rolled back. Until then edited_faces() only grows.
    std::uint64_t roll_backs() const { return roll_backs_; }
    std::uint64_t edit_count() const { return log_.edits().size(); }
    std::uint64_t splits() const { return log_.splits(); }
    std::uint64_t unsplits() const { return log_.unsplits(); }

    std::size_t memory_bytes() const;

  private:
    static std::optional<std::uint32_t> optional(std::uint32_t entry) {
        return entry == kNoEntry ? std::nullopt : std::optional(entry);
    }
    void reserve_for_split(EdgeId e);
    void insert_sheet(const Split& split, std::uint32_t vertex_entry, float half_length,
                      Inserted& made);
    template <typename AreaNormal>
    void insert_side(const Split::Side& side, std::uint32_t entry, std::uint32_t owner,
                     const AreaNormal& area_normal);
    bool midpoint_stays(const Split& split) const;
    void log_faces(std::size_t first, const Split& split);
    void drop_sheet(const Star& star);
    void merge_errors(const Star& star);
    Vec3 from_middle(const Star& star) const;
    void reserve_errors(std::size_t sheets);
    std::vector<FaceId> changed_faces() const;  // for a MeshChange
    void forget() noexcept;

    TriMesh& mesh_;
    RestState rest_;
    EditLog log_;
    ErrorLog errors_;
    StayingFaces staying_;
    bool begun_ = false;
    std::uint64_t roll_backs_ = 0;
    std::uint32_t split_capacity_ = 0;  // there is room for at least so many splits outside cuts
    GrowingArray<std::uint8_t> scratch_;
};

}  // namespace pectin
