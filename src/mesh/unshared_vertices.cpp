#include "mesh/unshared_vertices.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace pectin {
namespace {

constexpr std::uint32_t kAsInMesh = 0xffffffffu;

}  // namespace

// Walks along the pieces of a base edge on one side, within the pieces of one base face.
class UnsharedVertices::Walk {
  public:
    explicit Walk(UnsharedVertices& to) : to_(to), mesh_(to.mesh_) {}

    void visit_side(HalfEdgeId side) {
        const HalfEdgeId first = first_piece(side);
        corners_.clear();
        HalfEdgeId h = first;
        to_.edges_.push_back(mesh_.edge(h));
        while (!mesh_.is_base(mesh_.target(h))) {
            h = next_piece(h);
            to_.edges_.push_back(mesh_.edge(h));
        }
        const VertexId from = to_.base_corner(first), to = to_.base_corner(TriMesh::next(h));
        const auto [low, high] = std::minmax(from, to);
        for (const HalfEdgeId corner : corners_) {
            to_.vertices_[index(corner)] = vertex_of(mesh_.origin(corner), low, high);
        }
    }

  private:
    bool is_same_base(HalfEdgeId g, HalfEdgeId h) const {
        return mesh_.base_face(TriMesh::face(g)) == mesh_.base_face(TriMesh::face(h));
    }

    HalfEdgeId first_piece(HalfEdgeId h) const {
        while (!mesh_.is_base(mesh_.origin(h))) {
            HalfEdgeId g = TriMesh::prev(h);
            for (HalfEdgeId t = mesh_.twin(g); exists(t) && is_same_base(t, h); t = mesh_.twin(g)) {
                g = TriMesh::prev(t);
            }
            h = g;
        }
        return h;
    }
    // Collects the base face's corners at the vertex between two pieces.
    HalfEdgeId next_piece(HalfEdgeId h) {
        HalfEdgeId g = TriMesh::next(h);
        corners_.push_back(g);
        for (HalfEdgeId t = mesh_.twin(g); exists(t) && is_same_base(t, h); t = mesh_.twin(g)) {
            g = TriMesh::next(t);
            corners_.push_back(g);
        }
        return g;
    }

    // The first side that is visited keeps the vertex of the mesh.
    std::uint32_t vertex_of(VertexId m, VertexId low, VertexId high) {
        const auto slots = mesh_.vertex_slots();
        const auto next = slots + static_cast<std::uint32_t>(to_.added_.size());
        const auto [found, is_new] = by_side_.try_emplace({m, low, high}, next);
        if (!is_new) return found->second;
        const bool is_first = is_met_.try_emplace(m, true).second;
        if (is_first) return found->second = index(m);
        to_.added_.push_back(m);
        return next;
    }

    UnsharedVertices& to_;
    const TriMesh& mesh_;
    std::vector<HalfEdgeId> corners_;
    std::map<std::tuple<VertexId, VertexId, VertexId>, std::uint32_t> by_side_;
    std::map<VertexId, bool> is_met_;
};

UnsharedVertices::UnsharedVertices(const TriMesh& mesh) : mesh_(mesh) {
    const UnsharedSeams& seams = mesh.input_form().seams;
    if (seams.is_empty()) return;
    vertices_.assign(3 * std::size_t{mesh.face_slots()}, kAsInMesh);
    Walk walk(*this);
    for (const EdgeId e : seams.edges) {
        const HalfEdgeId h = mesh.half_edge(e);
        walk.visit_side(h);
        if (exists(mesh.twin(h))) walk.visit_side(mesh.twin(h));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

std::uint32_t UnsharedVertices::of(HalfEdgeId corner) const {
    const VertexId v = mesh_.origin(corner);
    if (vertices_.empty()) return index(v);
    if (mesh_.is_base(v)) return index(base_corner(corner));
    const std::uint32_t own = vertices_[index(corner)];
    return own == kAsInMesh ? index(v) : own;
}

// The corner of the base face that is at the same vertex as `corner`.
VertexId UnsharedVertices::base_corner(HalfEdgeId corner) const {
    const UnsharedSeams& seams = mesh_.input_form().seams;
    const std::size_t first = 3 * std::size_t{index(mesh_.base_face(TriMesh::face(corner)))};
    for (std::size_t i = first; i < first + 3; ++i) {
        const VertexId own = seams.corner_vertices[i];
        if (seams.representatives[index(own)] == mesh_.origin(corner)) return own;
    }
    return mesh_.origin(corner);
}

const Vec3& UnsharedVertices::position(VertexId v) const {
    const UnsharedSeams& seams = mesh_.input_form().seams;
    if (seams.is_empty() || !mesh_.is_base(v)) return mesh_.position(v);
    // Equal positions may differ in the sign of a zero.
    const Vec3& at = mesh_.position(seams.representatives[index(v)]);
    return at == mesh_.position(v) ? mesh_.position(v) : at;
}

}  // namespace pectin
