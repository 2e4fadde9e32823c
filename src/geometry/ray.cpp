#include "geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pectin {
namespace {

// T. Ize. Robust BVH Ray Traversal. Journal of Computer Graphics Techniques 2(2), 2013: two
// rounding errors in each direction.
constexpr double kOutwards = 1.0 + 4.0 * std::numeric_limits<double>::epsilon();

int largest_axis(const Vec3& v) {
    const Vec3 size = glm::abs(v);
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

// Maps points to a space that is sheared so that the ray is the z axis.
class RaySpace {
  public:
    explicit RaySpace(const Ray& ray) : origin_(ray.origin) {
        z_ = largest_axis(ray.direction);
        x_ = (z_ + 1) % 3;
        y_ = (x_ + 1) % 3;
        if (ray.direction[z_] < 0.0) std::swap(x_, y_);  // keeps the sense of rotation
        shear_ = Vec3{ray.direction[x_], ray.direction[y_], 1.0} / ray.direction[z_];
    }
    Vec3 operator()(const Vec3& p) const {
        const Vec3 q = p - origin_;
        return {q[x_] - shear_.x * q[z_], q[y_] - shear_.y * q[z_], shear_.z * q[z_]};
    }

  private:
    Vec3 origin_, shear_{0.0};
    int x_ = 0, y_ = 1, z_ = 2;
};

}  // namespace

std::optional<RayInterval> intersect(const Ray& ray, const Box& box) {
    RayInterval interval;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = ray.origin[axis], along = ray.direction[axis];
        if (along == 0.0) {
            if (from < box.min[axis] || from > box.max[axis]) return std::nullopt;
            continue;
        }
        double enter = (box.min[axis] - from) / along, leave = (box.max[axis] - from) / along;
        if (along < 0.0) std::swap(enter, leave);
        interval.enter = std::max(interval.enter, enter / kOutwards);
        interval.leave = std::min(interval.leave, leave * kOutwards);
    }
    if (!(interval.enter <= interval.leave)) return std::nullopt;
    return interval;
}

std::optional<RayHit> intersect(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const RaySpace in_ray_space(ray);
    const Vec3 p = in_ray_space(a), q = in_ray_space(b), r = in_ray_space(c);
    // Each is the exact negative of what the triangle on the other side of that edge computes.
    const double u = r.x * q.y - r.y * q.x;
    const double v = p.x * r.y - p.y * r.x;
    const double w = q.x * p.y - q.y * p.x;
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
    const double sum = u + v + w;
    if (sum == 0.0) return std::nullopt;
    const double t = (u * p.z + v * q.z + w * r.z) / sum;
    if (!(t >= 0.0)) return std::nullopt;
    return RayHit{.t = t, .u = u / sum, .v = v / sum, .w = w / sum, .from_outside = sum > 0.0};
}

}  // namespace pectin
