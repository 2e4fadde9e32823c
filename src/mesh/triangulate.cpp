#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/binary_digits.h"
#include "geometry/box.h"
#include "geometry/orientation.h"
#include "mesh/delaunay_flips.h"
#include "mesh/ear_clipping.h"
#include "mesh/monotone_sweep.h"
#include "mesh/quad_diagonal.h"
#include "mesh/touching_polygon.h"

namespace pectin {
namespace {

// Newell's normal: its length is twice the area of the polygon, which need not be flat.
Vec3 newell_normal(std::span<const Vec3> corners) {
    Vec3 sum{0.0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 p = corners[i] - corners[0];
        const Vec3 q = corners[(i + 1) % corners.size()] - corners[0];
        sum += glm::cross(p, q);
    }
    return sum;
}

// The power of two by which the corners are scaled, so that products and squares of their
// coordinates neither overflow nor underflow.
int scale_exponent(std::span<const Vec3> corners) {
    double largest = 0.0;
    for (const Vec3& p : corners) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return largest > 0.0 ? -std::ilogb(largest) : 0;
}

Vec3 scaled(const Vec3& p, int exponent) {
    return {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent), std::scalbn(p.z, exponent)};
}

std::vector<Vec3> scaled(std::span<const Vec3> corners) {
    const int exponent = scale_exponent(corners);
    std::vector<Vec3> result;
    for (const Vec3& p : corners) result.push_back(scaled(p, exponent));
    return result;
}

double largest_of(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

// The axis nearest to the normal; the first one if several are equally near up to rounding.
int dropped_axis(std::span<const Vec3> corners, const Vec3& normal) {
    Vec3 size = glm::abs(normal);
    if (normal == Vec3{0.0}) {  // the corners are collinear, or the areas cancel
        Box box;
        for (const Vec3& p : corners) box.include(p);
        size = largest_of(box.extent()) - box.extent();
    }
    constexpr double kEqual = 1e-9;
    const double least = (1.0 - kEqual) * largest_of(size);
    return size.x >= least ? 0 : size.y >= least ? 1 : 2;
}

// The ranks by which ears of equal length are ordered. Corners far from the mirror planes are cut
// off first, so that diagonals end at corners on or near these planes.
std::vector<std::uint32_t> clipping_order(std::span<const Vec3> corners, const Vec3& centre) {
    struct Key {
        std::array<std::int64_t, 6> cells{};
        std::uint32_t corner = 0;
    };
    Box box;
    for (const Vec3& p : corners) box.include(p);
    constexpr double kEqual = 1e-6;  // relative to the polygon's size; more than rounding errors
    const double per_unit = 1.0 / std::max(kEqual * box.diagonal(), 1e-300);
    std::vector<Key> keys(corners.size());
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const Vec3 cells = glm::clamp((corners[i] - centre) * per_unit, -1e18, 1e18);
        keys[i].corner = i;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            keys[i].cells[a] = -std::llround(std::abs(cells[axis]));
            keys[i].cells[a + 3] = -std::llround(cells[axis]);
        }
    }
    std::sort(keys.begin(), keys.end(), [](const Key& x, const Key& y) {
        return std::tie(x.cells, x.corner) < std::tie(y.cells, y.corner);
    });
    std::vector<std::uint32_t> ranks(corners.size());
    for (std::uint32_t rank = 0; rank < ranks.size(); ++rank) ranks[keys[rank].corner] = rank;
    return ranks;
}

// Whether all corners are collinear up to rounding.
bool lie_on_line(std::span<const Vec3> corners) {
    Vec3 along{0.0};
    for (const Vec3& p : corners) {
        const Vec3 other = p - corners[0];
        if (glm::dot(other, other) > glm::dot(along, along)) along = other;
    }
    constexpr double kRounding = 1e-12;
    const double most = kRounding * glm::dot(along, along);
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
        return glm::length(glm::cross(p - corners[0], along)) <= most;
    });
}

bool has_reversed(const std::vector<Vec2>& points, std::span<const CornerTriangle> triangles) {
    return std::any_of(triangles.begin(), triangles.end(), [&](const CornerTriangle& t) {
        return orientation(points[t[0]], points[t[1]], points[t[2]]) < 0;
    });
}

// The search for ears may take this number of steps per corner and per bit of the number of
// corners. Most outlines need less than half of that.
constexpr std::size_t kEarSteps = 4;

class PolygonTriangulator {
  public:
    PolygonTriangulator(std::span<const Vec3> corners, const Vec3& centre)
        : polygon_{.points = {}, .in_space = scaled(corners), .in_plane = {}, .order = {}} {
        normal_ = newell_normal(polygon_.in_space);
        polygon_.order = clipping_order(polygon_.in_space, scaled(centre, scale_exponent(corners)));
        polygon_.points.resize(corners.size());
        polygon_.in_plane.resize(corners.size());
    }

