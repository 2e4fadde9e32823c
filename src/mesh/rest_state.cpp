#include "mesh/rest_state.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/two_groups.h"
#include "mesh/array_bytes.h"
#include "mesh/sort_ids.h"

namespace pectin {
namespace {

// Raises `value` to at least `to`. Several threads may call it at a time.
void raise_to(double& value, double to) {
    const std::atomic_ref shared(value);
    double known = shared.load(std::memory_order_relaxed);
    while (known < to && !shared.compare_exchange_weak(known, to)) {
    }
}

// With fewer than one in so many of a mesh's faces, collecting and sorting ids is faster than
// looking at all slots of the mesh.
constexpr std::size_t kFewFaces = 16;

constexpr std::uint32_t kMarked = 0;

// Ids among which the marked elements are, ascending: given ids, or those of all slots.
template <typename Id>
class Candidates {
  public:
    explicit Candidates(std::uint32_t slots) : size_(slots) {}
    explicit Candidates(std::vector<Id> ids)
        : ids_(std::move(ids)), size_(static_cast<std::uint32_t>(ids_.size())) {
        sort_ids(std::span(ids_));
    }
    std::uint32_t size() const { return size_; }
    Id operator[](std::uint32_t i) const { return ids_.empty() ? Id{i} : ids_[i]; }

  private:
    std::vector<Id> ids_;  // empty if all slots are candidates
    std::uint32_t size_;
};

}  // namespace

struct RestState::Elements {
    Candidates<VertexId> vertices;
    Candidates<WedgeId> wedges;
    Candidates<EdgeId> edges;
};

void RestState::begin(std::span<const FaceId> faces, const Box& zone) {
    zone_ = zone;
    fit_to_mesh();
    const Elements elements = mark(faces);
    enter_edges(elements);
    enter_vertices(elements);
    enter_wedges(elements);
    original_vertices_ = vertices_.slots();
    original_wedges_ = wedges_.slots();
    original_edges_ = edges_.slots();
    original_vertex_ids_.assign(vertices_.ids);
    original_wedge_ids_.assign(wedges_.ids);
}

void RestState::fit_to_mesh() {
    const auto fit = [](auto& values, std::uint32_t slots, auto fill) {
        if (values.size() < slots) values.resize(slots, fill);
    };
    fit(vertex_entry_, mesh_.vertex_slots(), kNoEntry);
    fit(wedge_entry_, mesh_.wedge_slots(), kNoEntry);
    fit(edge_states_, mesh_.edge_slots(), EdgeState{});
}

// Marks each corner, wedge and edge of the faces. A marked vertex or edge has entry 0 until it is
// entered; wedge_entry_ holds the vertex of a marked wedge.
RestState::Elements RestState::mark(std::span<const FaceId> faces) {
    if (faces.size() > mesh_.face_slots() / kFewFaces) {
        mark_on_all_threads(faces);
        return {.vertices = Candidates<VertexId>(mesh_.vertex_slots()),
                .wedges = Candidates<WedgeId>(mesh_.wedge_slots()),
                .edges = Candidates<EdgeId>(mesh_.edge_slots())};
    }
    std::vector<VertexId> vertices;
    std::vector<WedgeId> wedges;
    std::vector<EdgeId> edges;
    for (FaceId f : faces) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdge& h = mesh_.half_edge(TriMesh::half_edge(f, corner));
            if (vertex_entry_[index(h.origin)] == kNoEntry) {
                vertex_entry_[index(h.origin)] = kMarked;
                vertices.push_back(h.origin);
            }
            if (wedge_entry_[index(h.wedge)] == kNoEntry) {
                wedge_entry_[index(h.wedge)] = index(h.origin);
                wedges.push_back(h.wedge);
            }
            if (edge_states_[index(h.edge)].entry == kNoEntry) {
                edge_states_[index(h.edge)].entry = kMarked;
                edges.push_back(h.edge);
            }
        }
    }
    return {.vertices = Candidates(std::move(vertices)),
            .wedges = Candidates(std::move(wedges)),
            .edges = Candidates(std::move(edges))};
}

// Several threads may mark an element, all with the same value.
void RestState::mark_on_all_threads(std::span<const FaceId> faces) {
    const auto store = [](std::uint32_t& shared, std::uint32_t value) {
        std::atomic_ref(shared).store(value, std::memory_order_relaxed);
    };
    for_pieces(0, static_cast<std::uint32_t>(faces.size()),
               [&](std::uint32_t first, std::uint32_t end) {
                   for (std::uint32_t i = first; i < end; ++i) {
                       for (int corner = 0; corner < 3; ++corner) {
                           const HalfEdgeId id = TriMesh::half_edge(faces[i], corner);
                           const HalfEdge& h = mesh_.half_edge(id);
                           store(vertex_entry_[index(h.origin)], kMarked);
                           store(wedge_entry_[index(h.wedge)], index(h.origin));
                           store(edge_states_[index(h.edge)].entry, kMarked);
                       }
                   }
               });
}

