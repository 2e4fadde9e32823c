// The exact surface of a certified mesh, sampled.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ffd/warp.h"
#include "mesh/tri_mesh.h"

namespace pectin::test {

using Corners = std::array<Vec3, 3>;

// The images of points under warps, one after another, computed in double by the displaced
// lattices.
class ExactImage {
  public:
    void add(const Warp& warp);
    Vec3 operator()(Vec3 point) const;

  private:
    std::vector<std::vector<LatticeField>> steps_;
};

// Calls visit(weights) for the barycentric coordinates of samples of a triangle, `count` along a
// side.
template <typename Visit>
void for_each_sample(int count, const Visit& visit) {
    for (int i = 0; i <= count; ++i) {
        for (int j = 0; i + j <= count; ++j) {
            visit(Vec3{i, j, count - i - j} / static_cast<double>(count));
        }
    }
}

inline Vec3 point_of(const Corners& corners, const Vec3& weights) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

// The largest distance of a sample of the flat triangle `now` from the image of that of `rest`.
double sampled_error(const ExactImage& image, const Corners& rest, const Corners& now, int count);

Corners corners_of(const TriMesh& mesh, FaceId f);

// The same faces and ids as those of `mesh`, on the surface of `base`, whose refinement it is: each
// inserted vertex in the middle of the ends of the edge that was split.
TriMesh on_original_surface(const TriMesh& mesh, const TriMesh& base);

}  // namespace pectin::test
