#include "mesh/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

// Corners that see one normal at their vertex, as a disjoint-set forest over half-edges.
class SmoothCorners {
  public:
    explicit SmoothCorners(std::uint32_t count) : parent_(count) {
        for (std::uint32_t i = 0; i < count; ++i) parent_[i] = i;
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(HalfEdgeId x, HalfEdgeId y) {
        const std::uint32_t rx = root(index(x)), ry = root(index(y));
        parent_[std::max(rx, ry)] = std::min(rx, ry);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

double corner_angle(const TriMesh& mesh, HalfEdgeId h) {
    const Vec3& p = mesh.position(mesh.origin(h));
    const Vec3 u = mesh.position(mesh.target(h)) - p;
    const Vec3 v = mesh.position(mesh.origin(TriMesh::prev(h))) - p;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

}  // namespace

std::vector<Vec3f> corner_normals(const TriMesh& mesh, const IndexedFaceSet& input,
                                  std::span<const std::uint32_t> corner_of,
                                  const BuildOptions& options) {
    const auto count = static_cast<std::uint32_t>(corner_of.size());
    std::vector<Vec3f> normals(count);
    bool all_given = true;
    for (std::uint32_t h = 0; h < count; ++h) {
        const std::uint32_t given = input.corners[corner_of[h]].normal;
        if (given == IndexedFaceSet::kNoIndex) {
            all_given = false;
        } else {
            normals[h] = input.normals[given];
        }
    }
    if (all_given) return normals;

    const bool by_groups = std::any_of(input.parts.begin(), input.parts.end(),
                                       [](const Part& p) { return p.smoothing_group != 0; });
    const double smooth_cosine = std::cos(options.crease_angle * std::numbers::pi / 180.0);
    std::vector<Vec3> face_normals(count / 3);
    for (std::uint32_t f = 0; f < count / 3; ++f) {
        face_normals[f] = unit_or_zero(mesh.area_normal(FaceId{f}));
    }
    const auto is_smooth = [&](FaceId f, FaceId g) {
        if (by_groups) {
            const std::uint32_t group = mesh.part(f).smoothing_group;
            return group != 0 && group == mesh.part(g).smoothing_group;
        }
        const Vec3 &nf = face_normals[index(f)], &ng = face_normals[index(g)];
        // A face without area has no direction of its own to turn by.
        const bool flat = nf == Vec3{0.0} || ng == Vec3{0.0};
        return flat || glm::dot(nf, ng) >= smooth_cosine;
    };

    SmoothCorners groups(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const HalfEdgeId h{i}, twin = mesh.twin(h);
        if (exists(twin) && is_smooth(TriMesh::face(h), TriMesh::face(twin))) {
            groups.join(h, TriMesh::next(twin));
        }
    }
    std::vector<Vec3> sums(count, Vec3{0.0});
    for (std::uint32_t h = 0; h < count; ++h) {
        sums[groups.root(h)] += corner_angle(mesh, HalfEdgeId{h}) * face_normals[h / 3];
    }
    for (std::uint32_t h = 0; h < count; ++h) {
        if (input.corners[corner_of[h]].normal == IndexedFaceSet::kNoIndex) {
            normals[h] = Vec3f{unit_or_zero(sums[groups.root(h)])};
        }
    }
    return normals;
}

}  // namespace pectin