    bool triangulate(std::vector<CornerTriangle>& out) {
        project_along_axis();
        bool covers = clip();
        if (!covers && project_along_normal()) covers = clip();
        if (covers) flip_to_delaunay(polygon_, triangles_);
        out.insert(out.end(), triangles_.begin(), triangles_.end());
        return covers || lie_on_line(polygon_.in_space);
    }

  private:
    // Returns whether the triangles cover the polygon. Ears need few flips afterwards, but thin
    // ones may take long to find. Then a sweep is used instead. If it fails, since the polygon
    // touches or intersects itself, ears are searched again with a higher limit, or with
    // none in a small polygon. A large polygon that needs more is cut without a search.
    bool clip() {
        const std::size_t n = polygon_.points.size();
        if (auto ears = clip_ears(polygon_, kEarSteps * n * binary_digits(n))) {
            triangles_ = std::move(*ears);
            return covers();
        }
        if (take(sweep_triangles(polygon_.points))) return true;
        const bool is_large = n > kMostCornersOfSmall;
        for (const Touch touch : {Touch::outside, Touch::inside}) {
            if (is_large && take(sweep_touching_polygon(polygon_.points, touch))) return true;
        }
        auto ears = clip_ears(polygon_, most_ear_steps(n));
        triangles_ = ears ? std::move(*ears) : clip_corners(polygon_);
        return covers();
    }
    // Returns whether these triangles exist and cover the polygon.
    bool take(std::optional<SweptPolygon> swept) {
        if (!swept) return false;
        triangles_ = std::move(swept->triangles);
        return covers();
    }
    bool covers() const { return !has_reversed(polygon_.points, triangles_); }
    void project_along_axis() {
        const int dropped = dropped_axis(polygon_.in_space, normal_);
        int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
        if (normal_[dropped] < 0.0) std::swap(u, v);
        const Vec3 slopes = normal_[dropped] != 0.0 ? normal_ / normal_[dropped] : Vec3{0.0};
        for (std::size_t i = 0; i < polygon_.points.size(); ++i) {
            const Vec3& p = polygon_.in_space[i];
            polygon_.points[i] = {p[u], p[v]};
            polygon_.in_plane[i] = p;
            polygon_.in_plane[i][dropped] = -(slopes[u] * p[u] + slopes[v] * p[v]);
        }
    }
    // Projects along the normal, which rounds. Returns false if there is no normal.
    bool project_along_normal() {
        const Vec3 n = unit_or_zero(normal_);
        if (n == Vec3{0.0}) return false;
        const Vec3 other = std::abs(n.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 u = glm::normalize(glm::cross(n, other)), v = glm::cross(n, u);
        for (std::size_t i = 0; i < polygon_.points.size(); ++i) {
            const Vec3& p = polygon_.in_space[i];
            polygon_.points[i] = {glm::dot(p, u), glm::dot(p, v)};
            polygon_.in_plane[i] = {polygon_.points[i], 0.0};
        }
        return true;
    }

    FlatPolygon polygon_;
    Vec3 normal_{0.0};
    std::vector<CornerTriangle> triangles_;
};

bool triangulate_quad(std::span<const Vec3> corners, const Vec3& centre,
                      std::vector<CornerTriangle>& triangles) {
    std::array<Vec3, 4> quad{corners[0], corners[1], corners[2], corners[3]};
    const int exponent = scale_exponent(quad);
    constexpr int kHarmless = 64;  // fourth powers of coordinates below 2^64 are finite
    Vec3 scaled_centre = centre;
    if (std::abs(exponent) > kHarmless) {
        for (Vec3& p : quad) p = scaled(p, exponent);
        scaled_centre = scaled(centre, exponent);
    }
    const QuadDiagonal diagonal = choose_diagonal(quad, scaled_centre);
    if (diagonal.joins_1_and_3) {
        triangles.push_back({0, 1, 3});
        triangles.push_back({1, 2, 3});
    } else {
        triangles.push_back({0, 1, 2});
        triangles.push_back({0, 2, 3});
    }
    return diagonal.covers;
}

}  // namespace

bool triangulate(std::span<const Vec3> corners, std::vector<CornerTriangle>& triangles,
                 const Vec3& centre) {
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return true;
    }
    if (corners.size() == 4) return triangulate_quad(corners, centre, triangles);
    return PolygonTriangulator(corners, centre).triangulate(triangles);
}

}  // namespace pectin
