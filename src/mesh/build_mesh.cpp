#include "mesh/build_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>
#include <utility>

#include "mesh/corner_wedges.h"
#include "mesh/growing_array.h"
#include "mesh/join_seams.h"
#include "mesh/mirror_centre.h"
#include "mesh/shared_diagonals.h"
#include "mesh/triangulate.h"

namespace pectin {
namespace {

// Copies the values into a GrowingArray and frees the vector.
template <typename T>
GrowingArray<T> taken(std::vector<T>& values) {
    GrowingArray<T> result(values);
    values = {};
    return result;
}

}  // namespace

class MeshBuilder {
  public:
    MeshBuilder(IndexedFaceSet input, const BuildOptions& options)
        : input_(std::move(input)), options_(options) {}

    BuiltMesh build(const StopToken& stop) {
        take_input();
        for (const auto step :
             {&MeshBuilder::make_faces, &MeshBuilder::match_twins, &MeshBuilder::exchange_diagonals,
              &MeshBuilder::join_unshared, &MeshBuilder::make_edges, &MeshBuilder::join_siblings,
              &MeshBuilder::name_vertices, &MeshBuilder::make_wedges,
              &MeshBuilder::keep_elements}) {
            stop.throw_if_requested();
            (this->*step)();
        }
        survey(mesh_, report_);
        return {std::move(mesh_), report_};
    }

  private:
    using Corner = IndexedFaceSet::Corner;

    void take_input();
    void make_faces();
    void add_polygon(std::uint32_t polygon);
    void add_triangles(std::uint32_t polygon);
    void add_outline(std::uint32_t polygon);
    LooseCorner loose_corner(const Corner& corner) const;
    void match_twins();
    void exchange_diagonals();
    void renew_outline(std::uint32_t polygon);
    void join_unshared();
    void match_run(std::span<const HalfEdgeId> run);
    void make_edges();
    void join_siblings();
    void name_vertices();
    void make_wedges();
    void keep_elements();

    HalfEdge& half(HalfEdgeId h) { return mesh_.faces_.half_edges[index(h)]; }
    std::uint32_t vertex(std::uint32_t corner) const { return input_.corners[corner].position; }

    IndexedFaceSet input_;
    const BuildOptions& options_;
    TriMesh mesh_;
    BuildReport report_;
    std::vector<std::uint32_t> corner_of_;  // 3 n_faces; into input_.corners
    std::vector<HalfEdgeId> cut_;           // half-edges along cuts, one run after another
    std::vector<std::size_t> cut_ends_;     // end of each run in cut_
    std::vector<HalfEdgeId> seams_;         // half-edges along unshared seams
    std::optional<Vec3> mirror_centre_;     // computed when the first polygon needs it

