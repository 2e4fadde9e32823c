#include "mesh/build_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "mesh/corner_normals.h"
#include "mesh/triangulate.h"

namespace pectin {

class MeshBuilder {
  public:
    MeshBuilder(const IndexedFaceSet& input, const BuildOptions& options)
        : input_(input), options_(options) {}

    BuiltMesh build() {
        mesh_.positions_ = input_.positions;
        mesh_.parts_ = input_.parts;
        mesh_.material_libraries_ = input_.material_libraries;
        mesh_.base_vertices_ = static_cast<std::uint32_t>(input_.positions.size());
        make_faces();
        match_twins();
        make_edges();
        name_vertices();
        make_wedges();
        return {std::move(mesh_), report_};
    }

  private:
    using Corner = IndexedFaceSet::Corner;

    void make_faces();
    void add_polygon(std::uint32_t polygon);
    void match_twins();
    void match_run(std::span<const HalfEdgeId> run);
    void make_edges();
    void name_vertices();
    void make_wedges();
    WedgeId find_wedge(std::size_t first, const Vec3f& normal, const Vec2f& uv) const;

    HalfEdge& half(HalfEdgeId h) { return mesh_.half_edges_[index(h)]; }

    const IndexedFaceSet& input_;
    const BuildOptions& options_;
    TriMesh mesh_;
    BuildReport report_;
    std::vector<std::uint32_t> corner_of_;  // 3 n_faces; into input_.corners

