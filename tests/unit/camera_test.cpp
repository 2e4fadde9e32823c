#include "geometry/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pectin {
namespace {

constexpr IVec2 kSize{640, 480};
constexpr double kAspect = 640.0 / 480.0;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LE(glm::distance(a, b), tolerance)
        << "(" << a.x << ", " << a.y << ", " << a.z << ") against (" << b.x << ", " << b.y << ", "
        << b.z << ")";
}

Camera random_camera(std::mt19937& bits) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3{unit(bits), unit(bits), unit(bits)}; };
    Camera camera{.eye = 5.0 * vector(), .target = vector(), .up = vector(), .fov = 0.0};
    camera.fov = 60.0 + 50.0 * unit(bits);
    return camera.is_valid() ? camera : random_camera(bits);
}

TEST(Camera, SeesItsTargetInTheMiddleOfThePicture) {
    std::mt19937 bits(1);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random_camera(bits);
        const auto pixel = camera.project(camera.target, kSize);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, 320.0, 1e-9);
        EXPECT_NEAR(pixel->y, 240.0, 1e-9);
    }
}

TEST(Camera, ProjectsPointsOfThePixelsRayBackToThePixel) {
    std::mt19937 bits(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = random_camera(bits);
        const Vec2 pixel{640.0 * unit(bits), 480.0 * unit(bits)};
        const Ray ray = camera.ray_through(pixel, kSize);
        EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
        const auto back = camera.project(ray.at(0.1 + 10.0 * unit(bits)), kSize);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, pixel.x, 1e-8);
        EXPECT_NEAR(back->y, pixel.y, 1e-8);
    }
}

TEST(Camera, ProjectsAsItsMatricesDo) {
    std::mt19937 bits(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = random_camera(bits);
        const Vec3 point =
            camera.ray_through({640.0 * unit(bits), 480.0 * unit(bits)}, kSize).at(1.0);
        const Mat4 to_clip = camera.projection_matrix(kAspect, {0.1, 100.0}) * camera.view();
        const glm::dvec4 clip = to_clip * glm::dvec4(point, 1.0);
        const auto pixel = camera.project(point, kSize);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, 320.0 * (1.0 + clip.x / clip.w), 1e-8);
        EXPECT_NEAR(pixel->y, 240.0 * (1.0 - clip.y / clip.w), 1e-8);
        EXPECT_LT(std::abs(clip.z / clip.w), 1.0);
    }
}

TEST(Camera, HasNoPixelForPointsBehindTheEye) {
    const Camera camera{.eye = Vec3(0, 0, 3)};
    EXPECT_FALSE(camera.project({0, 0, 3.5}, kSize));
    EXPECT_FALSE(camera.project(camera.eye, kSize));
}

TEST(Camera, LooksAlongMinusZWithYUpwards) {
    const Camera camera{.eye = Vec3(0, 0, 3)};
    const Vec2 above_right = *camera.project({0.5, 0.25, 0}, kSize);
    EXPECT_GT(above_right.x, 320.0);
    EXPECT_LT(above_right.y, 240.0);
    expect_near(Vec3(camera.view() * glm::dvec4(0, 0, 0, 1)), {0, 0, -3}, 1e-15);
}

TEST(Camera, SpansItsAngleOfViewFromTopToBottom) {
    const Camera camera{.eye = Vec3(0, 0, 2), .fov = 90.0};
    EXPECT_NEAR(camera.project({0, 2, 0}, kSize)->y, 0.0, 1e-9);
    EXPECT_NEAR(camera.project({0, -2, 0}, kSize)->y, 480.0, 1e-9);
    EXPECT_NEAR(camera.pixel_length(Vec3(0), kSize), 4.0 / 480.0, 1e-15);
}

TEST(Camera, IsInvalidWhereItHasNoDirectionOrNoUp) {
    EXPECT_TRUE(Camera{}.is_valid());
    EXPECT_FALSE((Camera{.eye = Vec3(0)}.is_valid()));
    EXPECT_FALSE((Camera{.up = Vec3(0)}.is_valid()));
    EXPECT_FALSE((Camera{.up = Vec3(0, 0, -2)}.is_valid()));
    EXPECT_FALSE((Camera{.fov = 180.0}.is_valid()));
    EXPECT_FALSE((Camera{.eye = Vec3(std::nan(""), 0, 0)}.is_valid()));
}