    std::vector<std::uint32_t> ring_;  // scratch of add_polygon: corners without repetitions
    std::vector<Vec3> ring_positions_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<OutlineCorner> ring_corners_;
};

void MeshBuilder::take_input() {
    mesh_.vertices_.positions = taken(input_.positions);
    mesh_.vertices_.colors = taken(input_.colors);
    mesh_.form_.parts = std::move(input_.parts);
    mesh_.form_.material_libraries = std::move(input_.material_libraries);
    mesh_.base_vertices_ = static_cast<std::uint32_t>(mesh_.vertices_.positions.size());
}

void MeshBuilder::make_faces() {
    const std::size_t triangles =
        input_.corners.size() - std::min(input_.corners.size(), 2 * input_.polygon_count());
    corner_of_.reserve(3 * triangles);
    mesh_.base_faces_.reserve(triangles);
    for (std::uint32_t p = 0; p < input_.polygon_count(); ++p) add_polygon(p);

    mesh_.faces_.half_edges.resize(corner_of_.size());
    for (std::size_t i = 0; i < corner_of_.size(); ++i) {
        mesh_.faces_.half_edges[i].origin = VertexId{vertex(corner_of_[i])};
    }
    mesh_.faces_.bases.resize(mesh_.base_faces_.size());
    for (std::uint32_t f = 0; f < mesh_.base_face_count(); ++f) mesh_.faces_.bases[f] = FaceId{f};
}

void MeshBuilder::add_polygon(std::uint32_t polygon) {
    const std::uint32_t begin = input_.polygon_begin(polygon), end = input_.polygon_end[polygon];
    const bool is_triangle = end - begin == 3 && vertex(begin) != vertex(begin + 1) &&
                             vertex(begin + 1) != vertex(begin + 2) &&
                             vertex(begin + 2) != vertex(begin);
    if (is_triangle) {
        corner_of_.insert(corner_of_.end(), {begin, begin + 1, begin + 2});
        mesh_.base_faces_.push_back({input_.polygon_part[polygon], polygon});
        return;
    }
    const std::size_t faces_before = mesh_.base_faces_.size();
    add_triangles(polygon);
    add_outline(polygon);
    const std::size_t faces = mesh_.base_faces_.size() - faces_before;
    if (faces > 1) ++report_.triangulated_polygons;
    if (faces == 0) {
        ++report_.degenerate_polygons;
    } else if (ring_.size() < end - begin || faces < triangles_.size()) {
        ++report_.repeated_corners;
    }
}

// Triangulates the polygon without corners that repeat the vertex of the corner before. Records in
// ring_corners_ which half-edge, if any, each corner of the ring has.
void MeshBuilder::add_triangles(std::uint32_t polygon) {
    ring_.clear();
    ring_positions_.clear();
    triangles_.clear();
    for (std::uint32_t c = input_.polygon_begin(polygon); c < input_.polygon_end[polygon]; ++c) {
        if (ring_.empty() || vertex(ring_.back()) != vertex(c)) ring_.push_back(c);
    }
    while (ring_.size() > 1 && vertex(ring_.front()) == vertex(ring_.back())) ring_.pop_back();
    constexpr std::uint32_t kNobody = 0;
    ring_corners_.assign(ring_.size(), OutlineCorner::loose(kNobody));
    if (ring_.size() < 3) return;
    for (std::uint32_t c : ring_) ring_positions_.push_back(mesh_.vertices_.positions[vertex(c)]);
    if (ring_.size() > 3 && !mirror_centre_)
        mirror_centre_ = mirror_centre(mesh_.vertices_.positions);
    if (!triangulate(ring_positions_, triangles_, mirror_centre_.value_or(Vec3{0.0}))) {
        ++report_.crossing_polygons;
    }
    for (const auto& t : triangles_) {
        const std::uint32_t a = ring_[t[0]], b = ring_[t[1]], c = ring_[t[2]];
        if (vertex(a) == vertex(b) || vertex(b) == vertex(c) || vertex(c) == vertex(a)) continue;
        for (std::uint32_t corner : t) {
            const HalfEdgeId h{static_cast<std::uint32_t>(corner_of_.size())};
            if (ring_corners_[corner].is_loose()) ring_corners_[corner] = OutlineCorner::of(h);
            corner_of_.push_back(ring_[corner]);
        }
        mesh_.base_faces_.push_back({input_.polygon_part[polygon], polygon});
    }
}

// Records all corners in input order; those that no triangle has are loose. Precondition:
// add_triangles() has been called for this polygon.
void MeshBuilder::add_outline(std::uint32_t polygon) {
    InputForm& form = mesh_.form_;
    form.outlines.push_back({polygon, input_.polygon_part[polygon],
                             static_cast<std::uint32_t>(form.outline_corners.size())});
    std::size_t in_ring = 0;
    for (std::uint32_t c = input_.polygon_begin(polygon); c < input_.polygon_end[polygon]; ++c) {
        const bool is_in_ring = in_ring < ring_.size() && ring_[in_ring] == c;
        if (is_in_ring && !ring_corners_[in_ring].is_loose()) {
            form.outline_corners.push_back(ring_corners_[in_ring]);
        } else {
            form.outline_corners.push_back(
                OutlineCorner::loose(static_cast<std::uint32_t>(form.loose_corners.size())));
            form.loose_corners.push_back(loose_corner(input_.corners[c]));
        }
        in_ring += is_in_ring ? 1 : 0;
    }
}

LooseCorner MeshBuilder::loose_corner(const Corner& corner) const {
    LooseCorner loose{.vertex = VertexId{corner.position}, .uv = kNoUv};
    if (corner.uv != IndexedFaceSet::kNoIndex) loose.uv = input_.uvs[corner.uv];
    if (corner.normal != IndexedFaceSet::kNoIndex) loose.normal = input_.normals[corner.normal];
    return loose;
}

// Sorts the half-edges by their lower vertex (counting sort), then by their upper one, and matches
// those that have both in common.
void MeshBuilder::match_twins() {
    const auto count = static_cast<std::uint32_t>(mesh_.faces_.half_edges.size());
    const auto lower = [&](HalfEdgeId h) { return std::min(mesh_.origin(h), mesh_.target(h)); };
    const auto upper = [&](HalfEdgeId h) { return std::max(mesh_.origin(h), mesh_.target(h)); };
    std::vector<std::uint32_t> first(mesh_.vertices_.positions.size() + 1, 0);
    for (std::uint32_t h = 0; h < count; ++h) ++first[index(lower(HalfEdgeId{h})) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<HalfEdgeId> sorted(count);
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) {
        sorted[at[index(lower(HalfEdgeId{h}))]++] = HalfEdgeId{h};
    }
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        const std::span<HalfEdgeId> around(sorted.data() + first[v], first[v + 1] - first[v]);
        std::sort(around.begin(), around.end(), [&](HalfEdgeId x, HalfEdgeId y) {
            return std::pair(upper(x), x) < std::pair(upper(y), y);
        });
        for (std::size_t i = 0, end = 0; i < around.size(); i = end) {
            while (end < around.size() && upper(around[end]) == upper(around[i])) ++end;
            match_run(around.subspan(i, end - i));
        }
    }
}