    std::vector<std::uint32_t> ring_;  // scratch of add_polygon
    std::vector<Vec3> ring_positions_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

void MeshBuilder::make_faces() {
    const std::size_t triangles =
        input_.corners.size() - std::min(input_.corners.size(), 2 * input_.polygon_count());
    corner_of_.reserve(3 * triangles);
    mesh_.base_faces_.reserve(triangles);
    for (std::uint32_t p = 0; p < input_.polygon_count(); ++p) add_polygon(p);

    mesh_.half_edges_.resize(corner_of_.size());
    for (std::size_t i = 0; i < corner_of_.size(); ++i) {
        mesh_.half_edges_[i].origin = VertexId{input_.corners[corner_of_[i]].position};
    }
    mesh_.face_bases_.resize(mesh_.base_faces_.size());
    for (std::uint32_t f = 0; f < mesh_.base_face_count(); ++f) mesh_.face_bases_[f] = FaceId{f};
}

void MeshBuilder::add_polygon(std::uint32_t polygon) {
    ring_.clear();
    ring_positions_.clear();
    triangles_.clear();
    const auto vertex = [&](std::uint32_t corner) { return input_.corners[corner].position; };
    for (std::uint32_t c = input_.polygon_begin(polygon); c < input_.polygon_end[polygon]; ++c) {
        if (ring_.empty() || vertex(ring_.back()) != vertex(c)) ring_.push_back(c);
    }
    while (ring_.size() > 1 && vertex(ring_.front()) == vertex(ring_.back())) ring_.pop_back();
    const std::size_t faces_before = mesh_.base_faces_.size();
    if (ring_.size() >= 3) {
        for (std::uint32_t c : ring_) ring_positions_.push_back(input_.positions[vertex(c)]);
        triangulate(ring_positions_, triangles_);
    }
    for (const auto& t : triangles_) {
        const std::uint32_t a = ring_[t[0]], b = ring_[t[1]], c = ring_[t[2]];
        if (vertex(a) == vertex(b) || vertex(b) == vertex(c) || vertex(c) == vertex(a)) continue;
        corner_of_.insert(corner_of_.end(), {a, b, c});
        mesh_.base_faces_.push_back({input_.polygon_part[polygon], polygon});
    }
    if (ring_.size() > 3) ++report_.triangulated_polygons;
    if (mesh_.base_faces_.size() == faces_before) ++report_.skipped_polygons;
}

// Half-edges sorted by their lower vertex (counting sort), then within it by the upper one.
void MeshBuilder::match_twins() {
    const auto count = static_cast<std::uint32_t>(mesh_.half_edges_.size());
    const auto lower = [&](HalfEdgeId h) { return std::min(mesh_.origin(h), mesh_.target(h)); };
    const auto upper = [&](HalfEdgeId h) { return std::max(mesh_.origin(h), mesh_.target(h)); };
    std::vector<std::uint32_t> first(input_.positions.size() + 1, 0);
    for (std::uint32_t h = 0; h < count; ++h) ++first[index(lower(HalfEdgeId{h})) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<HalfEdgeId> sorted(count);
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) {
        sorted[at[index(lower(HalfEdgeId{h}))]++] = HalfEdgeId{h};
    }
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        const std::span<HalfEdgeId> around(sorted.data() + first[v], first[v + 1] - first[v]);
        std::stable_sort(around.begin(), around.end(),
                         [&](HalfEdgeId x, HalfEdgeId y) { return upper(x) < upper(y); });
        for (std::size_t i = 0, end = 0; i < around.size(); i = end) {
            while (end < around.size() && upper(around[end]) == upper(around[i])) ++end;
            match_run(around.subspan(i, end - i));
        }
    }
}

// All half-edges between one pair of vertices: two that run in opposite directions are twins;
// anything else but a single one is no manifold and becomes a cut.
void MeshBuilder::match_run(std::span<const HalfEdgeId> run) {
    if (run.size() == 1) return;
    if (run.size() == 2 && mesh_.origin(run[0]) != mesh_.origin(run[1])) {
        half(run[0]).twin = run[1];
        half(run[1]).twin = run[0];
    } else {
        ++report_.cut_edges;
    }
}

void MeshBuilder::make_edges() {
    for (std::uint32_t i = 0; i < mesh_.half_edges_.size(); ++i) {
        const HalfEdgeId h{i};
        if (exists(half(h).edge)) continue;
        const EdgeId e{static_cast<std::uint32_t>(mesh_.edge_half_edges_.size())};
        mesh_.edge_half_edges_.push_back(h);
        half(h).edge = e;
        if (exists(half(h).twin)) half(half(h).twin).edge = e;
    }
    mesh_.edge_levels_.assign(mesh_.edge_half_edges_.size(), 0);
}

void MeshBuilder::name_vertices() {
    mesh_.vertex_half_edges_.assign(mesh_.positions_.size(), kNone<HalfEdgeId>);
    mesh_.vertex_levels_.assign(mesh_.positions_.size(), 0);
    mesh_.deformed_.assign(mesh_.positions_.size(), 0);
    for (std::uint32_t i = static_cast<std::uint32_t>(mesh_.half_edges_.size()); i-- > 0;) {
        mesh_.vertex_half_edges_[index(mesh_.half_edges_[i].origin)] = HalfEdgeId{i};
    }
    report_.isolated_vertices = static_cast<std::uint32_t>(std::count(
        mesh_.vertex_half_edges_.begin(), mesh_.vertex_half_edges_.end(), kNone<HalfEdgeId>));
}

WedgeId MeshBuilder::find_wedge(std::size_t first, const Vec3f& normal, const Vec2f& uv) const {
    for (std::size_t w = first; w < mesh_.normals_.size(); ++w) {
        if (std::memcmp(&mesh_.normals_[w], &normal, sizeof normal) == 0 &&
            (!mesh_.has_uvs() || std::memcmp(&mesh_.uvs_[w], &uv, sizeof uv) == 0)) {
            return WedgeId{static_cast<std::uint32_t>(w)};
        }
    }
    return kNone<WedgeId>;
}

// Vertex by vertex, so that wedges lie in memory as their vertices do.
void MeshBuilder::make_wedges() {
    const std::vector<Vec3f> normals = corner_normals(mesh_, input_, corner_of_, options_);
    const auto count = static_cast<std::uint32_t>(mesh_.half_edges_.size());
    std::vector<std::uint32_t> first(mesh_.positions_.size() + 1, 0);
    for (const HalfEdge& h : mesh_.half_edges_) ++first[index(h.origin) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> at_vertex(count);
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) {
        at_vertex[at[index(mesh_.half_edges_[h].origin)]++] = h;
    }
    const bool with_uvs = !input_.uvs.empty();
    const Vec2f no_uv{std::numeric_limits<float>::quiet_NaN()};
    mesh_.normals_.reserve(mesh_.positions_.size());
    if (with_uvs) mesh_.uvs_.reserve(mesh_.positions_.size());
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        const std::size_t first_wedge = mesh_.normals_.size();
        for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
            const std::uint32_t h = at_vertex[i];
            const std::uint32_t uv_index = input_.corners[corner_of_[h]].uv;
            const Vec2f uv = uv_index == IndexedFaceSet::kNoIndex ? no_uv : input_.uvs[uv_index];
            WedgeId w = find_wedge(first_wedge, normals[h], uv);
            if (!exists(w)) {
                w = WedgeId{static_cast<std::uint32_t>(mesh_.normals_.size())};
                mesh_.normals_.push_back(normals[h]);
                if (with_uvs) mesh_.uvs_.push_back(uv);
            }
            mesh_.half_edges_[h].wedge = w;
        }
    }
}

BuiltMesh build_mesh(const IndexedFaceSet& input, const BuildOptions& options) {
    return MeshBuilder(input, options).build();
}

}  // namespace pectin