void RestState::enter_edges(const Elements& elements) {
    const TwoGroups marked(elements.edges.size(), [&](std::uint32_t i) {
        const bool is_marked = edge_states_[index(elements.edges[i])].entry != kNoEntry;
        return is_marked ? Group::first : Group::none;
    });
    edges_.reserve(marked.size());
    edges_.grow(marked.size());
    marked.for_each([&](std::uint32_t i, std::uint32_t entry) {
        const EdgeId e = elements.edges[i];
        edge_states_[index(e)].entry = entry;
        edges_.ids[entry] = e;
        edges_.is_smooth[entry] = has_smooth_normals(e) ? 1 : 0;
        raise_to(longest_square_, mesh_.squared_length(e));
    });
}

void RestState::enter_vertices(const Elements& elements) {
    const TwoGroups marked(elements.vertices.size(), [&](std::uint32_t i) {
        const VertexId v = elements.vertices[i];
        if (vertex_entry_[index(v)] == kNoEntry) return Group::none;
        return zone_.contains_strictly(mesh_.position(v)) ? Group::first : Group::second;
    });
    influenced_vertices_ = marked.size_of_first();
    vertices_.reserve(marked.size());
    vertices_.grow(marked.size());
    marked.for_each([&](std::uint32_t i, std::uint32_t entry) {
        const VertexId v = elements.vertices[i];
        enter(entry, v, mesh_.position(v), mesh_.is_deformed(v), false);
    });
}

void RestState::enter_wedges(const Elements& elements) {
    const auto owner = [&](WedgeId w) { return vertex_entry_[wedge_entry_[index(w)]]; };
    const TwoGroups marked(elements.wedges.size(), [&](std::uint32_t i) {
        const WedgeId w = elements.wedges[i];
        if (wedge_entry_[index(w)] == kNoEntry) return Group::none;
        return owner(w) < influenced_vertices_ ? Group::first : Group::second;
    });
    influenced_wedges_ = marked.size_of_first();
    wedges_.reserve(marked.size());
    wedges_.grow(marked.size());
    marked.for_each([&](std::uint32_t i, std::uint32_t entry) {
        const WedgeId w = elements.wedges[i];
        const std::uint32_t owned_by = owner(w);
        enter(entry, w, mesh_.normal(w), owned_by);
    });
}

bool RestState::has_smooth_normals(EdgeId e) const {
    const bool is_boundary = !exists(mesh_.twin(mesh_.half_edge(e)));
    return is_boundary ? mesh_.sibling(e) == e : mesh_.is_smooth(e);
}

// Lengths are rounded to float, so the bound is a little larger.
void RestState::record_length(float length) {
    const double bound = (1.0 + 1e-6) * static_cast<double>(length);
    raise_to(longest_square_, bound * bound);
}

float RestState::distance_of_ends(EdgeId e) const {
    const HalfEdgeId h = mesh_.half_edge(e);
    return static_cast<float>(glm::distance(position(mesh_.origin(h)), position(mesh_.target(h))));
}

float RestState::measure(EdgeId e) {
    if (index(e) >= edge_states_.size()) edge_states_.resize(index(e) + std::size_t{1});
    EdgeState& state = edge_states_[index(e)];
    state.length = distance_of_ends(e);
    if (state.entry == kNoEntry) measured_edges_.push_back(e);
    return state.length;
}

Vec3 RestState::area_normal(VertexId p, VertexId q, VertexId r) const {
    const Vec3 from = position(p);
    return glm::cross(position(q) - from, position(r) - from);
}

std::size_t RestState::reserve_splits(std::size_t count) {
    std::size_t splits = std::numeric_limits<std::uint32_t>::max();
    const auto reserve = [&](auto& values, std::size_t per_split) {
        values.reserve_additional(per_split * count);
        splits = std::min(splits, (values.capacity() - values.size()) / per_split);
    };
    const auto reserve_table = [&](auto& table, std::size_t per_split) {
        table.reserve_additional(per_split * count);
        splits = std::min(splits, table.spare_capacity() / per_split);
    };
    reserve_table(vertices_, 1);
    reserve(vertex_entry_, 1);
    reserve_table(wedges_, 2);
    reserve(wedge_entry_, 2);
    reserve_table(edges_, 4);
    reserve(flipped_smooth_, 4);
    reserve(edge_states_, 3);
    return splits;
}

void RestState::prepare_splits(std::size_t count) {
    fit_to_mesh();
    vertices_.prepare(count);
    vertex_entry_.prepare(count);
    wedges_.prepare(count);
    wedge_entry_.prepare(count);
    edges_.prepare(4 * count);
    edge_states_.prepare(3 * count);
}