// `run`: all half-edges between one pair of vertices. Two that run in opposite directions are
// twins. A single one is a boundary. Anything else is non-manifold and becomes a cut.
void MeshBuilder::match_run(std::span<const HalfEdgeId> run) {
    if (run.size() == 1) return;
    if (run.size() == 2 && mesh_.origin(run[0]) != mesh_.origin(run[1])) {
        half(run[0]).twin = run[1];
        half(run[1]).twin = run[0];
        return;
    }
    ++(run.size() == 2 ? report_.misoriented_edges : report_.nonmanifold_edges);
    cut_.insert(cut_.end(), run.begin(), run.end());
    cut_ends_.push_back(cut_.size());
}

// Replaces diagonals that have the same ends as another edge by the other diagonal of their two
// triangles, where that helps.
void MeshBuilder::exchange_diagonals() {
    if (cut_.empty()) return;
    std::vector<std::uint32_t> polygons;
    polygons.reserve(mesh_.base_faces_.size());
    for (const auto& face : mesh_.base_faces_) polygons.push_back(face.polygon);
    const std::vector<std::uint32_t> changed =
        exchange_shared_diagonals(input_, mesh_.vertices_.positions,
                                  mirror_centre_.value_or(Vec3{0.0}), polygons, cut_, corner_of_);
    if (changed.empty()) return;
    for (std::uint32_t polygon : changed) renew_outline(polygon);
    for (std::size_t i = 0; i < corner_of_.size(); ++i) {
        mesh_.faces_.half_edges[i] = {.origin = VertexId{vertex(corner_of_[i])}};
    }
    report_.misoriented_edges = report_.nonmanifold_edges = 0;
    cut_.clear();
    cut_ends_.clear();
    match_twins();
}

// Finds the half-edges of the polygon's corners again.
void MeshBuilder::renew_outline(std::uint32_t polygon) {
    InputForm& form = mesh_.form_;
    const auto by_polygon = [](const auto& x, std::uint32_t p) { return x.polygon < p; };
    const auto outline =
        std::lower_bound(form.outlines.begin(), form.outlines.end(), polygon, by_polygon);
    const auto face =
        std::lower_bound(mesh_.base_faces_.begin(), mesh_.base_faces_.end(), polygon, by_polygon);
    const std::uint32_t begin = input_.polygon_begin(polygon), end = input_.polygon_end[polygon];
    auto h = static_cast<std::uint32_t>(3 * (face - mesh_.base_faces_.begin()));
    std::vector<bool> is_found(end - begin, false);
    for (; h < corner_of_.size() && corner_of_[h] >= begin && corner_of_[h] < end; ++h) {
        const std::uint32_t corner = corner_of_[h] - begin;
        if (!is_found[corner]) {
            form.outline_corners[outline->corners_begin + corner] =
                OutlineCorner::of(HalfEdgeId{h});
        }
        is_found[corner] = true;
    }
}