TEST(DepthRange, HoldsTheBoxBetweenNearAndFar) {
    const Box box{.min = Vec3(-1), .max = Vec3(1)};
    const DepthRange outside = depth_range({.eye = Vec3(0, 0, 5)}, box);
    EXPECT_LE(outside.near, 4.0);
    EXPECT_GT(outside.near, 3.9);
    EXPECT_GE(outside.far, 6.0);
    EXPECT_LT(outside.far, 6.1);
    const DepthRange inside = depth_range({.eye = Vec3(0, 0, 0.5)}, box);
    EXPECT_GT(inside.near, 0.0);
    EXPECT_LT(inside.near, 1e-3);
    const DepthRange behind = depth_range({.eye = Vec3(0, 0, 5), .target = Vec3(0, 0, 9)}, box);
    EXPECT_LT(0.0, behind.near);
    EXPECT_LT(behind.near, behind.far);
}

// The outermost point in the picture, as a fraction of the way from its middle to its border.
Vec2 extent_in_picture(const Camera& camera, std::span<const Vec3> points, const IVec2& size) {
    Vec2 most{0.0};
    for (const Vec3& p : points) {
        const auto pixel = camera.project(p, size);
        if (!pixel) return Vec2{2.0};
        most = glm::max(most, glm::abs(*pixel / (0.5 * Vec2(size)) - 1.0));
    }
    return most;
}

TEST(Fit, ShowsAllPointsAsLargeAsThePictureAllows) {
    std::mt19937 bits(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const IVec2& size : {kSize, IVec2{200, 900}}) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 scale{std::exp(3.0 * unit(bits)), 1.0, std::exp(3.0 * unit(bits))};
            std::vector<Vec3> points;
            for (int k = 0; k < 20; ++k)
                points.push_back(100.0 + scale * Vec3{unit(bits), unit(bits), unit(bits)});
            const Camera camera = fit(points, static_cast<double>(size.x) / size.y,
                                      {unit(bits), unit(bits), unit(bits)});
            ASSERT_TRUE(camera.is_valid());
            const Vec2 extent = extent_in_picture(camera, points, size);
            EXPECT_LT(std::max(extent.x, extent.y), 1.0);
            EXPECT_GT(std::max(extent.x, extent.y), 0.8);
        }
    }
}

TEST(Fit, LooksStraightUpOrDownToo) {
    const Box box{.min = Vec3(-1), .max = Vec3(1)};
    for (const Vec3& direction : {Vec3(0, 1, 0), Vec3(0, -3, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0)})
        EXPECT_TRUE(fit(box, kAspect, direction).is_valid());
}

TEST(Fit, ShowsABoxOfSizeOneForPointsWithoutExtent) {
    EXPECT_TRUE(fit(Box{}, kAspect).is_valid());
    const Camera camera = fit(Box{.min = Vec3(7), .max = Vec3(7)}, kAspect);
    EXPECT_TRUE(camera.is_valid());
    expect_near(camera.target, Vec3(7), 0.5);
}

TEST(Orbit, StopsShortOfLookingAlongUp) {
    Camera camera{.eye = Vec3(0, 0, 3)};
    for (int i = 0; i < 40; ++i) camera = orbited(camera, 0.1, -0.2, Vec3(0));
    EXPECT_TRUE(camera.is_valid());
    EXPECT_GT(camera.eye.y, 2.9);
    for (int i = 0; i < 80; ++i) camera = orbited(camera, 0.1, 0.2, Vec3(0));
    EXPECT_TRUE(camera.is_valid());
    EXPECT_LT(camera.eye.y, -2.9);
}

TEST(Orbit, ReturnsAfterAFullRotation) {
    const Camera camera{.eye = Vec3(1, 2, 4)};
    const Camera rotated = orbited(camera, 2.0 * std::numbers::pi, 0.0, camera.target);
    expect_near(rotated.eye, camera.eye, 1e-12);
}

TEST(Pan, MovesPointsAtTheDepthOfTheTargetByThePixels) {
    const Camera camera{.eye = Vec3(1, 2, 4)};
    const Camera moved = panned(camera, {30.0, -12.0}, kSize);
    const Vec2 pixel = *moved.project(camera.target, kSize);
    EXPECT_NEAR(pixel.x, 320.0 + 30.0, 1e-9);
    EXPECT_NEAR(pixel.y, 240.0 - 12.0, 1e-9);
}

}  // namespace
}  // namespace pectin