void RestState::reserve_unsplits(std::size_t sheets) {
    vertices_.reserve_free(sheets);
    wedges_.reserve_free(2 * sheets);
}

void RestState::reserve_rim(std::size_t sheets) {
    edges_.reserve_additional(2 * sheets);
    flipped_smooth_.reserve_additional(2 * sheets);
    measured_edges_.reserve_additional(2 * sheets);
    kept_wedges_.reserve_additional(2 * sheets);
    kept_normals_.reserve_additional(2 * sheets);
}

void RestState::remove_or_keep(WedgeId w) {
    if (entry(w) == kNoEntry) {
        kept_wedges_.push_back(w);
        kept_normals_.push_back(mesh_.normal(w));
        return;
    }
    const std::uint32_t removed = remove(w);
    if (is_inserted_wedge(removed)) wedges_.push_free(removed);
}

void RestState::restore(TriMesh& mesh) noexcept {
    for (std::size_t i = 0; i < kept_wedges_.size(); ++i) {
        mesh.set_normal(kept_wedges_[i], kept_normals_[i]);
    }
    drop_inserted();
    for (std::uint32_t i = 0; i < original_vertices_; ++i) {
        const VertexId v = vertices_.ids[i] = original_vertex_ids_[i];
        vertex_entry_[index(v)] = i;
    }
    for (std::uint32_t i = 0; i < original_wedges_; ++i) {
        const WedgeId w = wedges_.ids[i] = original_wedge_ids_[i];
        wedge_entry_[index(w)] = i;
    }
    restore_attributes(mesh);
    for (std::uint32_t i = 0; i < original_edges_; ++i) {
        edge_states_[index(edges_.ids[i])].entry = i;
    }
    for (std::uint32_t i : flipped_smooth_) edges_.is_smooth[i] ^= 1;
    flipped_smooth_.clear();
}

void RestState::restore_attributes(TriMesh& mesh) const noexcept {
    for (std::uint32_t i = 0; i < original_vertices_; ++i) {
        const VertexId v = vertices_.ids[i];
        mesh.set_position(v, vertices_.positions[i]);
        mesh.set_deformed(v, vertices_.was_deformed[i] != 0);
    }
    for (std::uint32_t i = 0; i < original_wedges_; ++i) {
        mesh.set_normal(wedges_.ids[i], wedges_.normals[i]);
    }
}

// Reduces the entries to those of the beginning. All edges lose their stored length and entry.
void RestState::drop_inserted() noexcept {
    for (std::uint32_t i = original_vertices_; i < vertices_.slots(); ++i) {
        if (exists(vertices_.ids[i])) vertex_entry_[index(vertices_.ids[i])] = kNoEntry;
    }
    for (std::uint32_t i = original_wedges_; i < wedges_.slots(); ++i) {
        if (exists(wedges_.ids[i])) wedge_entry_[index(wedges_.ids[i])] = kNoEntry;
    }
    for (EdgeId e : edges_.ids) edge_states_[index(e)] = {};
    for (EdgeId e : measured_edges_) edge_states_[index(e)] = {};
    measured_edges_.clear();
    vertices_.resize(original_vertices_);
    vertices_.clear_free();
    wedges_.resize(original_wedges_);
    wedges_.clear_free();
    edges_.resize(original_edges_);
    kept_wedges_.clear();
    kept_normals_.clear();
}

void RestState::end() noexcept {
    for (VertexId v : original_vertex_ids_) vertex_entry_[index(v)] = kNoEntry;
    for (WedgeId w : original_wedge_ids_) wedge_entry_[index(w)] = kNoEntry;
    original_vertices_ = original_wedges_ = original_edges_ = 0;
    drop_inserted();
    original_vertex_ids_.clear();
    original_wedge_ids_.clear();
    flipped_smooth_.clear();
    influenced_vertices_ = influenced_wedges_ = 0;
    longest_square_ = 0.0;
}

void RestState::abandon() noexcept {
    vertices_.clear_all();
    wedges_.clear_all();
    edges_.clear_all();
    vertex_entry_.clear();
    wedge_entry_.clear();
    edge_states_.clear();
    measured_edges_.clear();
    original_vertex_ids_.clear();
    original_wedge_ids_.clear();
    end();
}

std::size_t RestState::memory_bytes() const {
    return vertices_.memory_bytes() + wedges_.memory_bytes() + edges_.memory_bytes() +
           capacity_bytes(original_vertex_ids_) + capacity_bytes(original_wedge_ids_) +
           capacity_bytes(kept_wedges_) + capacity_bytes(kept_normals_) +
           capacity_bytes(flipped_smooth_) + capacity_bytes(measured_edges_) +
           capacity_bytes(vertex_entry_) + capacity_bytes(wedge_entry_) +
           capacity_bytes(edge_states_);
}

}  // namespace pectin
