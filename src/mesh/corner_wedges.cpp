#include "mesh/corner_wedges.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

namespace pectin {
namespace {

double corner_angle(const TriMesh& mesh, HalfEdgeId h) {
    const Vec3& p = mesh.position(mesh.origin(h));
    const Vec3 u = mesh.position(mesh.target(h)) - p;
    const Vec3 v = mesh.position(mesh.origin(TriMesh::prev(h))) - p;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// Groups the half-edges by their origin, with a counting sort.
class OutgoingHalfEdges {
  public:
    explicit OutgoingHalfEdges(const TriMesh& mesh)
        : first_(mesh.vertex_slots() + std::size_t{1}, 0), half_edges_(3 * mesh.face_slots()) {
        const auto count = static_cast<std::uint32_t>(half_edges_.size());
        for (std::uint32_t h = 0; h < count; ++h) ++first_[index(mesh.origin(HalfEdgeId{h})) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
        for (std::uint32_t h = 0; h < count; ++h) {
            half_edges_[at[index(mesh.origin(HalfEdgeId{h}))]++] = HalfEdgeId{h};
        }
    }
    // The outgoing half-edges of a vertex, in ascending order.
    std::span<const HalfEdgeId> of(std::uint32_t vertex) const {
        return std::span(half_edges_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }

  private:
    std::vector<std::uint32_t> first_;
    std::vector<HalfEdgeId> half_edges_;
};

// Computes the normals of the corners around one vertex at a time.
class SmoothNormals {
  public:
    SmoothNormals(const TriMesh& mesh, std::span<const std::uint32_t> corner_of,
                  const BuildOptions& options)
        : mesh_(mesh),
          corner_of_(corner_of),
          by_groups_(std::any_of(mesh.input_form().parts.begin(), mesh.input_form().parts.end(),
                                 [](const Part& p) { return p.smoothing_group != 0; })),
          smooth_cosine_(std::cos(options.crease_angle * std::numbers::pi / 180.0)),
          face_normals_(mesh.face_slots()) {
        for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
            face_normals_[f] = unit_or_zero(mesh.area_normal(FaceId{f}));
        }
    }

    // corners: all outgoing half-edges of one vertex, ascending. out: one normal per corner.
    void find(std::span<const HalfEdgeId> corners, std::vector<Vec3f>& out) {
        parent_.resize(corners.size());
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (std::uint32_t i = 0; i < corners.size(); ++i) join_across_edge(corners, i);
        join_pieces_of_corners(corners);
        sums_.assign(corners.size(), Vec3{0.0});
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            sums_[root(i)] +=
                corner_angle(mesh_, corners[i]) * face_normals_[index(corners[i]) / 3];
        }
        out.resize(corners.size());
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            out[i] = Vec3f{unit_or_zero(sums_[root(i)])};
        }
    }

  private:
    // Joins the corners that share a normal, as a disjoint-set forest.
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join_across_edge(std::span<const HalfEdgeId> corners, std::uint32_t i) {
        const HalfEdgeId twin = mesh_.twin(corners[i]);
        if (!exists(twin) || !is_smooth(TriMesh::face(corners[i]), TriMesh::face(twin))) return;
        const auto other = std::lower_bound(corners.begin(), corners.end(), TriMesh::next(twin));
        join(i, static_cast<std::uint32_t>(other - corners.begin()));
    }

    // The triangles of a polygon share its corner, also where a cut runs between them.
    void join_pieces_of_corners(std::span<const HalfEdgeId> corners) {
        const auto polygon = [&](HalfEdgeId h) { return mesh_.polygon(TriMesh::face(h)); };
        const auto neighbours = std::adjacent_find(
            corners.begin(), corners.end(),
            [&](HalfEdgeId x, HalfEdgeId y) { return polygon(x) == polygon(y); });
        if (neighbours == corners.end()) return;  // the mesh has only triangles
        by_input_corner_.resize(corners.size());
        std::iota(by_input_corner_.begin(), by_input_corner_.end(), 0u);
        const auto input_corner = [&](std::uint32_t i) { return corner_of_[index(corners[i])]; };
        std::sort(by_input_corner_.begin(), by_input_corner_.end(),
                  [&](auto x, auto y) { return input_corner(x) < input_corner(y); });
        for (std::size_t i = 1; i < by_input_corner_.size(); ++i) {
            const std::uint32_t x = by_input_corner_[i - 1], y = by_input_corner_[i];
            if (input_corner(x) == input_corner(y)) join(x, y);
        }
    }

    void join(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t x = root(i), y = root(j);
        parent_[std::max(x, y)] = std::min(x, y);
    }

    bool is_smooth(FaceId f, FaceId g) const {
        if (mesh_.polygon(f) == mesh_.polygon(g)) return true;
        if (by_groups_) {
            const std::uint32_t group = mesh_.part(f).smoothing_group;
            return group != 0 && group == mesh_.part(g).smoothing_group;
        }
        const Vec3 &nf = face_normals_[index(f)], &ng = face_normals_[index(g)];
        // A face without area has no normal to measure the crease angle with.
        const bool flat = nf == Vec3{0.0} || ng == Vec3{0.0};
        return flat || glm::dot(nf, ng) >= smooth_cosine_;
    }

    const TriMesh& mesh_;
    std::span<const std::uint32_t> corner_of_;
    bool by_groups_;
    double smooth_cosine_;
    std::vector<Vec3> face_normals_;
    std::vector<std::uint32_t> parent_, by_input_corner_;
    std::vector<Vec3> sums_;
};

// Assigns wedges to the corners of one vertex at a time, by their values.
class WedgeFinder {
  public:
    explicit WedgeFinder(CornerWedges& wedges, bool with_uvs)
        : wedges_(wedges), with_uvs_(with_uvs) {}

