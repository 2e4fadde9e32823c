// Navigation with the mouse.
#include "app/navigation.h"

#include <gtest/gtest.h>

#include <array>

namespace pectin {
namespace {

constexpr IVec2 kSize{1200, 800};

TEST(NavigationMode, DependsOnButtonAndModifiers) {
    using enum MouseButton;
    using enum NavigationMode;
    EXPECT_EQ(navigation_mode(left, {}), orbit);
    EXPECT_EQ(navigation_mode(left, {.alt = true}), orbit);
    EXPECT_EQ(navigation_mode(left, {.shift = true}), pan);
    EXPECT_EQ(navigation_mode(middle, {}), orbit);
    EXPECT_EQ(navigation_mode(middle, {.shift = true}), pan);
    EXPECT_EQ(navigation_mode(middle, {.control = true}), zoom);
    EXPECT_EQ(navigation_mode(right, {}), orbit);
    EXPECT_EQ(navigation_mode(right, {.alt = true}), pan);
    EXPECT_EQ(navigation_mode(right, {.shift = true}), pan);
}

TEST(Navigation, OrbitKeepsTargetAndDistance) {
    Navigation navigation;
    const Camera before = navigation.camera();
    navigation.begin(NavigationMode::orbit, MouseButton::left, {100, 100});
    navigation.move_to({160, 70}, kSize);
    EXPECT_EQ(navigation.camera().target, before.target);
    EXPECT_NEAR(navigation.camera().distance(), before.distance(), 1e-12);
    EXPECT_GT(glm::distance(navigation.camera().eye, before.eye), 0.1);
    navigation.move_to({100, 100}, kSize);
    EXPECT_NEAR(glm::distance(navigation.camera().eye, before.eye), 0.0, 1e-12);
}

TEST(Navigation, PanMovesTheTargetWithTheCursor) {
    Navigation navigation;
    const Vec3 target = navigation.camera().target;
    navigation.begin(NavigationMode::pan, MouseButton::middle, {600, 400});
    navigation.move_to({700, 350}, kSize);
    const auto seen = navigation.camera().project(target, kSize);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(glm::distance(*seen, Vec2(700, 350)), 0.0, 1e-9);
}

TEST(Navigation, ScrollKeepsThePointUnderTheCursor) {
    Navigation navigation;
    const Vec2 at{900, 200};
    const Camera& camera = navigation.camera();
    const Ray ray = camera.ray_through(at, kSize);
    const double depth = glm::dot(camera.target - camera.eye, camera.forward());
    const Vec3 point = ray.at(depth / glm::dot(ray.direction, camera.forward()));
    const double distance = camera.distance();
    for (int notch = 0; notch < 5; ++notch) navigation.scroll(1.0, at, kSize);
    EXPECT_LT(navigation.camera().distance(), 0.6 * distance);
    const auto seen = navigation.camera().project(point, kSize);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(glm::distance(*seen, at), 0.0, 1e-6);
}

TEST(Navigation, CameraStaysValidHoweverFarItZooms) {
    Navigation navigation;
    for (const double direction : {1.0, -1.0}) {
        for (int notch = 0; notch < 2000; ++notch) navigation.scroll(direction, {10, 10}, kSize);
        EXPECT_TRUE(navigation.camera().is_valid());
    }
}

TEST(Navigation, FrameShowsAllPointsInTheMiddle) {
    const std::array<Vec3, 4> points{Vec3{10, 0, 0}, Vec3{14, 1, 0}, Vec3{12, -3, 2},
                                     Vec3{11, 0, 5}};
    for (const Vec3& direction : {kFrontView, kRightView, kTopView, kFitDirection}) {
        Navigation navigation;
        navigation.frame(points, 1.0, 0.8, direction);
        EXPECT_TRUE(navigation.camera().is_valid());
        for (const Vec3& point : points) {
            const auto seen = navigation.camera().project(point, {1000, 1000});
            ASSERT_TRUE(seen);
            EXPECT_TRUE(100 <= seen->x && seen->x <= 900 && 100 <= seen->y && seen->y <= 900)
                << seen->x << ' ' << seen->y;
        }
    }
}

TEST(Navigation, ViewsLookAlongTheAxes) {
    Navigation navigation;
    const std::array<Vec3, 2> points{Vec3{-1}, Vec3{1}};
    navigation.frame(points, 1.0, 1.0, kTopView);
    EXPECT_NEAR(navigation.camera().forward().y, -1.0, 1e-6);
    navigation.frame(points, 1.0, 1.0, kRightView);
    EXPECT_NEAR(navigation.camera().forward().x, -1.0, 1e-12);
}

}  // namespace
}  // namespace pectin
