// Movements of cameras, orthographic pictures, and fitting into a part of the picture. All of them
// with random cameras and objects of all sizes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/camera.h"
#include "geometry/up_axis.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

constexpr IVec2 kSize{640, 480};
constexpr double kPixels = 1e-4;  // tolerance

Vec3 random_point(Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach),
            random.uniform(-reach, reach)};
}

// A camera somewhere around an object of the size `scale`.
Camera random_camera(Random& random, double scale) {
    const Camera camera{
        .eye = random_point(random, 5.0 * scale),
        .target = random_point(random, scale),
        .up = random_point(random, 1.0),
        .fov = random.uniform(10.0, 110.0),
        .projection = random.chance(0.5) ? Projection::perspective : Projection::orthographic};
    const bool is_useful = camera.is_valid() && camera.distance() > 0.01 * scale;
    return is_useful ? camera : random_camera(random, scale);
}

// Calls test(random, camera, scale) for cameras of all scales.
template <typename Test>
void for_random_cameras(std::uint64_t seed, const Test& test) {
    const int cases = test::case_count(1000);
    for (int i = 0; i < cases; ++i) {
        Random random(seed + static_cast<std::uint64_t>(i));
        const double scale = random.scale(1e-3, 1e6);
        SCOPED_TRACE("seed " + std::to_string(seed + static_cast<std::uint64_t>(i)));
        test(random, random_camera(random, scale), scale);
        if (testing::Test::HasFailure()) return;
    }
}

// A point that the camera sees, and its pixel.
struct Seen {
    Vec3 point;
    Vec2 pixel;
};
Seen seen_point(Random& random, const Camera& camera) {
    const Vec2 pixel{random.uniform(0.0, kSize.x), random.uniform(0.0, kSize.y)};
    const Ray ray = camera.ray_through(pixel, kSize);
    const double depth = camera.distance() * random.uniform(0.05, 4.0);
    const double from_start = glm::dot(camera.eye - ray.origin, camera.forward());
    const Vec3 point = ray.at((from_start + depth) / glm::dot(ray.direction, camera.forward()));
    return {point, pixel};
}

void expect_pixel(const Camera& camera, const Vec3& point, const Vec2& pixel) {
    const auto seen = camera.project(point, kSize);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, pixel.x, kPixels);
    EXPECT_NEAR(seen->y, pixel.y, kPixels);
}

TEST(Projections, ProjectPointsOfThePixelsRayBackToThePixel) {
    for_random_cameras(1, [](Random& random, const Camera& camera, double) {
        const Seen seen = seen_point(random, camera);
        expect_pixel(camera, seen.point, seen.pixel);
        EXPECT_NEAR(glm::length(camera.ray_through(seen.pixel, kSize).direction), 1.0, 1e-12);
    });
}

TEST(Projections, ProjectAsTheirMatricesDo) {
    for_random_cameras(1000, [](Random& random, const Camera& camera, double) {
        const Seen seen = seen_point(random, camera);
        const double distance = camera.distance();
        const Mat4 to_clip =
            camera.projection_matrix(640.0 / 480.0, {0.01 * distance, 5.0 * distance}) *
            camera.view();
        const glm::dvec4 clip = to_clip * glm::dvec4(seen.point, 1.0);
        EXPECT_NEAR(320.0 * (1.0 + clip.x / clip.w), seen.pixel.x, kPixels);
        EXPECT_NEAR(240.0 * (1.0 - clip.y / clip.w), seen.pixel.y, kPixels);
        EXPECT_LT(std::abs(clip.z / clip.w), 1.0);
    });
}

