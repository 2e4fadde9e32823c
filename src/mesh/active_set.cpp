#include "mesh/active_set.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "mesh/array_bytes.h"
#include "mesh/midpoint_normal.h"
#include "mesh/sort_ids.h"

namespace pectin {
namespace {

template <typename T, typename Id>
T& grown(GrowingArray<T>& values, Id id, T fill) {
    if (index(id) >= values.size()) values.resize(index(id) + std::size_t{1}, fill);
    return values[index(id)];
}

}  // namespace

void ActiveSet::begin(std::span<const FaceId> faces, const Box& zone) {
    assert(!begun_);
    begun_ = true;
    zone_ = zone;
    slots_at_begin_ = mesh_.slot_counts();
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
    for (VertexId v : corners) add_vertex(v, mesh_.position(v), mesh_.is_deformed(v));

    sort_ids(std::span(wedges));
    const auto owner = [&](WedgeId w) { return vertex_entry_[wedge_entry_[index(w)]]; };
    const auto first_still_wedge = std::stable_partition(
        wedges.begin(), wedges.end(), [&](WedgeId w) { return owner(w) < influenced_; });
    influenced_wedges_ = static_cast<std::uint32_t>(first_still_wedge - wedges.begin());
    for (WedgeId w : wedges) add_wedge(w, mesh_.normal(w), owner(w));
}

std::uint32_t ActiveSet::add_vertex(VertexId v, const Vec3& rest, bool was_deformed) {
    std::uint32_t entry = vertex_entries();
    if (!free_vertex_entries_.empty()) {
        entry = free_vertex_entries_.back();
        free_vertex_entries_.pop_back();
    } else {
        vertices_.push_back({});
        rest_positions_.push_back({});
        was_deformed_.push_back({});
    }
    vertices_[entry] = v;
    rest_positions_[entry] = rest;
    was_deformed_[entry] = was_deformed ? 1 : 0;
    grown(vertex_entry_, v, kNoEntry) = entry;
    return entry;
}

std::uint32_t ActiveSet::add_wedge(WedgeId w, const Vec3f& rest, std::uint32_t owner) {
    std::uint32_t entry = wedge_entries();
    if (!free_wedge_entries_.empty()) {
        entry = free_wedge_entries_.back();
        free_wedge_entries_.pop_back();
    } else {
        wedges_.push_back({});
        rest_normals_.push_back({});
        wedge_owners_.push_back({});
    }
    wedges_[entry] = w;
    rest_normals_[entry] = rest;
    wedge_owners_[entry] = owner;
    grown(wedge_entry_, w, kNoEntry) = entry;
    return entry;
}

ActiveSet::EdgeState& ActiveSet::add_edge(EdgeId e, bool one_look) {
    EdgeState& state = grown(edge_states_, e, EdgeState{});
    if (state.entry == kNoEntry) {
        state.entry = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back(e);
        one_look_.push_back(one_look ? 1 : 0);
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

// Edges of the beginning keep their place in the list, so that roll_back finds them.
void ActiveSet::drop_edge(EdgeId e) {
    const std::uint32_t entry = std::exchange(edge_states_[index(e)], EdgeState{}).entry;
    if (entry == kNoEntry || entry < original_edges_) return;
    edges_[entry] = edges_.back();
    one_look_[entry] = one_look_.back();
    edges_.pop_back();
    one_look_.pop_back();
    if (entry < edges_.size()) edge_states_[index(edges_[entry])].entry = entry;
}

float ActiveSet::measure(EdgeId e) {
    EdgeState& state = grown(edge_states_, e, EdgeState{});
    const HalfEdgeId h = mesh_.half_edge(e);
    state.rest_length = static_cast<float>(
        glm::distance(rest_position(mesh_.origin(h)), rest_position(mesh_.target(h))));
    if (state.entry == kNoEntry) measured_edges_.push_back(e);
    return state.rest_length;
}

ActiveSet::Inserted ActiveSet::split(EdgeId e) {
    const float length = rest_length(e), half_length = 0.5f * length;
    note_length(length);  // of its halves, too, and of what an unsplit restores
    mesh_.for_each_side(e, [this](HalfEdgeId h) { faces_.push_back(TriMesh::face(h)); });

    Inserted inserted;
    const Split& s = inserted.split = mesh_.insert_midpoint(e);
    edits_.push_back(TopologyEdit::split(s.bm));
    ++splits_;
    const Vec3 rest = 0.5 * rest_position(s.b) + 0.5 * rest_position(s.c);
    mesh_.set_position(s.m, rest);
    inserted.vertex_entry = add_vertex(s.m, rest, mesh_.is_deformed(s.m));
    inserted_wedges_.clear();
    inserted_edges_.clear();
    inserted_edges_.push_back(s.bm);
    inserted_edges_.push_back(s.mc);
    mesh_.for_each_sheet(mesh_.star_of(s), [&](const Star& star) {
        insert_sheet(star, inserted.vertex_entry, half_length);
    });
    inserted.wedge_entries = inserted_wedges_;
    inserted.edges = inserted_edges_;
    return inserted;
}

// The rest state of what a split has made in one sheet.
void ActiveSet::insert_sheet(const Star& star, std::uint32_t vertex_entry, float half_length) {
    const bool is_smooth = one_look_is_enough(mesh_.edge(star.bm));
    for (HalfEdgeId h : {star.bm, star.mc}) {
        add_edge(mesh_.edge(h), is_smooth).rest_length = half_length;
    }
    insert_spoke(TriMesh::prev(star.mc), star.a, vertex_entry);
    faces_.push_back(TriMesh::face(star.mc));
    const WedgeId left = mesh_.wedge(star.mc);
    insert_side(left, mesh_.wedge(star.bm), mesh_.wedge(TriMesh::next(star.mc)), vertex_entry,
                [&] { return rest_area_normal(star.b, star.c, star.a); });
    if (star.on_boundary()) return;

    insert_spoke(TriMesh::prev(star.mb), star.d, vertex_entry);
    faces_.push_back(TriMesh::face(star.cm));
    const WedgeId right = mesh_.wedge(star.mb);
    if (right == left) return;
    insert_side(right, mesh_.wedge(TriMesh::next(star.mb)), mesh_.wedge(star.cm), vertex_entry,
                [&] { return rest_area_normal(star.b, star.d, star.c); });
}

// am or dm.
void ActiveSet::insert_spoke(HalfEdgeId h, VertexId apex, std::uint32_t vertex_entry) {
    const EdgeId e = mesh_.edge(h);
    const auto length =
        static_cast<float>(glm::distance(rest_position(apex), rest_positions_[vertex_entry]));
    add_edge(e, true).rest_length = length;
    note_length(length);
    inserted_edges_.push_back(e);
}

template <typename AreaNormal>
void ActiveSet::insert_side(WedgeId m, WedgeId b, WedgeId c, std::uint32_t owner,
                            const AreaNormal& area_normal) {
    const Vec3f normal = midpoint_normal(rest_normal(b), rest_normal(c), area_normal);
    mesh_.set_normal(m, normal);
    inserted_wedges_.push_back(add_wedge(m, normal, owner));
}

Vec3 ActiveSet::rest_area_normal(VertexId p, VertexId q, VertexId r) const {
    const Vec3 from = rest_position(p);
    return glm::cross(rest_position(q) - from, rest_position(r) - from);
}

void ActiveSet::unsplit(const Star& star) {
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
        add_edge(e, one_look_is_enough(e)).rest_length = kUnmeasured;
        if (!was_inserted) note_length(rest_length(e));  // else its split has
    });
}

// Forgets what an unsplit takes from one sheet.
void ActiveSet::drop_sheet(const Star& star) {
    for (HalfEdgeId h : {star.mc, star.bm}) faces_.push_back(TriMesh::face(h));
    drop_edge(mesh_.edge(star.mc));
    drop_edge(mesh_.edge(TriMesh::prev(star.mc)));
    const WedgeId left = mesh_.wedge(star.mc);
    drop_wedge(left);
    if (star.on_boundary()) return;
    for (HalfEdgeId h : {star.mb, star.cm}) faces_.push_back(TriMesh::face(h));
    drop_edge(mesh_.edge(TriMesh::prev(star.mb)));
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
    influenced_ = influenced_wedges_ = 0;
    longest_square_ = 0.0;
    begun_ = false;
}

std::size_t ActiveSet::memory_bytes() const {
    return capacity_bytes(faces_) + capacity_bytes(vertices_) + capacity_bytes(original_ids_) +
           capacity_bytes(rest_positions_) + capacity_bytes(was_deformed_) +
           capacity_bytes(wedges_) + capacity_bytes(original_wedge_ids_) +
           capacity_bytes(rest_normals_) + capacity_bytes(wedge_owners_) + capacity_bytes(edges_) +
           capacity_bytes(one_look_) + capacity_bytes(scratch_) + capacity_bytes(measured_edges_) +
           capacity_bytes(edits_) + capacity_bytes(lost_wedges_) + capacity_bytes(lost_normals_) +
           capacity_bytes(free_vertex_entries_) + capacity_bytes(free_wedge_entries_) +
           capacity_bytes(inserted_wedges_) + capacity_bytes(inserted_edges_) +
           capacity_bytes(vertex_entry_) + capacity_bytes(wedge_entry_) +
           capacity_bytes(edge_states_);
}

}  // namespace pectin
