// Splits and unsplits of an active set: the mesh, the rest state and the log change together.
//
//          a                    a
//         / \                  /|\.
//        / 1 \     split      /1|3\.     rest(m) = (rest(b) + rest(c)) / 2
//       b-----c   ------->   b--m--c
//        \ 2 /    unsplit     \2|4/      new entries: m, its wedges, mc, am, dm
//         \ /     <------      \|/
//          d                    d
#include <algorithm>
#include <cassert>

#include "mesh/active_set.h"
#include "mesh/midpoint_normal.h"

namespace pectin {

void ActiveSet::reserve_splits(std::uint32_t count) {
    mesh_.reserve_splits(count);
    staying_.fit(mesh_.face_slots() + 2 * std::size_t{count});
    const auto capacity = static_cast<std::uint32_t>(
        std::min(rest_.reserve_splits(count), log_.reserve_splits(count)));
    split_capacity_ = staying_.empty() ? capacity : std::min(capacity, count);
}

void ActiveSet::prepare_splits(std::uint32_t count) {
    assert(!begun_);
    mesh_.prepare_splits(count);
    rest_.prepare_splits(count);
    log_.prepare_splits(count);
}

// Reserves all memory that the split needs before anything changes.
void ActiveSet::reserve_for_split(EdgeId e) {
    std::uint32_t sheets = 1;
    for (EdgeId s = mesh_.sibling(e); s != e; s = mesh_.sibling(s)) ++sheets;
    if (split_capacity_ < sheets) reserve_splits(sheets);
    split_capacity_ -= sheets;
}

Split ActiveSet::split(EdgeId e, std::vector<Inserted>& inserted) {
    reserve_for_split(e);
    const float length = rest_.length(e), half_length = 0.5f * length;
    rest_.record_length(length);  // bounds the halves, too, and what an unsplit restores

    const Split s = mesh_.insert_midpoint(e);
    log_.log_split(s.bm);
    const Vec3 rest = 0.5 * rest_.position(s.b) + 0.5 * rest_.position(s.c);
    mesh_.set_position(s.m, rest);
    const std::uint32_t vertex_entry = rest_.allocate(s.m);
    rest_.enter(vertex_entry, s.m, rest, mesh_.is_deformed(s.m), midpoint_stays(s));
    const std::size_t first = inserted.size();
    mesh_.for_each_sheet(s, [&](const Split& sheet) {
        inserted.emplace_back();
        insert_sheet(sheet, vertex_entry, half_length, inserted.back());
    });
    for (std::size_t i = first + 1; i < inserted.size(); ++i) {
        inserted[i].is_first_sheet = false;
        inserted[i].edges[0] = inserted[i].edges[1] = kNone<EdgeId>;
    }
    return s;
}

// Enters the rest state of what a split has made in one sheet, and logs its faces.
void ActiveSet::insert_sheet(const Split& s, std::uint32_t vertex_entry, float half_length,
                             Inserted& made) {
    const Vec3& m = rest_position_at(vertex_entry);
    const bool is_smooth = s.right ? s.is_smooth() : mesh_.sibling(s.bm) == s.bm;
    made.vertex_entry = vertex_entry;
    made.is_smooth = is_smooth;
    made.edges = {s.bm, s.mc, s.am, s.dm};
    rest_.enter(rest_.allocate(s.bm, is_smooth), s.bm, half_length);
    rest_.enter(rest_.allocate(s.mc, is_smooth), s.mc, half_length);
    rest_.enter_spoke(rest_.allocate(s.am, true), s.am, s.a, m);
    made.wedge_entries[0] = rest_.allocate(s.left.m);
    insert_side(s.left, made.wedge_entries[0], vertex_entry,
                [&] { return rest_.area_normal(s.b, s.c, s.a); });
    log_faces(log_.grow_faces(s.right ? 4 : 2), s);
    if (!s.right) return;

    rest_.enter_spoke(rest_.allocate(s.dm, true), s.dm, s.d, m);
    if (is_smooth) return;
    made.wedge_entries[1] = rest_.allocate(s.right->m);
    insert_side(*s.right, made.wedge_entries[1], vertex_entry,
                [&] { return rest_.area_normal(s.b, s.d, s.c); });
}

template <typename AreaNormal>
void ActiveSet::insert_side(const Split::Side& side, std::uint32_t entry, std::uint32_t owner,
                            const AreaNormal& area_normal) {
    const Vec3f normal = midpoint_normal(rest_.normal(side.b), rest_.normal(side.c), area_normal);
    mesh_.set_normal(side.m, normal);
    rest_.enter(entry, side.m, normal, owner);
}

// Whether m lies in faces that do not move, even if it is in the zone.
bool ActiveSet::midpoint_stays(const Split& s) const {
    return staying_.contains(TriMesh::face(mesh_.half_edge(s.bm)));
}

// Faces 1 and 3, then 2 and 4.
void ActiveSet::log_faces(std::size_t first, const Split& s) {
    const HalfEdgeId bm = mesh_.half_edge(s.bm);
    log_.set_face(first, TriMesh::face(bm));
    log_.set_face(first + 1, s.face3);
    staying_.record_piece(TriMesh::face(bm), s.face3);
    if (!s.right) return;
    log_.set_face(first + 2, TriMesh::face(mesh_.twin(bm)));
    log_.set_face(first + 3, s.face4);
    staying_.record_piece(TriMesh::face(mesh_.twin(bm)), s.face4);
}

void ActiveSet::allocate_splits(std::uint32_t count, ReservedSlots& slots) {
    slots.entries.resize(count);
    if (split_capacity_ < count) reserve_splits(count);
    slots.ids.resize(count);
    split_capacity_ -= count;
    mesh_.allocate_splits(slots.ids.ids());
    for (std::uint32_t i = 0; i < count; ++i) {
        const SplitIds& ids = slots.ids.ids()[i];
        slots.entries[i] = {rest_.allocate(ids.m),
                            rest_.allocate(ids.wedge),
                            {rest_.allocate(ids.mc, true), rest_.allocate(ids.am, true),
                             rest_.allocate(ids.dm, true)}};
    }
    slots.first_edit = log_.grow_splits(count);
    slots.first_face = log_.grow_faces(EditLog::kFacesPerSheet * count);
}

ActiveSet::Inserted ActiveSet::concurrent_split(EdgeId e, ReservedSlots& slots, std::size_t i) {
    assert(entry_of(e) && smooth_edges()[*entry_of(e)] != 0);
    const float length = rest_.cached_length(e), half_length = 0.5f * length;
    rest_.record_length(length);
    rest_.set_length(e, half_length);

    const ReservedSlots::Entries& entries = slots.entries[i];
    const Split s = mesh_.insert_midpoint(e, slots.ids.take(i));
    log_.set_edit(slots.first_edit + i, TopologyEdit::split(e));
    const Vec3 rest = 0.5 * rest_.position(s.b) + 0.5 * rest_.position(s.c);
    mesh_.set_position(s.m, rest);
    rest_.enter(entries.vertex, s.m, rest, mesh_.is_deformed(s.m), midpoint_stays(s));
    rest_.enter(entries.edges[0], s.mc, half_length);
    rest_.enter_spoke(entries.edges[1], s.am, s.a, rest);
    rest_.enter_spoke(entries.edges[2], s.dm, s.d, rest);
    insert_side(s.left, entries.wedge, entries.vertex,
                [&] { return rest_.area_normal(s.b, s.c, s.a); });
    log_faces(slots.first_face + EditLog::kFacesPerSheet * i, s);
    return {.vertex_entry = entries.vertex,
            .wedge_entries = {entries.wedge, kNoEntry},
            .edges = {s.bm, s.mc, s.am, s.dm}};
}

void ActiveSet::reserve_unsplits(std::size_t sheets) {
    mesh_.reserve_unsplits(sheets);
    rest_.reserve_unsplits(sheets);
    log_.reserve(sheets);
    reserve_errors(sheets);
}

void ActiveSet::reserve_errors(std::size_t sheets) {
    if (mesh_.tracks_errors()) errors_.reserve(4 * sheets);
}

void ActiveSet::unsplit(const Star& star) {
    std::size_t sheets = 0;
    mesh_.for_each_sheet(star, [&](const Star&) { ++sheets; });
    reserve_unsplits(sheets);
    rest_.reserve_rim(sheets);
    split_capacity_ = 0;
    mesh_.for_each_sheet(star, [this](const Star& sheet) { drop_sheet(sheet); });
    const std::uint32_t entry = rest_.remove(star.m);
    const bool was_inserted = rest_.is_inserted_vertex(entry);
    if (was_inserted) rest_.vertex_table().push_free(entry);
    const EdgeId bc = mesh_.unsplit(star);
    log_.log_unsplit(bc);
    mesh_.for_each_side(bc, [&](HalfEdgeId h) {
        const EdgeId e = mesh_.edge(h);
        rest_.enter_restored(e);
        rest_.forget_length(e);
        if (!was_inserted) rest_.record_length(rest_.length(e));  // otherwise the split has done so
    });
}

// Logs the faces of one sheet and removes the entries of its wedges at m.
void ActiveSet::drop_sheet(const Star& star) {
    for (HalfEdgeId h : {star.mc, star.bm}) log_.log_face(TriMesh::face(h));
    merge_errors(star);
    const WedgeId left = mesh_.wedge(star.mc);
    rest_.remove_or_keep(left);
    if (star.on_boundary()) return;
    for (HalfEdgeId h : {star.mb, star.cm}) log_.log_face(TriMesh::face(h));
    const WedgeId right = mesh_.wedge(star.mb);
    if (right != left) rest_.remove_or_keep(right);
}

//          a                  a
//         /|\                / \         A point of the pieces 1 and 3 is beside its point of the
//        /1|3\              / 1 \        merged face by a part of the vector from the middle of bc
//       b--m--c    --->    b-----c       to m, and likewise on the other side.
//        \2|4/              \ 2 /
//         \|/                \ /
//          d                  d
ErrorEllipsoid ActiveSet::merged_error(const Star& star, HalfEdgeId h) const {
    const HalfEdgeId other = h == star.bm ? star.mc : star.cm;
    return ErrorEllipsoid::sum(
        ErrorEllipsoid::hull(mesh_.error(TriMesh::face(h)), mesh_.error(TriMesh::face(other))),
        ErrorEllipsoid::segment(from_middle(star)));
}

Vec3 ActiveSet::from_middle(const Star& star) const {
    const Vec3 middle = 0.5 * rest_.position(star.b) + 0.5 * rest_.position(star.c);
    return rest_.position(star.m) - middle;
}

bool ActiveSet::merges_exactly(const Star& star) const {
    const auto are_equal = [&](HalfEdgeId h, HalfEdgeId other) {
        return mesh_.error(TriMesh::face(h)) == mesh_.error(TriMesh::face(other));
    };
    return from_middle(star) == Vec3{0.0} && are_equal(star.bm, star.mc) &&
           (star.on_boundary() || are_equal(star.mb, star.cm));
}

// Gives the kept faces of one sheet their errors after the unsplit, and logs those before it.
void ActiveSet::merge_errors(const Star& star) {
    if (!mesh_.tracks_errors()) return;
    const auto merge = [&](HalfEdgeId kept, HalfEdgeId freed) {
        const FaceId f = TriMesh::face(kept), g = TriMesh::face(freed);
        const ErrorEllipsoid merged = merged_error(star, kept);
        errors_.record(f, mesh_.error(f));
        errors_.record(g, mesh_.error(g));
        mesh_.set_error(f, merged);
    };
    merge(star.bm, star.mc);
    if (!star.on_boundary()) merge(star.mb, star.cm);
}

void ActiveSet::set_errors(std::span<const FaceId> faces, std::span<const ErrorEllipsoid> errors) {
    assert(faces.size() == errors.size());
    errors_.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        errors_.record(faces[i], mesh_.error(faces[i]));
        mesh_.set_error(faces[i], errors[i]);
    }
}