TEST(Projections, ShowWhatIsAtTheDepthOfTheTargetInTheSameSize) {
    for_random_cameras(2000, [](Random& random, const Camera& camera, double) {
        Camera other = camera;
        other.projection =
            camera.is_orthographic() ? Projection::perspective : Projection::orthographic;
        const Vec3 point = camera.target + 0.3 * camera.distance() *
                                               (random.uniform(-1, 1) * camera.right() +
                                                random.uniform(-1, 1) * camera.true_up());
        expect_pixel(other, point, *camera.project(point, kSize));
        EXPECT_NEAR(other.pixel_length(point, kSize) / camera.pixel_length(point, kSize), 1.0,
                    1e-9);
    });
}

TEST(Orthographic, ShowsAllDepthsInTheSameSizeAlsoBehindTheEye) {
    const Camera camera{.eye = Vec3(0, 0, 2), .projection = Projection::orthographic};
    for (const double z : {-50.0, 0.0, 1.9, 30.0}) {
        const auto a = camera.project({0, 0, z}, kSize), b = camera.project({0.5, 0, z}, kSize);
        ASSERT_TRUE(a && b);
        EXPECT_NEAR(b->x - a->x, 0.5 / camera.pixel_length({0, 0, z}, kSize), 1e-9);
        EXPECT_NEAR(b->x - a->x, 0.25 * 480.0 / (2.0 * std::tan(std::acos(-1.0) / 8.0)), 1e-9);
    }
}

TEST(Orthographic, DrawsAndPicksWhatIsBehindTheEye) {
    const Camera camera{.eye = Vec3(0, 0, 0.1), .projection = Projection::orthographic};
    const Box box{.min = Vec3(-1), .max = Vec3(1)};
    const DepthRange depths = depth_range(camera, box);
    EXPECT_LT(depths.near, camera.depth({0, 0, 1}));
    EXPECT_GT(depths.far, camera.depth({0, 0, -1}));
    const auto interval = intersect(camera.ray_through({320, 240}, kSize), box);
    ASSERT_TRUE(interval);
    const Vec3 first = camera.ray_through({320, 240}, kSize).at(interval->enter);
    EXPECT_NEAR(first.z, 1.0, 1e-9);
}

TEST(Orbit, KeepsThePixelAndTheDistanceOfThePivot) {
    for_random_cameras(3000, [](Random& random, const Camera& camera, double) {
        const Seen pivot = seen_point(random, camera);
        const Camera rotated =
            orbited(camera, random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0), pivot.point);
        expect_pixel(rotated, pivot.point, pivot.pixel);
        EXPECT_NEAR(rotated.depth(pivot.point) / camera.depth(pivot.point), 1.0, 1e-9);
        EXPECT_NEAR(rotated.distance() / camera.distance(), 1.0, 1e-9);
    });
}

TEST(LookingFrom, HasTheDirectionAndKeepsThePixelOfThePivot) {
    for_random_cameras(4000, [](Random& random, const Camera& camera, double) {
        const Seen pivot = seen_point(random, camera);
        const Vec3 direction = random.direction(), up{0.0, 0.0, 1.0};
        const Camera turned = looking_from(camera, direction, up, pivot.point);
        EXPECT_NEAR(glm::distance(turned.forward(), -direction), 0.0, 1e-6);
        EXPECT_EQ(turned.up, up);
        expect_pixel(turned, pivot.point, pivot.pixel);
        EXPECT_NEAR(turned.distance() / camera.distance(), 1.0, 1e-9);
    });
}

TEST(Zoom, KeepsThePixelOfTheAnchorAndScalesWhatIsAtItsDepth) {
    for_random_cameras(5000, [](Random& random, const Camera& camera, double) {
        const Seen anchor = seen_point(random, camera);
        const double factor = random.scale(0.05, 20.0);
        const Camera nearer = zoomed(camera, factor, anchor.point);
        expect_pixel(nearer, anchor.point, anchor.pixel);
        EXPECT_NEAR(
            nearer.pixel_length(anchor.point, kSize) / camera.pixel_length(anchor.point, kSize),
            factor, 1e-9 * factor);
    });
}