    void begin_vertex(std::size_t corners) {
        first_ = wedges_.normals.size();
        has_many_ = corners > kFew;
        if (has_many_) by_value_.clear();
    }

    WedgeId find_or_add(const Vec3f& normal, const Vec2f& uv) {
        if (has_many_) {
            const auto [found, is_new] = by_value_.try_emplace({normal, uv}, next_id());
            if (is_new) add(normal, uv);
            return found->second;
        }
        for (std::size_t w = first_; w < wedges_.normals.size(); ++w) {
            if (std::memcmp(&wedges_.normals[w], &normal, sizeof normal) == 0 &&
                (!with_uvs_ || std::memcmp(&wedges_.uvs[w], &uv, sizeof uv) == 0)) {
                return WedgeId{static_cast<std::uint32_t>(w)};
            }
        }
        const WedgeId w = next_id();
        add(normal, uv);
        return w;
    }

  private:
    // With more corners than this, a hash table is faster than a linear search.
    static constexpr std::size_t kFew = 32;
    struct Value {
        Vec3f normal;
        Vec2f uv;
        bool operator<(const Value& o) const { return std::memcmp(this, &o, sizeof o) < 0; }
    };
    static_assert(sizeof(Value) == sizeof(Vec3f) + sizeof(Vec2f));  // no padding

    WedgeId next_id() const { return WedgeId{static_cast<std::uint32_t>(wedges_.normals.size())}; }
    void add(const Vec3f& normal, const Vec2f& uv) {
        wedges_.normals.push_back(normal);
        if (with_uvs_) wedges_.uvs.push_back(uv);
    }

    CornerWedges& wedges_;
    bool with_uvs_;
    bool has_many_ = false;
    std::size_t first_ = 0;
    std::map<Value, WedgeId> by_value_;
};

bool all_have_normals(const IndexedFaceSet& input, std::span<const std::uint32_t> corner_of) {
    return std::none_of(corner_of.begin(), corner_of.end(), [&](std::uint32_t c) {
        return input.corners[c].normal == IndexedFaceSet::kNoIndex;
    });
}

}  // namespace

CornerWedges corner_wedges(const TriMesh& mesh, const IndexedFaceSet& input,
                           std::span<const std::uint32_t> corner_of, const BuildOptions& options) {
    const bool with_uvs = !input.uvs.empty();
    std::unique_ptr<SmoothNormals> smooth;
    if (!all_have_normals(input, corner_of))
        smooth = std::make_unique<SmoothNormals>(mesh, corner_of, options);

    const OutgoingHalfEdges outgoing(mesh);
    CornerWedges wedges;
    wedges.of_half_edge.resize(corner_of.size());
    wedges.normals.reserve(mesh.vertex_slots());
    if (with_uvs) wedges.uvs.reserve(mesh.vertex_slots());
    WedgeFinder finder(wedges, with_uvs);
    std::vector<Vec3f> normals;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        const std::span<const HalfEdgeId> corners = outgoing.of(v);
        if (smooth) smooth->find(corners, normals);
        finder.begin_vertex(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const IndexedFaceSet::Corner& corner = input.corners[corner_of[index(corners[i])]];
            const bool has_normal = corner.normal != IndexedFaceSet::kNoIndex;
            const bool has_uv = corner.uv != IndexedFaceSet::kNoIndex;
            wedges.of_half_edge[index(corners[i])] =
                finder.find_or_add(has_normal ? input.normals[corner.normal] : normals[i],
                                   has_uv ? input.uvs[corner.uv] : kNoUv);
        }
    }
    return wedges;
}

}  // namespace pectin
