// TriMesh::baked: a refined mesh as a base mesh.
#include <algorithm>
#include <utility>
#include <vector>

#include "mesh/face_pieces.h"
#include "mesh/unshared_colors.h"
#include "mesh/unshared_vertices.h"

namespace pectin {
namespace {

// New ids for those that are live, in the order of the old ones.
template <typename Id>
class Renumbering {
  public:
    explicit Renumbering(std::uint32_t slots) : new_ids_(slots, kNone<Id>) {}

    void add(Id id) {
        if (!exists(new_ids_[index(id)])) new_ids_[index(id)] = Id{count_++};
    }
    Id operator[](Id id) const { return new_ids_[index(id)]; }
    std::uint32_t count() const { return count_; }
    std::vector<Id> take() { return std::move(new_ids_); }

  private:
    std::vector<Id> new_ids_;
    std::uint32_t count_ = 0;
};

// values[old] for each old id that has a new one, at the new one.
template <typename T, typename Id>
GrowingArray<T> gathered(const GrowingArray<T>& values, const Renumbering<Id>& ids) {
    GrowingArray<T> result;
    result.resize(values.empty() ? 0 : ids.count());
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        if (exists(ids[Id{i}])) result[index(ids[Id{i}])] = values[i];
    }
    return result;
}

}  // namespace

class MeshBaker {
  public:
    explicit MeshBaker(const TriMesh& from)
        : from_(from),
          pieces_(from),
          unshared_(from),
          vertices_(from.vertex_slots()),
          wedges_(from.wedge_slots()),
          edges_(from.edge_slots()),
          faces_(from.face_slots()) {}

    Baked bake() {
        number();
        take_attributes();
        take_connectivity();
        take_polygons();
        take_elements();
        take_seams();
        return {std::move(to_), edges_.take()};
    }

  private:
    void number();
    void take_attributes();
    void take_connectivity();
    void take_polygons();
    void take_outline(const PolygonWalk& polygon);
    void take_elements();
    void take_seams();
    void add_unused_vertex(VertexId v);
    void take_colors(std::span<const Vec3f> colors);
    HalfEdgeId renumbered(HalfEdgeId h) const {
        if (!exists(h)) return h;
        return HalfEdgeId{3 * index(faces_[TriMesh::face(h)]) + index(h) % 3};
    }

    const TriMesh& from_;
    FacePieces pieces_;
    UnsharedVertices unshared_;
    Renumbering<VertexId> vertices_;
    Renumbering<WedgeId> wedges_;
    Renumbering<EdgeId> edges_;
    Renumbering<FaceId> faces_;
    std::vector<std::uint32_t> polygons_;  // first new polygon of each old one; see take_polygons
    TriMesh to_;
};

void MeshBaker::number() {
    for (std::uint32_t i = 0; i < from_.vertex_slots(); ++i) {
        if (from_.is_live(VertexId{i})) vertices_.add(VertexId{i});
    }
    for (std::uint32_t i = 0; i < from_.edge_slots(); ++i) {
        if (from_.is_live(EdgeId{i})) edges_.add(EdgeId{i});
    }
    for (FaceId f : pieces_.all()) faces_.add(f);
    std::vector<bool> is_used(from_.wedge_slots(), false);
    for (FaceId f : pieces_.all()) {
        for (int c = 0; c < 3; ++c) is_used[index(from_.wedge(TriMesh::half_edge(f, c)))] = true;
    }
    for (std::uint32_t i = 0; i < from_.wedge_slots(); ++i) {
        if (is_used[i]) wedges_.add(WedgeId{i});
    }
}

void MeshBaker::take_attributes() {
    to_.base_vertices_ = vertices_.count();
    to_.positions_ = gathered(from_.positions_, vertices_);
    to_.colors_ = gathered(from_.colors_, vertices_);
    to_.deformed_ = gathered(from_.deformed_, vertices_);
    to_.vertex_levels_.assign(vertices_.count(), 0);
    to_.normals_ = gathered(from_.normals_, wedges_);
    to_.uvs_ = gathered(from_.uvs_, wedges_);
    to_.edge_levels_.assign(edges_.count(), 0);
}

void MeshBaker::take_connectivity() {
    to_.half_edges_.resize(3 * std::size_t{faces_.count()});
    to_.face_bases_.resize(faces_.count());
    for (FaceId f : pieces_.all()) {
        to_.face_bases_[index(faces_[f])] = faces_[f];
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(f, c);
            to_.half_edges_[index(renumbered(h))] = {
                vertices_[from_.origin(h)], renumbered(from_.twin(h)), wedges_[from_.wedge(h)],
                edges_[from_.edge(h)]};
        }
    }
    to_.vertex_half_edges_ = gathered(from_.vertex_half_edges_, vertices_);
    to_.edge_half_edges_ = gathered(from_.edge_half_edges_, edges_);
    for (HalfEdgeId& h : to_.vertex_half_edges_) h = renumbered(h);
    for (HalfEdgeId& h : to_.edge_half_edges_) h = renumbered(h);
    to_.siblings_ = gathered(from_.siblings_, edges_);
    for (EdgeId& e : to_.siblings_) e = edges_[e];
}