// Joins boundary edges that coincide without sharing vertices. The cuts then include theirs.
void MeshBuilder::join_unshared() {
    std::optional<JoinedSeams> joined =
        join_seams(mesh_.vertices_.positions, mesh_.faces_.half_edges);
    if (!joined) return;
    report_.seams = joined->seams;
    report_.seam_edges = joined->edges;
    mesh_.form_.seams.representatives = std::move(joined->representatives);
    mesh_.form_.seams.corner_vertices = std::move(joined->corner_vertices);
    seams_ = std::move(joined->half_edges);
    cut_ = std::move(joined->cut);
    cut_ends_ = std::move(joined->cut_ends);
}

void MeshBuilder::make_edges() {
    // Each inner edge has two half-edges.
    mesh_.edges_.half_edges.reserve(mesh_.faces_.half_edges.size() / 2 + cut_.size());
    for (std::uint32_t i = 0; i < mesh_.faces_.half_edges.size(); ++i) {
        const HalfEdgeId h{i};
        if (exists(half(h).edge)) continue;
        const EdgeId e{static_cast<std::uint32_t>(mesh_.edges_.half_edges.size())};
        mesh_.edges_.half_edges.push_back(h);
        half(h).edge = e;
        if (exists(half(h).twin)) half(half(h).twin).edge = e;
    }
    mesh_.edges_.levels.assign(mesh_.edges_.half_edges.size(), 0);
    std::vector<EdgeId>& seam_edges = mesh_.form_.seams.edges;
    for (const HalfEdgeId h : seams_) seam_edges.push_back(half(h).edge);
    std::sort(seam_edges.begin(), seam_edges.end());
    seam_edges.erase(std::unique(seam_edges.begin(), seam_edges.end()), seam_edges.end());
}

void MeshBuilder::join_siblings() {
    if (cut_.empty()) return;
    mesh_.edges_.siblings.resize(mesh_.edges_.half_edges.size());
    for (std::uint32_t e = 0; e < mesh_.edges_.siblings.size(); ++e)
        mesh_.edges_.siblings[e] = EdgeId{e};
    std::size_t begin = 0;
    for (std::size_t end : cut_ends_) {
        for (std::size_t i = begin; i < end; ++i) {
            const HalfEdgeId next = cut_[i + 1 < end ? i + 1 : begin];
            mesh_.edges_.siblings[index(half(cut_[i]).edge)] = half(next).edge;
        }
        begin = end;
    }
}

void MeshBuilder::name_vertices() {
    mesh_.vertices_.half_edges.assign(mesh_.vertices_.positions.size(), kNone<HalfEdgeId>);
    mesh_.vertices_.levels.assign(mesh_.vertices_.positions.size(), 0);
    mesh_.vertices_.deformed.assign(mesh_.vertices_.positions.size(), 0);
    for (std::uint32_t i = static_cast<std::uint32_t>(mesh_.faces_.half_edges.size()); i-- > 0;) {
        mesh_.vertices_.half_edges[index(mesh_.faces_.half_edges[i].origin)] = HalfEdgeId{i};
    }
}

void MeshBuilder::make_wedges() {
    CornerWedges wedges = corner_wedges(mesh_, input_, corner_of_, options_);
    for (std::size_t h = 0; h < mesh_.faces_.half_edges.size(); ++h) {
        mesh_.faces_.half_edges[h].wedge = wedges.of_half_edge[h];
    }
    mesh_.wedges_.normals = taken(wedges.normals);
    mesh_.wedges_.uvs = taken(wedges.uvs);
}

void MeshBuilder::keep_elements() {
    using Kind = IndexedFaceSet::Element::Kind;
    for (const IndexedFaceSet::Element& element : input_.elements) {
        ++(element.kind == Kind::line ? report_.lines : report_.points);
    }
    mesh_.form_.elements = std::move(input_.elements);
    mesh_.form_.element_corners.reserve(input_.element_corners.size());
    for (const Corner& corner : input_.element_corners) {
        mesh_.form_.element_corners.push_back(loose_corner(corner));
    }
}

BuiltMesh build_mesh(IndexedFaceSet input, const BuildOptions& options, const StopToken& stop) {
    return MeshBuilder(std::move(input), options).build(stop);
}

}  // namespace pectin
