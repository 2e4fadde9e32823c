// TriMesh::baked: a refined mesh as a base mesh.
#include <algorithm>
#include <utility>
#include <vector>

#include "mesh/face_pieces.h"
#include "mesh/unshared_colors.h"
#include "mesh/unshared_vertices.h"

namespace pectin {
namespace {

// The new ids of the elements that are added, in the order of the calls.
template <typename Id>
class Renumbering {
  public:
    explicit Renumbering(std::uint32_t slots) : new_ids_(slots, kNone<Id>) {}

    void add(Id id) {
        if (!exists(new_ids_[index(id)])) new_ids_[index(id)] = Id{count_++};
    }
    Id operator[](Id id) const { return new_ids_[index(id)]; }
    std::uint32_t count() const { return count_; }

  private:
    std::vector<Id> new_ids_;
    std::uint32_t count_ = 0;
};

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

    TriMesh bake() {
        number();
        take_columns();
        take_polygons();
        take_elements();
        take_seams();
        return std::move(to_);
    }

  private:
    void number();
    void take_columns();
    template <typename Columns>
    void gather(SlotTable<Columns>& to, const SlotTable<Columns>& from,
                const Renumbering<typename Columns::Id>& ids) const;
    void take_polygons();
    void take_outline(const PolygonWalk& polygon);
    void take_elements();
    void take_seams();
    void add_unused_vertex(VertexId v);
    void take_colors(std::span<const Vec3f> colors);

    // A value of a column, with new ids in place of old ones.
    template <typename T>
    T renumbered(const T& attribute) const {
        return attribute;
    }
    EdgeId renumbered(EdgeId e) const { return edges_[e]; }
    HalfEdgeId renumbered(HalfEdgeId h) const {
        if (!exists(h)) return h;
        return HalfEdgeId{3 * index(faces_[TriMesh::face(h)]) + index(h) % 3};
    }
    HalfEdge renumbered(const HalfEdge& h) const {
        return {vertices_[h.origin], renumbered(h.twin), wedges_[h.wedge], edges_[h.edge]};
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

void MeshBaker::take_columns() {
    to_.base_vertices_ = vertices_.count();
    gather(to_.vertices_, from_.vertices_, vertices_);
    gather(to_.wedges_, from_.wedges_, wedges_);
    gather(to_.edges_, from_.edges_, edges_);
    gather(to_.faces_, from_.faces_, faces_);
    to_.vertices_.levels.assign(vertices_.count(), 0);
    to_.edges_.levels.assign(edges_.count(), 0);
    for (std::uint32_t f = 0; f < faces_.count(); ++f) to_.faces_.bases[f] = FaceId{f};
}

// Copies the rows of all slots that have a new id.
template <typename Columns>
void MeshBaker::gather(SlotTable<Columns>& to, const SlotTable<Columns>& from,
                       const Renumbering<typename Columns::Id>& ids) const {
    Columns::for_each_column(
        [&](const auto& column, auto& new_values, const auto& old_values) {
            if (old_values.empty()) return;
            new_values.resize(column.per_slot * ids.count());
            for (std::uint32_t i = 0; i < from.slots(); ++i) {
                const auto id = ids[typename Columns::Id{i}];
                if (!exists(id)) continue;
                for (std::size_t k = 0; k < column.per_slot; ++k) {
                    new_values[column.per_slot * index(id) + k] =
                        renumbered(old_values[column.per_slot * i + k]);
                }
            }
        },
        to, from);
}

// Numbers the new polygons. polygons_[p] becomes the number of new polygons before those of old
// polygon p.
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
        if (corner.is_loose()) {  // its vertex is a base vertex, which keeps its id
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

// A vertex that was inserted along a seam becomes as many vertices as a save would write. Those
// that no face uses come last.
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
        if (exists(vertices_[VertexId{v}]))
            to_.vertices_.colors[index(vertices_[VertexId{v}])] = colors[v];
    }
    const std::span<const Vec3f> added = colors.subspan(from_.vertex_slots());
    std::copy(added.begin(), added.end(), to_.vertices_.colors.begin() + vertices_.count());
}

// Adds a vertex without faces at the position of v.
void MeshBaker::add_unused_vertex(VertexId v) {
    to_.form_.seams.representatives.push_back(vertices_[v]);
    to_.vertices_.positions.push_back(from_.position(v));
    if (from_.has_colors()) to_.vertices_.colors.push_back(from_.color(v));
    to_.vertices_.deformed.push_back(from_.is_deformed(v) ? 1 : 0);
    to_.vertices_.levels.push_back(0);
    to_.vertices_.half_edges.push_back(kNone<HalfEdgeId>);
    ++to_.base_vertices_;
}

TriMesh TriMesh::baked() const { return MeshBaker(*this).bake(); }

}  // namespace pectin