bool ActiveSet::may_unsplit_concurrently(const Star& star) const {
    if (star.on_boundary() || mesh_.wedge(star.mb) != mesh_.wedge(star.mc)) return false;
    return entry_of(mesh_.edge(star.bm)) && rest_.entry(mesh_.wedge(star.mc)) != kNoEntry;
}

ActiveSet::Unsplit ActiveSet::concurrent_unsplit(const Star& star, FormerErrors* errors) {
    Unsplit done{.ids = {},
                 .bc = mesh_.edge(star.bm),
                 .kept_faces = {TriMesh::face(star.bm), TriMesh::face(star.mb)},
                 .vertex_entry = kNoEntry,
                 .wedge_entry = kNoEntry};
    if (mesh_.tracks_errors()) {
        assert(errors);
        const std::array<ErrorEllipsoid, 2> merged{merged_error(star, star.bm),
                                                   merged_error(star, star.mb)};
        const auto& [first, second] = done.kept_faces;
        *errors = {mesh_.error(first), mesh_.error(second), mesh_.error(TriMesh::face(star.mc)),
                   mesh_.error(TriMesh::face(star.cm))};
        mesh_.set_error(first, merged[0]);
        mesh_.set_error(second, merged[1]);
    }
    done.vertex_entry = rest_.remove(star.m);
    done.wedge_entry = rest_.remove(mesh_.wedge(star.mc));
    done.ids = mesh_.remove_midpoint(star);
    rest_.forget_length(done.bc);
    if (!rest_.is_inserted_vertex(done.vertex_entry)) {
        rest_.record_length(rest_.cached_length(done.bc));
    }
    return done;
}