TEST(Focus, ChangesNoPictureAndBringsTheTargetToTheDepthOfThePoint) {
    for_random_cameras(6000, [](Random& random, const Camera& camera, double) {
        const Seen point = seen_point(random, camera), other = seen_point(random, camera);
        const Camera focused = focused_on(camera, point.point);
        expect_pixel(focused, other.point, other.pixel);
        EXPECT_NEAR(focused.depth(point.point) / focused.distance(), 1.0, 1e-9);
        // The middle of the picture stays where it is.
        const Vec3 aside = focused.target - camera.target;
        EXPECT_NEAR(glm::length(glm::cross(aside, camera.forward())), 0.0,
                    1e-9 * (glm::length(aside) + camera.distance()));
    });
}

TEST(Fit, ShowsAllPointsInThePartOfThePictureAsLargeAsItAllows) {
    for_random_cameras(7000, [](Random& random, const Camera& camera, double scale) {
        const Vec2 low{random.uniform(0.0, 400.0), random.uniform(0.0, 300.0)};
        const Vec2 high =
            low + Vec2{random.uniform(80.0, 640.0 - low.x), random.uniform(80.0, 480.0 - low.y)};
        const auto to_area = [](const Vec2& pixel) {
            return Vec2{pixel.x - 320.0, 240.0 - pixel.y} / 240.0;
        };
        const PictureArea area{.min = to_area({low.x, high.y}), .max = to_area({high.x, low.y})};
        const Vec3 middle = random_point(random, 10.0 * scale);
        const Vec3 extent{scale * random.scale(0.2, 1.0), scale * random.scale(0.2, 1.0), scale};
        std::vector<Vec3> points;
        for (int i = 0; i < 30; ++i) points.push_back(middle + extent * random_point(random, 1.0));
        const Camera fitted = fit(points, {.area = area,
                                           .direction = random.direction(),
                                           .up = random.direction(),
                                           .fov = camera.fov,
                                           .projection = camera.projection});
        ASSERT_TRUE(fitted.is_valid());
        Vec2 least{1e9}, most{-1e9};
        for (const Vec3& point : points) {
            const auto pixel = fitted.project(point, kSize);
            ASSERT_TRUE(pixel);
            least = glm::min(least, *pixel);
            most = glm::max(most, *pixel);
        }
        EXPECT_TRUE(glm::all(glm::lessThan(low, least)) && glm::all(glm::lessThan(most, high)))
            << least.x << ' ' << least.y << " to " << most.x << ' ' << most.y << " in " << low.x
            << ' ' << low.y << " to " << high.x << ' ' << high.y;
        // It fills the area in one direction but for the margin, and is in its middle there.
        const Vec2 filled = (most - least) / (high - low);
        EXPECT_GT(std::max(filled.x, filled.y), 0.85);
        EXPECT_LT(std::max(filled.x, filled.y), 0.89);
    });
}

TEST(Fit, ShowsPointsInOneLineWithTheView) {
    const std::array<Vec3, 3> points{Vec3{0, 0, -1}, Vec3{0, 0, 0}, Vec3{0, 0, 2}};
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera = fit(points, {.direction = {0, 0, 1}, .projection = projection});
        ASSERT_TRUE(camera.is_valid());
        for (const Vec3& point : points) EXPECT_TRUE(camera.project(point, kSize));
    }
}

TEST(UpAxis, TurnsDirectionsThereAndBack) {
    EXPECT_EQ(up_vector(UpAxis::y), Vec3(0, 1, 0));
    EXPECT_EQ(up_vector(UpAxis::z), Vec3(0, 0, 1));
    EXPECT_EQ(oriented(UpAxis::z, {0, 0, 1}), Vec3(0, -1, 0)) << "the front looks along -y";
    EXPECT_EQ(oriented(UpAxis::z, {1, 0, 0}), Vec3(1, 0, 0));
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        EXPECT_EQ(with_y_up(up, oriented(up, {1, 2, 3})), Vec3(1, 2, 3));
    }
}

}  // namespace
}  // namespace pectin
