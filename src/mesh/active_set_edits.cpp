// Splits and unsplits of an active set, and the entries they make.
#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/active_set.h"
#include "mesh/midpoint_normal.h"

namespace pectin {

// --- Entries: of elements that are there, or that a split has just added. What the allocated entry
// holds is for enter() to write.

std::uint32_t ActiveSet::allocate_vertex_entry(VertexId v) {
    if (index(v) == vertex_entry_.size()) vertex_entry_.grow_unchecked(1);
    if (!free_vertex_entries_.empty()) return free_vertex_entries_.pop_value();
    vertices_.grow_unchecked(1);
    rest_positions_.grow_unchecked(1);
    was_deformed_.grow_unchecked(1);
    return vertex_entries() - 1;
}

std::uint32_t ActiveSet::allocate_wedge_entry(WedgeId w) {
    if (index(w) == wedge_entry_.size()) wedge_entry_.grow_unchecked(1);
    if (!free_wedge_entries_.empty()) return free_wedge_entries_.pop_value();
    wedges_.grow_unchecked(1);
    rest_normals_.grow_unchecked(1);
    wedge_owners_.grow_unchecked(1);
    return wedge_entries() - 1;
}

std::uint32_t ActiveSet::allocate_edge_entry(EdgeId e, bool smooth) {
    const std::uint8_t mark = smooth ? 1 : 0;
    const bool is_new = index(e) == edge_states_.size();
    if (is_new) edge_states_.grow_unchecked(1);
    if (is_new || edge_states_[index(e)].entry == kNoEntry) {
        edges_.push_back(e);
        is_smooth_.push_back(mark);
        return static_cast<std::uint32_t>(edges_.size()) - 1;
    }
    const std::uint32_t entry = edge_states_[index(e)].entry;
    if (is_smooth_[entry] != mark) {
        if (entry < original_edges_) flipped_smooth_.push_back(entry);
        is_smooth_[entry] = mark;
    }
    return entry;
}

void ActiveSet::enter(std::uint32_t entry, VertexId v, const Vec3& rest, bool was_deformed) {
    assert(index(v) < vertex_entry_.size());
    vertex_entry_[index(v)] = entry;
    vertices_[entry] = v;
    rest_positions_[entry] = rest;
    was_deformed_[entry] = was_deformed ? 1 : 0;
}

void ActiveSet::enter(std::uint32_t entry, WedgeId w, const Vec3f& rest, std::uint32_t owner) {
    wedge_entry_[index(w)] = entry;
    wedges_[entry] = w;
    rest_normals_[entry] = rest;
    wedge_owners_[entry] = owner;
}

void ActiveSet::enter(std::uint32_t entry, EdgeId e, float rest_length) {
    assert(index(e) < edge_states_.size());
    edge_states_[index(e)] = {entry, rest_length};
}

// am or dm.
void ActiveSet::enter_spoke(std::uint32_t entry, EdgeId e, VertexId apex, const Vec3& m) {
    const float length = spoke_rest_length(apex, m);
    enter(entry, e, length);
    record_length(length);
}

// visit(array, elements that a split adds to it at most in one sheet).
template <typename Visit>
void ActiveSet::for_each_array_of_splits(Visit visit) {
    visit(vertices_, 1);
    visit(rest_positions_, 1);
    visit(was_deformed_, 1);
    visit(vertex_entry_, 1);
    visit(wedges_, 2);
    visit(rest_normals_, 2);
    visit(wedge_owners_, 2);
    visit(wedge_entry_, 2);
    visit(edges_, 4);
    visit(is_smooth_, 4);
    visit(flipped_smooth_, 4);
    visit(edge_states_, 3);
    visit(faces_, 4);
    visit(edits_, 1);
}

void ActiveSet::reserve_splits(std::uint32_t count) {
    mesh_.reserve_splits(count);
    std::size_t splits = std::numeric_limits<std::uint32_t>::max();
    for_each_array_of_splits([&](auto& values, std::size_t a_split) {
        values.reserve_additional(a_split * count);
        splits = std::min(splits, (values.capacity() - values.size()) / a_split);
    });
    split_capacity_ = static_cast<std::uint32_t>(splits);
}

// Before anything is changed: without the memory nothing has happened.
void ActiveSet::reserve_for_split(EdgeId e) {
    std::uint32_t sheets = 1;
    for (EdgeId s = mesh_.sibling(e); s != e; s = mesh_.sibling(s)) ++sheets;
    if (split_capacity_ < sheets) reserve_splits(sheets);
    split_capacity_ -= sheets;
}

Split ActiveSet::split(EdgeId e, std::vector<Inserted>& inserted) {
    reserve_for_split(e);
    const float length = rest_length(e), half_length = 0.5f * length;
    record_length(length);  // of its halves, too, and of what an unsplit restores

    const Split s = mesh_.insert_midpoint(e);
    edits_.push_back_unchecked(TopologyEdit::split(s.bm));
    ++splits_;
    const Vec3 rest = 0.5 * rest_position(s.b) + 0.5 * rest_position(s.c);
    mesh_.set_position(s.m, rest);
    const std::uint32_t vertex_entry = allocate_vertex_entry(s.m);
    enter(vertex_entry, s.m, rest, mesh_.is_deformed(s.m));
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

// The rest state of what a split has made in one sheet.
void ActiveSet::insert_sheet(const Split& s, std::uint32_t vertex_entry, float half_length,
                             Inserted& made) {
    const Vec3& m = rest_positions_[vertex_entry];
    const bool is_smooth = s.right ? s.is_smooth() : mesh_.sibling(s.bm) == s.bm;
    made.vertex_entry = vertex_entry;
    made.is_smooth = is_smooth;
    made.edges = {s.bm, s.mc, s.am, s.dm};
    enter(allocate_edge_entry(s.bm, is_smooth), s.bm, half_length);
    enter(allocate_edge_entry(s.mc, is_smooth), s.mc, half_length);
    enter_spoke(allocate_edge_entry(s.am, true), s.am, s.a, m);
    made.wedge_entries[0] = allocate_wedge_entry(s.left.m);
    insert_side(s.left, made.wedge_entries[0], vertex_entry,
                [&] { return rest_area_normal(s.b, s.c, s.a); });
    const std::size_t first_face = faces_.size();
    faces_.grow_unchecked(s.right ? 4 : 2);
    log_faces(first_face, s);
    if (!s.right) return;

    enter_spoke(allocate_edge_entry(s.dm, true), s.dm, s.d, m);
    if (is_smooth) return;
    made.wedge_entries[1] = allocate_wedge_entry(s.right->m);
    insert_side(*s.right, made.wedge_entries[1], vertex_entry,
                [&] { return rest_area_normal(s.b, s.d, s.c); });
}

void ActiveSet::allocate_splits(std::uint32_t count, ReservedSlots& slots) {
    slots.ids.resize(count);
    slots.entries.resize(count);
    if (split_capacity_ < count) reserve_splits(count);
    split_capacity_ -= count;
    slots.first_edit = edits_.size();
    slots.first_face = faces_.size();
    mesh_.allocate_splits(slots.ids);
    for (std::uint32_t i = 0; i < count; ++i) {
        const SplitIds& ids = slots.ids[i];
        slots.entries[i] = {allocate_vertex_entry(ids.m),
                            allocate_wedge_entry(ids.wedge),
                            {allocate_edge_entry(ids.mc, true), allocate_edge_entry(ids.am, true),
                             allocate_edge_entry(ids.dm, true)}};
    }
    edits_.grow_unchecked(count);
    faces_.grow_unchecked(4 * std::size_t{count});
    splits_ += count;
}

ActiveSet::Inserted ActiveSet::concurrent_split(EdgeId e, const ReservedSlots& slots,
                                                std::size_t i) {
    EdgeState& state = edge_states_[index(e)];
    assert(state.entry != kNoEntry && is_smooth_[state.entry] != 0);
    const float length = cached_rest_length(e), half_length = 0.5f * length;
    record_length(length);
    state.rest_length = half_length;

    const ReservedSlots::Entries& entries = slots.entries[i];
    const Split s = mesh_.insert_midpoint(e, slots.ids[i]);
    edits_[slots.first_edit + i] = TopologyEdit::split(e);
    const Vec3 rest = 0.5 * rest_position(s.b) + 0.5 * rest_position(s.c);
    mesh_.set_position(s.m, rest);
    enter(entries.vertex, s.m, rest, mesh_.is_deformed(s.m));
    enter(entries.edges[0], s.mc, half_length);
    enter_spoke(entries.edges[1], s.am, s.a, rest);
    enter_spoke(entries.edges[2], s.dm, s.d, rest);
    insert_side(s.left, entries.wedge, entries.vertex,
                [&] { return rest_area_normal(s.b, s.c, s.a); });
    log_faces(slots.first_face + 4 * i, s);
    return {.vertex_entry = entries.vertex,
            .wedge_entries = {entries.wedge, kNoEntry},
            .edges = {s.bm, s.mc, s.am, s.dm}};
}

template <typename AreaNormal>
void ActiveSet::insert_side(const Split::Side& side, std::uint32_t entry, std::uint32_t owner,
                            const AreaNormal& area_normal) {
    const Vec3f normal = midpoint_normal(rest_normal(side.b), rest_normal(side.c), area_normal);
    mesh_.set_normal(side.m, normal);
    enter(entry, side.m, normal, owner);
}

// The two or four at the edge that was split.
void ActiveSet::log_faces(std::size_t first, const Split& s) {
    const HalfEdgeId bm = mesh_.half_edge(s.bm);
    faces_[first] = TriMesh::face(bm);
    faces_[first + 1] = s.face3;
    if (!s.right) return;
    faces_[first + 2] = TriMesh::face(mesh_.twin(bm));
    faces_[first + 3] = s.face4;
}

Vec3 ActiveSet::rest_area_normal(VertexId p, VertexId q, VertexId r) const {
    const Vec3 from = rest_position(p);
    return glm::cross(rest_position(q) - from, rest_position(r) - from);
}

// Of vertices with so many sheets in all: the most that they leave behind.
void ActiveSet::reserve_unsplits(std::size_t sheets) {
    mesh_.reserve_unsplits(sheets);
    edits_.reserve_additional(sheets);
    faces_.reserve_additional(4 * sheets);
    free_vertex_entries_.reserve_additional(sheets);
    free_wedge_entries_.reserve_additional(2 * sheets);
}

void ActiveSet::unsplit(const Star& star) {
    std::size_t sheets = 0;
    mesh_.for_each_sheet(star, [&](const Star&) { ++sheets; });
    reserve_unsplits(sheets);
    edges_.reserve_additional(2 * sheets);  // what the rim of the active set has none of
    is_smooth_.reserve_additional(2 * sheets);
    flipped_smooth_.reserve_additional(2 * sheets);
    measured_edges_.reserve_additional(2 * sheets);
    lost_wedges_.reserve_additional(2 * sheets);
    lost_normals_.reserve_additional(2 * sheets);
    split_capacity_ = 0;
    mesh_.for_each_sheet(star, [this](const Star& sheet) { drop_sheet(sheet); });
    std::uint32_t& entry = vertex_entry_[index(star.m)];
    vertices_[entry] = kNone<VertexId>;
    const bool was_inserted = entry >= original_vertices_;
    if (was_inserted) free_vertex_entries_.push_back(entry);
    entry = kNoEntry;
    const EdgeId bc = mesh_.unsplit(star);
    edits_.push_back(TopologyEdit::unsplit(bc));
    mesh_.for_each_side(bc, [&](HalfEdgeId h) {
        const EdgeId e = mesh_.edge(h);
        if (edge_states_[index(e)].entry == kNoEntry) {
            enter(allocate_edge_entry(e, has_smooth_normals(e)), e, kUnmeasured);
        }
        edge_states_[index(e)].rest_length = kUnmeasured;
        if (!was_inserted) record_length(rest_length(e));  // else its split has
    });
}

bool ActiveSet::may_unsplit_concurrently(const Star& star) const {
    if (star.on_boundary() || mesh_.wedge(star.mb) != mesh_.wedge(star.mc)) return false;
    return entry_of(mesh_.edge(star.bm)) && slot(wedge_entry_, mesh_.wedge(star.mc)) != kNoEntry;
}

ActiveSet::Unsplit ActiveSet::concurrent_unsplit(const Star& star) {
    std::uint32_t& vertex_entry = vertex_entry_[index(star.m)];
    std::uint32_t& wedge_entry = wedge_entry_[index(mesh_.wedge(star.mc))];
    Unsplit done{.ids = {},
                 .bc = mesh_.edge(star.bm),
                 .kept_faces = {TriMesh::face(star.bm), TriMesh::face(star.mb)},
                 .vertex_entry = vertex_entry,
                 .wedge_entry = wedge_entry};
    vertices_[vertex_entry] = kNone<VertexId>;
    wedges_[wedge_entry] = kNone<WedgeId>;
    vertex_entry = wedge_entry = kNoEntry;
    done.ids = mesh_.remove_midpoint(star);
    edge_states_[index(done.bc)].rest_length = kUnmeasured;
    if (done.vertex_entry < original_vertices_) record_length(cached_rest_length(done.bc));
    return done;
}

ActiveSet::UnsplitCount ActiveSet::count(std::span<const Unsplit> unsplits) const {
    UnsplitCount count{.unsplits = unsplits.size()};
    for (const Unsplit& done : unsplits) {
        if (done.vertex_entry >= original_vertices_) ++count.vertex_entries;
        if (done.wedge_entry >= original_wedges_) ++count.wedge_entries;
    }
    return count;
}

ActiveSet::ReservedLogSlots ActiveSet::allocate_unsplits(const UnsplitCount& count) {
    const ReservedLogSlots first{edits_.size(), faces_.size(), free_vertex_entries_.size(),
                                 free_wedge_entries_.size(), mesh_.allocate_freed(count.unsplits)};
    edits_.grow_unchecked(count.unsplits);
    faces_.grow_unchecked(4 * count.unsplits);
    free_vertex_entries_.grow_unchecked(count.vertex_entries);
    free_wedge_entries_.grow_unchecked(count.wedge_entries);
    split_capacity_ = 0;  // splits find less now
    return first;
}

void ActiveSet::log_unsplits(std::span<const Unsplit> unsplits, ReservedLogSlots at) {
    for (std::size_t i = 0; i < unsplits.size(); ++i) {
        const Unsplit& done = unsplits[i];
        edits_[at.edit++] = TopologyEdit::unsplit(done.bc);
        for (FaceId f : {done.ids.face3, done.kept_faces[0], done.kept_faces[1], done.ids.face4}) {
            faces_[at.face++] = f;
        }
        mesh_.free_split(done.ids, at.freed, i);
        if (done.vertex_entry >= original_vertices_)
            free_vertex_entries_[at.vertex_entry++] = done.vertex_entry;
        if (done.wedge_entry >= original_wedges_)
            free_wedge_entries_[at.wedge_entry++] = done.wedge_entry;
    }
}

// Forgets what an unsplit takes from one sheet.
void ActiveSet::drop_sheet(const Star& star) {
    for (HalfEdgeId h : {star.mc, star.bm}) faces_.push_back(TriMesh::face(h));
    const WedgeId left = mesh_.wedge(star.mc);
    drop_wedge(left);
    if (star.on_boundary()) return;
    for (HalfEdgeId h : {star.mb, star.cm}) faces_.push_back(TriMesh::face(h));
    const WedgeId right = mesh_.wedge(star.mb);
    if (right != left) drop_wedge(right);
}

void ActiveSet::drop_wedge(WedgeId w) {
    const std::uint32_t entry = slot(wedge_entry_, w);
    if (entry == kNoEntry) {
        lost_wedges_.push_back(w);
        lost_normals_.push_back(mesh_.normal(w));
        return;
    }
    wedges_[entry] = kNone<WedgeId>;
    if (entry >= original_wedges_) free_wedge_entries_.push_back(entry);
    wedge_entry_[index(w)] = kNoEntry;
}

}  // namespace pectin