ActiveSet::UnsplitCount ActiveSet::count(std::span<const Unsplit> unsplits) const {
    UnsplitCount count{.unsplits = unsplits.size()};
    for (const Unsplit& done : unsplits) {
        if (rest_.is_inserted_vertex(done.vertex_entry)) ++count.vertex_entries;
        if (rest_.is_inserted_wedge(done.wedge_entry)) ++count.wedge_entries;
    }
    return count;
}

ActiveSet::ReservedLogSlots ActiveSet::allocate_unsplits(const UnsplitCount& count) {
    split_capacity_ = 0;  // the log has less room for splits now
    return {.edit = log_.grow_unsplits(count.unsplits),
            .face = log_.grow_faces(EditLog::kFacesPerSheet * count.unsplits),
            .vertex_entry = rest_.vertex_table().grow_free(count.vertex_entries),
            .wedge_entry = rest_.wedge_table().grow_free(count.wedge_entries),
            .error = mesh_.tracks_errors() ? errors_.grow(4 * count.unsplits) : 0,
            .freed = mesh_.allocate_freed(count.unsplits)};
}

void ActiveSet::log_unsplits(std::span<const Unsplit> unsplits,
                             std::span<const FormerErrors> errors, ReservedLogSlots at) {
    for (std::size_t i = 0; i < unsplits.size(); ++i) {
        const Unsplit& done = unsplits[i];
        log_.set_edit(at.edit++, TopologyEdit::unsplit(done.bc));
        for (FaceId f : {done.ids.face3, done.kept_faces[0], done.kept_faces[1], done.ids.face4}) {
            log_.set_face(at.face++, f);
        }
        if (mesh_.tracks_errors()) {
            errors_.set(at.error++, done.kept_faces[0], errors[i][0]);
            errors_.set(at.error++, done.kept_faces[1], errors[i][1]);
            errors_.set(at.error++, done.ids.face3, errors[i][2]);
            errors_.set(at.error++, done.ids.face4, errors[i][3]);
        }
        mesh_.free_split(done.ids, at.freed, i);
        if (rest_.is_inserted_vertex(done.vertex_entry)) {
            rest_.vertex_table().set_free(at.vertex_entry++, done.vertex_entry);
        }
        if (rest_.is_inserted_wedge(done.wedge_entry)) {
            rest_.wedge_table().set_free(at.wedge_entry++, done.wedge_entry);
        }
    }
}

}  // namespace pectin
