// Splits and unsplits of an active set, and the entries they make.
#include <cassert>
#include <utility>

#include "mesh/active_set.h"
#include "mesh/midpoint_normal.h"

namespace pectin {
namespace {

// Of an element that is there, or that a split has just added.
template <typename T, typename Id>
T& grown(GrowingArray<T>& values, Id id, T fill) {
    if (index(id) == values.size()) values.push_into_room(fill);
    assert(index(id) < values.size());
    return values[index(id)];
}

}  // namespace

std::uint32_t ActiveSet::add_vertex(VertexId v, const Vec3& rest, bool was_deformed) {
    const std::uint8_t mark = was_deformed ? 1 : 0;
    std::uint32_t entry = vertex_entries();
    if (!free_vertex_entries_.empty()) {
        entry = free_vertex_entries_.take_back();
        vertices_[entry] = v;
        rest_positions_[entry] = rest;
        was_deformed_[entry] = mark;
    } else {
        vertices_.push_into_room(v);
        rest_positions_.push_into_room(rest);
        was_deformed_.push_into_room(mark);
    }
    grown(vertex_entry_, v, kNoEntry) = entry;
    return entry;
}

std::uint32_t ActiveSet::add_wedge(WedgeId w, const Vec3f& rest, std::uint32_t owner) {
    std::uint32_t entry = wedge_entries();
    if (!free_wedge_entries_.empty()) {
        entry = free_wedge_entries_.take_back();
        wedges_[entry] = w;
        rest_normals_[entry] = rest;
        wedge_owners_[entry] = owner;
    } else {
        wedges_.push_into_room(w);
        rest_normals_.push_into_room(rest);
        wedge_owners_.push_into_room(owner);
    }
    grown(wedge_entry_, w, kNoEntry) = entry;
    return entry;
}

ActiveSet::EdgeState& ActiveSet::add_edge(EdgeId e, bool one_look) {
    EdgeState& state = grown(edge_states_, e, EdgeState{});
    if (state.entry == kNoEntry) {
        state.entry = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back(e);
        one_look_.push_back({});
    }
    const std::uint8_t look = one_look ? 1 : 0;
    if (one_look_[state.entry] != look) {
        if (state.entry < original_edges_) turned_looks_.push_back(state.entry);
        one_look_[state.entry] = look;
    }
    return state;
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
    visit(one_look_, 4);
    visit(edge_states_, 3);
    visit(faces_, 4);
    visit(edits_, 1);
}

void ActiveSet::reserve_splits(std::uint32_t count) {
    mesh_.reserve_splits(count);
    for_each_array_of_splits([&](auto& values, std::size_t a_split) {
        const std::size_t added = a_split * count;
        if (values.capacity() - values.size() < added) values.reserve(2 * values.size() + added);
    });
    room_ = count;
}

void ActiveSet::add_room(std::uint32_t after, std::uint32_t count, MemoryAhead& ahead) {
    mesh_.add_room(after, count, ahead);
    for_each_array_of_splits([&](auto& values, std::size_t a_split) {
        ahead.add(values.room(a_split * after, a_split * count));
    });
}

// Before anything is changed: without the memory nothing has happened.
void ActiveSet::make_room(EdgeId e) {
    std::uint32_t sheets = 1;
    for (EdgeId s = mesh_.sibling(e); s != e; s = mesh_.sibling(s)) ++sheets;
    if (room_ < sheets) reserve_splits(sheets);
    room_ -= sheets;
}

Split ActiveSet::split(EdgeId e, std::vector<Inserted>& inserted) {
    make_room(e);
    const float length = rest_length(e), half_length = 0.5f * length;
    note_length(length);  // of its halves, too, and of what an unsplit restores

    const Split s = mesh_.insert_midpoint(e);
    edits_.push_into_room(TopologyEdit::split(s.bm));
    ++splits_;
    const Vec3 rest = 0.5 * rest_position(s.b) + 0.5 * rest_position(s.c);
    mesh_.set_position(s.m, rest);
    const std::uint32_t vertex_entry = add_vertex(s.m, rest, mesh_.is_deformed(s.m));
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
    const bool is_smooth = s.right ? s.right->m == s.left.m : mesh_.sibling(s.bm) == s.bm;
    add_edge(s.bm, is_smooth).rest_length = half_length;
    add_edge(s.mc, is_smooth).rest_length = half_length;
    insert_spoke(s.am, s.a, vertex_entry);
    made.vertex_entry = vertex_entry;
    made.is_one_look = is_smooth;
    made.edges = {s.bm, s.mc, s.am, s.dm};
    made.wedge_entries[0] =
        insert_side(s.left, vertex_entry, [&] { return rest_area_normal(s.b, s.c, s.a); });
    const HalfEdgeId bm = mesh_.half_edge(s.bm);
    faces_.push_into_room(TriMesh::face(bm));
    faces_.push_into_room(s.face3);
    if (!s.right) return;

    insert_spoke(s.dm, s.d, vertex_entry);
    faces_.push_into_room(TriMesh::face(mesh_.twin(bm)));
    faces_.push_into_room(s.face4);
    if (is_smooth) return;
    made.wedge_entries[1] =
        insert_side(*s.right, vertex_entry, [&] { return rest_area_normal(s.b, s.d, s.c); });
}

// am or dm.
void ActiveSet::insert_spoke(EdgeId e, VertexId apex, std::uint32_t vertex_entry) {
    const auto length =
        static_cast<float>(glm::distance(rest_position(apex), rest_positions_[vertex_entry]));
    add_edge(e, true).rest_length = length;
    note_length(length);
}

template <typename AreaNormal>
std::uint32_t ActiveSet::insert_side(const Split::Side& side, std::uint32_t owner,
                                     const AreaNormal& area_normal) {
    const Vec3f normal = midpoint_normal(rest_normal(side.b), rest_normal(side.c), area_normal);
    mesh_.set_normal(side.m, normal);
    return add_wedge(side.m, normal, owner);
}

Vec3 ActiveSet::rest_area_normal(VertexId p, VertexId q, VertexId r) const {
    const Vec3 from = rest_position(p);
    return glm::cross(rest_position(q) - from, rest_position(r) - from);
}

void ActiveSet::unsplit(const Star& star) {
    room_ = 0;
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
        if (edge_states_[index(e)].entry == kNoEntry) add_edge(e, one_look_is_enough(e));
        edge_states_[index(e)].rest_length = kUnmeasured;
        if (!was_inserted) note_length(rest_length(e));  // else its split has
    });
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
