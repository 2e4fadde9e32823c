#include "mesh/active_set.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "mesh/array_bytes.h"
#include "mesh/midpoint_normal.h"
#include "mesh/sort_ids.h"

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

void ActiveSet::begin(std::span<const FaceId> faces, const Box& zone) {
    assert(!begun_);
    begun_ = true;
    zone_ = zone;
    slots_at_begin_ = mesh_.slot_counts();
    room_ = 0;
    fit_to_mesh();
    faces_.clear();
    faces_.append(faces);
    original_faces_ = faces_.size();
    collect(faces);
    original_vertices_ = vertex_entries();
    original_wedges_ = wedge_entries();
    original_edges_ = static_cast<std::uint32_t>(edges_.size());
    original_ids_ = vertices_;
    original_wedge_ids_ = wedges_;
}

void ActiveSet::fit_to_mesh() {
    const auto fit = [](auto& values, std::uint32_t slots, auto fill) {
        if (values.size() < slots) values.resize(slots, fill);
    };
    fit(vertex_entry_, mesh_.vertex_slots(), kNoEntry);
    fit(wedge_entry_, mesh_.wedge_slots(), kNoEntry);
    fit(edge_states_, mesh_.edge_slots(), EdgeState{});
}

void ActiveSet::collect(std::span<const FaceId> faces) {
    std::vector<VertexId> corners;
    std::vector<WedgeId> wedges;
    for (FaceId f : faces) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdge& h = mesh_.half_edge(TriMesh::half_edge(f, corner));
            if (vertex_entry_[index(h.origin)] == kNoEntry) {
                vertex_entry_[index(h.origin)] = 0;
                corners.push_back(h.origin);
            }
            if (wedge_entry_[index(h.wedge)] == kNoEntry) {
                wedge_entry_[index(h.wedge)] = index(h.origin);  // its vertex, until it is entered
                wedges.push_back(h.wedge);
            }
            add_edge(h.edge, false);
        }
    }
    sort_ids(std::span(edges_));
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        edge_states_[index(edges_[i])].entry = i;
        one_look_[i] = one_look_is_enough(edges_[i]) ? 1 : 0;
        longest_square_ = std::max(longest_square_, mesh_.squared_length(edges_[i]));
    }

    sort_ids(std::span(corners));
    const auto first_still = std::stable_partition(corners.begin(), corners.end(), [&](VertexId v) {
        return zone_.contains_strictly(mesh_.position(v));
    });
    influenced_ = static_cast<std::uint32_t>(first_still - corners.begin());
    vertices_.reserve(corners.size());
    rest_positions_.reserve(corners.size());
    was_deformed_.reserve(corners.size());
    for (VertexId v : corners) add_vertex(v, mesh_.position(v), mesh_.is_deformed(v));

    sort_ids(std::span(wedges));
    const auto owner = [&](WedgeId w) { return vertex_entry_[wedge_entry_[index(w)]]; };
    const auto first_still_wedge = std::stable_partition(
        wedges.begin(), wedges.end(), [&](WedgeId w) { return owner(w) < influenced_; });
    influenced_wedges_ = static_cast<std::uint32_t>(first_still_wedge - wedges.begin());
    wedges_.reserve(wedges.size());
    rest_normals_.reserve(wedges.size());
    wedge_owners_.reserve(wedges.size());
    for (WedgeId w : wedges) add_wedge(w, mesh_.normal(w), owner(w));
}

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

bool ActiveSet::one_look_is_enough(EdgeId e) const {
    const HalfEdgeId h = mesh_.half_edge(e), twin = mesh_.twin(h);
    if (!exists(twin)) return mesh_.sibling(e) == e;
    return mesh_.wedge(h) == mesh_.wedge(TriMesh::next(twin)) &&
           mesh_.wedge(twin) == mesh_.wedge(TriMesh::next(h));
}

// Of an edge that was not there at the beginning, rounded to float.
void ActiveSet::note_length(float rest_length) {
    const double length = (1.0 + 1e-6) * static_cast<double>(rest_length);
    longest_square_ = std::max(longest_square_, length * length);
}

