#include "mesh/active_set.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

#include "mesh/array_bytes.h"
#include "mesh/sort_ids.h"

namespace pectin {

void ActiveSet::begin(std::span<const FaceId> faces, const Box& zone) {
    assert(!begun_);
    begun_ = true;
    zone_ = zone;
    slots_at_begin_ = mesh_.slot_counts();
    split_capacity_ = 0;
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
            enter(allocate_edge_entry(h.edge, false), h.edge, kUnmeasured);
        }
    }
    sort_ids(std::span(edges_));
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        edge_states_[index(edges_[i])].entry = i;
        is_smooth_[i] = has_smooth_normals(edges_[i]) ? 1 : 0;
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
    for (VertexId v : corners) {
        enter(allocate_vertex_entry(v), v, mesh_.position(v), mesh_.is_deformed(v));
    }

    sort_ids(std::span(wedges));
    const auto owner = [&](WedgeId w) { return vertex_entry_[wedge_entry_[index(w)]]; };
    const auto first_still_wedge = std::stable_partition(
        wedges.begin(), wedges.end(), [&](WedgeId w) { return owner(w) < influenced_; });
    influenced_wedges_ = static_cast<std::uint32_t>(first_still_wedge - wedges.begin());
    wedges_.reserve(wedges.size());
    rest_normals_.reserve(wedges.size());
    wedge_owners_.reserve(wedges.size());
    for (WedgeId w : wedges) {
        const std::uint32_t owned_by = owner(w);
        enter(allocate_wedge_entry(w), w, mesh_.normal(w), owned_by);
    }
}

bool ActiveSet::has_smooth_normals(EdgeId e) const {
    const bool is_boundary = !exists(mesh_.twin(mesh_.half_edge(e)));
    return is_boundary ? mesh_.sibling(e) == e : mesh_.is_smooth(e);
}

// Of an edge that was not there at the beginning, rounded to float.
void ActiveSet::record_length(float rest_length) {
    const double length = (1.0 + 1e-6) * static_cast<double>(rest_length);
    const std::atomic_ref longest(longest_square_);  // several threads may
    double known = longest.load(std::memory_order_relaxed);
    while (known < length * length && !longest.compare_exchange_weak(known, length * length)) {
    }
}

float ActiveSet::distance_of_rest_ends(EdgeId e) const {
    const HalfEdgeId h = mesh_.half_edge(e);
    return static_cast<float>(
        glm::distance(rest_position(mesh_.origin(h)), rest_position(mesh_.target(h))));
}

float ActiveSet::measure(EdgeId e) {
    if (index(e) >= edge_states_.size()) edge_states_.resize(index(e) + std::size_t{1});
    EdgeState& state = edge_states_[index(e)];
    state.rest_length = distance_of_rest_ends(e);
    if (state.entry == kNoEntry) measured_edges_.push_back(e);
    return state.rest_length;
}

void ActiveSet::roll_back() noexcept {
    take_back(edits_, slots_at_begin_, mesh_);
    mesh_.shrink(slots_at_begin_);
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
    for (std::uint32_t entry : flipped_smooth_) is_smooth_[entry] ^= 1;
    flipped_smooth_.clear();
}

// Cuts the entries back to those of the beginning.
void ActiveSet::drop_inserted() noexcept {
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
    is_smooth_.resize(original_edges_);
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

void ActiveSet::cancel() noexcept {
    roll_back();
    forget();
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

void ActiveSet::abandon() noexcept {
    faces_.clear();
    vertices_.clear();
    rest_positions_.clear();
    was_deformed_.clear();
    wedges_.clear();
    rest_normals_.clear();
    wedge_owners_.clear();
    edges_.clear();
    is_smooth_.clear();
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
void ActiveSet::forget() noexcept {
    for (VertexId v : original_ids_) vertex_entry_[index(v)] = kNoEntry;
    for (WedgeId w : original_wedge_ids_) wedge_entry_[index(w)] = kNoEntry;
    original_vertices_ = original_wedges_ = original_edges_ = 0;
    original_faces_ = 0;
    drop_inserted();
    original_ids_.clear();
    original_wedge_ids_.clear();
    flipped_smooth_.clear();
    influenced_ = influenced_wedges_ = 0;
    longest_square_ = 0.0;
    begun_ = false;
}

std::size_t ActiveSet::memory_bytes() const {
    return capacity_bytes(faces_) + capacity_bytes(vertices_) + capacity_bytes(original_ids_) +
           capacity_bytes(rest_positions_) + capacity_bytes(was_deformed_) +
           capacity_bytes(wedges_) + capacity_bytes(original_wedge_ids_) +
           capacity_bytes(rest_normals_) + capacity_bytes(wedge_owners_) + capacity_bytes(edges_) +
           capacity_bytes(is_smooth_) + capacity_bytes(flipped_smooth_) + capacity_bytes(scratch_) +
           capacity_bytes(measured_edges_) + capacity_bytes(edits_) + capacity_bytes(lost_wedges_) +
           capacity_bytes(lost_normals_) + capacity_bytes(free_vertex_entries_) +
           capacity_bytes(free_wedge_entries_) + capacity_bytes(vertex_entry_) +
           capacity_bytes(wedge_entry_) + capacity_bytes(edge_states_);
}

}  // namespace pectin