// polygons_[p]: how many new polygons come before those of old polygon p; filled up as p goes by.
void MeshBaker::take_polygons() {
    to_.form_.parts = from_.form_.parts;
    to_.form_.material_libraries = from_.form_.material_libraries;
    std::uint32_t polygons = 0;
    PolygonWalk polygon(from_);
    while (polygon.next()) {
        polygons_.resize(polygon.polygon() + std::size_t{1}, polygons);
        const std::uint32_t first = polygon.first_face(), end = polygon.end_face();
        const bool is_whole = pieces_.are_whole(first, end);
        if (is_whole && polygon.has_outline()) {
            to_.form_.outlines.push_back(
                {polygons, polygon.part(),
                 static_cast<std::uint32_t>(to_.form_.outline_corners.size())});
            take_outline(polygon);
        }
        for ([[maybe_unused]] FaceId f : pieces_.of(first, end)) {
            to_.base_faces_.push_back({polygon.part(), polygons});
            if (!is_whole) ++polygons;
        }
        if (is_whole) ++polygons;
    }
    polygons_.push_back(polygons);
}

void MeshBaker::take_outline(const PolygonWalk& polygon) {
    for (OutlineCorner corner : polygon.outline()) {
        if (corner.is_loose()) {  // of a base vertex, which keeps its id
            std::vector<LooseCorner>& loose = to_.form_.loose_corners;
            loose.push_back(from_.form_.loose_corners[corner.loose_index()]);
            corner = OutlineCorner::loose(static_cast<std::uint32_t>(loose.size() - 1));
        } else {
            corner = OutlineCorner::of(renumbered(corner.half_edge()));
        }
        to_.form_.outline_corners.push_back(corner);
    }
}

void MeshBaker::take_elements() {
    to_.form_.elements = from_.form_.elements;
    to_.form_.element_corners = from_.form_.element_corners;
    for (InputForm::Element& element : to_.form_.elements) {
        const std::size_t before =
            std::min<std::size_t>(element.before_polygon, polygons_.size() - 1);
        element.before_polygon = polygons_[before];
    }
}

// Vertices that have been inserted along seams become as many as a save would write; those that the
// faces do not use come last.
void MeshBaker::take_seams() {
    const UnsharedSeams& seams = from_.form_.seams;
    if (seams.is_empty()) return;
    UnsharedSeams& to = to_.form_.seams;
    for (const EdgeId e : unshared_.edges()) to.edges.push_back(edges_[e]);
    std::sort(to.edges.begin(), to.edges.end());
    const std::uint32_t slots = from_.vertex_slots();
    for (const FaceId f : pieces_.all()) {
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t v = unshared_.of(TriMesh::half_edge(f, c));
            to.corner_vertices.push_back(v < slots ? vertices_[VertexId{v}]
                                                   : VertexId{vertices_.count() + v - slots});
        }
    }
    for (std::uint32_t v = 0; v < vertices_.count(); ++v) {
        const bool was_base = v < from_.base_vertex_count();  // base vertices keep their ids
        to.representatives.push_back(was_base ? seams.representatives[v] : VertexId{v});
    }
    for (const VertexId v : unshared_.added()) add_unused_vertex(v);
    if (const auto colors = unshared_colors(from_, unshared_)) take_colors(*colors);
}

void MeshBaker::take_colors(std::span<const Vec3f> colors) {
    for (std::uint32_t v = 0; v < from_.vertex_slots(); ++v) {
        if (exists(vertices_[VertexId{v}])) to_.colors_[index(vertices_[VertexId{v}])] = colors[v];
    }
    const std::span<const Vec3f> added = colors.subspan(from_.vertex_slots());
    std::copy(added.begin(), added.end(), to_.colors_.begin() + vertices_.count());
}

// A vertex without faces at v.
void MeshBaker::add_unused_vertex(VertexId v) {
    to_.form_.seams.representatives.push_back(vertices_[v]);
    to_.positions_.push_back(from_.position(v));
    if (from_.has_colors()) to_.colors_.push_back(from_.color(v));
    to_.deformed_.push_back(from_.is_deformed(v) ? 1 : 0);
    to_.vertex_levels_.push_back(0);
    to_.vertex_half_edges_.push_back(kNone<HalfEdgeId>);
    ++to_.base_vertices_;
}

Baked TriMesh::baked() const { return MeshBaker(*this).bake(); }

}  // namespace pectin
