#include "mesh/mirror_centre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/box.h"

namespace pectin {
namespace {

// Files have coordinates of at least six digits. Distances below this part of the diagonal are 0.
constexpr double kEqual = 1e-6;

using Cell = std::array<std::int64_t, 3>;

class ImageCounter {
  public:
    ImageCounter(std::span<const Vec3> points, const Vec3& origin, double cell)
        : points_(points), origin_(origin), cell_(cell) {
        cells_.reserve(points.size());
        for (const Vec3& p : points) cells_.push_back(cell_of(p));
        std::sort(cells_.begin(), cells_.end());
    }

    // The number of points that have a point near their mirror image across the plane axis =
    // middle.
    std::size_t count(int axis, double middle) const {
        return static_cast<std::size_t>(std::count_if(points_.begin(), points_.end(), [&](Vec3 p) {
            p[axis] = 2.0 * middle - p[axis];
            return has_near(p, axis);
        }));
    }

  private:
    Cell cell_of(const Vec3& p) const {
        const Vec3 cells = (p - origin_) / cell_;
        return {std::llround(cells.x), std::llround(cells.y), std::llround(cells.z)};
    }
    // Mirroring rounds only the mirrored coordinate, so the other two are compared exactly.
    bool has_near(const Vec3& p, int axis) const {
        Cell cell = cell_of(p);
        auto& along = cell[static_cast<std::size_t>(axis)];
        --along;
        for (int i = 0; i < 3; ++i, ++along) {
            if (std::binary_search(cells_.begin(), cells_.end(), cell)) return true;
        }
        return false;
    }

    std::span<const Vec3> points_;
    Vec3 origin_;
    double cell_;
    std::vector<Cell> cells_;
};

}  // namespace

Vec3 mirror_centre(std::span<const Vec3> points) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    Vec3 centre{0.0};
    const double equal = kEqual * box.diagonal();
    if (!(equal > 0.0) || !std::isfinite(equal)) return centre;
    const Vec3 middle = box.centre();
    const bool is_about_origin = glm::all(glm::lessThanEqual(glm::abs(middle), Vec3{equal}));
    if (is_about_origin) return centre;
    const ImageCounter images(points, box.min, equal);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(middle[axis]) <= equal) continue;
        // The plane through 0 can mirror points only if the object reaches across it.
        const bool crosses = box.min[axis] < 0.0 && box.max[axis] > 0.0;
        const std::size_t at_origin = crosses ? images.count(axis, 0.0) : 0;
        if (images.count(axis, middle[axis]) > at_origin) centre[axis] = middle[axis];
    }
    return centre;
}

}  // namespace pectin