float ActiveSet::distance_at_rest(EdgeId e) const {
    const HalfEdgeId h = mesh_.half_edge(e);
    return static_cast<float>(
        glm::distance(rest_position(mesh_.origin(h)), rest_position(mesh_.target(h))));
}

float ActiveSet::measure(EdgeId e) {
    if (index(e) >= edge_states_.size()) edge_states_.resize(index(e) + std::size_t{1});
    EdgeState& state = edge_states_[index(e)];
    state.rest_length = distance_at_rest(e);
    if (state.entry == kNoEntry) measured_edges_.push_back(e);
    return state.rest_length;
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
    made.wedge_entries[0] = insert_side(
        s.left, vertex_entry, [&] { return rest_area_normal(s.b, s.c, s.a); });
    const HalfEdgeId bm = mesh_.half_edge(s.bm);
    faces_.push_into_room(TriMesh::face(bm));
    faces_.push_into_room(s.face3);
    if (!s.right) return;

    insert_spoke(s.dm, s.d, vertex_entry);
    faces_.push_into_room(TriMesh::face(mesh_.twin(bm)));
    faces_.push_into_room(s.face4);
    if (is_smooth) return;
    made.wedge_entries[1] = insert_side(
        *s.right, vertex_entry, [&] { return rest_area_normal(s.b, s.d, s.c); });
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

void ActiveSet::roll_back() {
    take_back(edits_, mesh_);
    mesh_.truncate(slots_at_begin_);
    for (std::size_t i = 0; i < lost_wedges_.size(); ++i) {
        mesh_.set_normal(lost_wedges_[i], lost_normals_[i]);
    }
    drop_inserted();
    for (std::uint32_t i = 0; i < original_vertices_; ++i) {
        const VertexId v = vertices_[i] = original_ids_[i];
        vertex_entry_[index(v)] = i;
        mesh_.set_position(v, rest_positions_[i]);
        mesh_.set_deformed(v, was_deformed_[i] != 0);
    }
    for (std::uint32_t i = 0; i < original_wedges_; ++i) {
        const WedgeId w = wedges_[i] = original_wedge_ids_[i];
        wedge_entry_[index(w)] = i;
        mesh_.set_normal(w, rest_normals_[i]);
    }
    for (std::uint32_t i = 0; i < original_edges_; ++i) edge_states_[index(edges_[i])].entry = i;
    for (std::uint32_t entry : turned_looks_) one_look_[entry] ^= 1;
    turned_looks_.clear();
}

// Cuts the entries back to those of the beginning.
void ActiveSet::drop_inserted() {
    for (std::uint32_t i = original_vertices_; i < vertex_entries(); ++i) {
        if (exists(vertices_[i])) vertex_entry_[index(vertices_[i])] = kNoEntry;
    }
    for (std::uint32_t i = original_wedges_; i < wedge_entries(); ++i) {
        if (exists(wedges_[i])) wedge_entry_[index(wedges_[i])] = kNoEntry;
    }
    for (EdgeId e : edges_) edge_states_[index(e)] = {};
    for (EdgeId e : measured_edges_) edge_states_[index(e)] = {};
    measured_edges_.clear();
    vertices_.resize(original_vertices_);
    rest_positions_.resize(original_vertices_);
    was_deformed_.resize(original_vertices_);
    wedges_.resize(original_wedges_);
    rest_normals_.resize(original_wedges_);
    wedge_owners_.resize(original_wedges_);
    edges_.resize(original_edges_);
    one_look_.resize(original_edges_);
    free_vertex_entries_.clear();
    lost_wedges_.clear();
    lost_normals_.clear();
    free_wedge_entries_.clear();
    faces_.resize(original_faces_);
    edits_.clear();
    splits_ = 0;
}

MeshChange ActiveSet::finish() {
    MeshChange change;
    change.slots_before = slots_at_begin_;
    record_states(change);
    change.edits.assign(edits_.begin(), edits_.end());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (i >= original_faces_ || has_changed(faces_[i])) change.faces.push_back(faces_[i]);
    }
    std::sort(change.faces.begin(), change.faces.end());
    change.faces.erase(std::unique(change.faces.begin(), change.faces.end()), change.faces.end());
    change.faces.shrink_to_fit();
    forget();
    return change;
}

