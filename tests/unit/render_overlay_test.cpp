// What the overlays of lattices consist of.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/overlay.h"

namespace pectin {
namespace {

constexpr Box kBox{.min = Vec3{-1.0}, .max = Vec3{1.0}};

bool is_in_box(const Vec3& p) { return glm::all(glm::lessThan(glm::abs(p), Vec3{1.0 + 1e-9})); }

TEST(LatticeOverlay, DrawsTheMarginsOfACageFainterAndSmallerThanThePointsOnTheBox) {
    Overlay overlay;
    add_lattice(overlay, fit_lattice(kBox, IVec3{4}), {});
    int on_box = 0, beyond = 0;
    float least_on_box = 1e9f, most_beyond = 0.0f;
    for (const Overlay::Point& point : overlay.points) {
        const bool is_inside = is_in_box(point.position);
        (is_inside ? on_box : beyond) += 1;
        const float weight = point.diameter * point.colour.alpha;
        if (is_inside) {
            least_on_box = std::min(least_on_box, weight);
        } else {
            most_beyond = std::max(most_beyond, weight);
        }
    }
    EXPECT_EQ(on_box, 64);
    EXPECT_EQ(beyond, 216 - 64);
    EXPECT_LT(most_beyond, 0.4f * least_on_box);
    for (const Overlay::Line& line : overlay.lines) {
        const bool is_inside = is_in_box(line.from) && is_in_box(line.to);
        EXPECT_EQ(line.colour.alpha > 100, is_inside);
        const Vec3 reach = glm::max(glm::abs(line.from), glm::abs(line.to));
        EXPECT_LT(std::max({reach.x, reach.y, reach.z}), 1.0 + 0.7) << "one layer beyond the box";
    }
}

TEST(LatticeOverlay, ShowsMovedPointsOfTheMarginAsAnyOther) {
    const Lattice cage = fit_lattice(kBox, IVec3{3});
    std::vector<Vec3> displacements(cage.control_count(), Vec3{0.0});
    displacements[cage.control_index({0, 0, 0})] = Vec3{0.1};
    displacements[cage.control_index({1, 1, 1})] = Vec3{0.1};
    Overlay overlay;
    add_lattice(overlay, cage, displacements);
    const auto at = [&](const IVec3& index) {
        const Vec3 position = cage.rest(index) + Vec3{0.1};
        return *std::ranges::find_if(overlay.points, [&](const Overlay::Point& point) {
            return glm::distance(point.position, position) < 1e-9;
        });
    };
    EXPECT_EQ(at({0, 0, 0}).diameter, at({1, 1, 1}).diameter);
    EXPECT_EQ(at({0, 0, 0}).colour.alpha, at({1, 1, 1}).colour.alpha);
}

TEST(LatticeOverlay, ShowsTheZonesOfTheLatticeOfABrush) {
    Overlay overlay;
    const Lattice brush = brush_lattice(Vec3{0.0}, 2.0, 3);
    add_lattice(overlay, brush, {});
    const Box bounds = overlay.bounds();
    const Box zone = brush.influenced_zone();
    EXPECT_LT(bounds.min.x, zone.min.x) << "the phantom layer is beyond the influenced zone";
    EXPECT_GT(bounds.max.z, zone.max.z);
}

}  // namespace
}  // namespace pectin