bool ActiveSet::has_changed(FaceId original) const {
    if (!mesh_.is_live(original)) return true;
    for (int corner = 0; corner < 3; ++corner) {
        const HalfEdge& h = mesh_.half_edge(TriMesh::half_edge(original, corner));
        if (!same_bytes(mesh_.position(h.origin), rest_position(h.origin)) ||
            !same_bytes(mesh_.normal(h.wedge), rest_normal(h.wedge))) {
            return true;
        }
    }
    return false;
}

void ActiveSet::abandon() {
    faces_.clear();
    vertices_.clear();
    rest_positions_.clear();
    was_deformed_.clear();
    wedges_.clear();
    rest_normals_.clear();
    wedge_owners_.clear();
    edges_.clear();
    one_look_.clear();
    vertex_entry_.clear();
    wedge_entry_.clear();
    edge_states_.clear();
    measured_edges_.clear();
    original_ids_.clear();
    original_wedge_ids_.clear();
    forget();
}

void ActiveSet::record_states(MeshChange& change) const {
    for (std::uint32_t i = 0; i < vertex_entries(); ++i) {
        const VertexId v = vertices_[i];
        const bool original = i < original_vertices_;
        if (original && exists(v) && same_bytes(mesh_.position(v), rest_positions_[i]) &&
            mesh_.is_deformed(v) == was_deformed_at(i)) {
            continue;
        }
        if (original) {
            change.before.vertices.push_back(original_ids_[i]);
            change.before.positions.push_back(rest_positions_[i]);
            change.before.deformed.push_back(was_deformed_[i]);
        }
        if (exists(v)) change.after.add(mesh_, v);
    }
    for (std::uint32_t i = 0; i < wedge_entries(); ++i) {
        const WedgeId w = wedges_[i];
        const bool original = i < original_wedges_;
        if (original && exists(w) && same_bytes(mesh_.normal(w), rest_normals_[i])) continue;
        if (original) {
            change.before.wedges.push_back(original_wedge_ids_[i]);
            change.before.normals.push_back(rest_normals_[i]);
        }
        if (exists(w)) change.after.add(mesh_, w);
    }
    change.before.wedges.insert(change.before.wedges.end(), lost_wedges_.begin(),
                                lost_wedges_.end());
    change.before.normals.insert(change.before.normals.end(), lost_normals_.begin(),
                                 lost_normals_.end());
    change.before.shrink_to_fit();
    change.after.shrink_to_fit();
}

// Everything back to nothing active, at the cost of what was.
void ActiveSet::forget() {
    for (VertexId v : original_ids_) vertex_entry_[index(v)] = kNoEntry;
    for (WedgeId w : original_wedge_ids_) wedge_entry_[index(w)] = kNoEntry;
    original_vertices_ = original_wedges_ = original_edges_ = 0;
    original_faces_ = 0;
    drop_inserted();
    original_ids_.clear();
    original_wedge_ids_.clear();
    turned_looks_.clear();
    influenced_ = influenced_wedges_ = 0;
    longest_square_ = 0.0;
    begun_ = false;
}

std::size_t ActiveSet::memory_bytes() const {
    return capacity_bytes(faces_) + capacity_bytes(vertices_) + capacity_bytes(original_ids_) +
           capacity_bytes(rest_positions_) + capacity_bytes(was_deformed_) +
           capacity_bytes(wedges_) + capacity_bytes(original_wedge_ids_) +
           capacity_bytes(rest_normals_) + capacity_bytes(wedge_owners_) + capacity_bytes(edges_) +
           capacity_bytes(one_look_) + capacity_bytes(turned_looks_) + capacity_bytes(scratch_) + capacity_bytes(measured_edges_) +
           capacity_bytes(edits_) + capacity_bytes(lost_wedges_) + capacity_bytes(lost_normals_) +
           capacity_bytes(free_vertex_entries_) + capacity_bytes(free_wedge_entries_) +
           capacity_bytes(vertex_entry_) + capacity_bytes(wedge_entry_) +
           capacity_bytes(edge_states_);
}

}  // namespace pectin
