// Axes, planes and typed distances of drags, as numbers and words.
#include "app/tools/drag_constraint.h"

#include <gtest/gtest.h>

#include "app/tools/sculptor.h"

namespace pectin {
namespace {

constexpr Vec3 kCursor{0.3, 0.4, 0.0}, kStart{0.0, 0.0, 0.01};

DragConstraint typed(const std::string& text) {
    DragConstraint constraint;
    for (const char c : text) EXPECT_TRUE(constraint.type(static_cast<unsigned char>(c))) << c;
    return constraint;
}

TEST(DragConstraint, ReadsDecimalsWithPointOrCommaAndChangesTheSignAtEachMinus) {
    EXPECT_EQ(typed("0.25").distance(), 0.25);
    EXPECT_EQ(typed("1,5").distance(), 1.5);
    EXPECT_EQ(typed("-3").distance(), -3.0);
    EXPECT_EQ(typed("3-").distance(), -3.0);
    EXPECT_EQ(typed("-3-").distance(), 3.0);
    EXPECT_EQ(typed(".5").distance(), 0.5);
    EXPECT_EQ(typed("7.").distance(), 7.0);
    EXPECT_EQ(typed("1.2.3").distance(), 1.23) << "a second point is ignored";
    EXPECT_EQ(typed("-").distance(), std::nullopt);
    EXPECT_EQ(typed(".").distance(), std::nullopt);
    EXPECT_LE(*typed("99999999999999999999").distance(), 1e16) << "there is a limit";
}

TEST(DragConstraint, TakesOnlyItsOwnKeysAndCharacters) {
    DragConstraint constraint;
    for (const char c : {'a', '+', ' ', '/'}) {
        EXPECT_FALSE(constraint.type(static_cast<unsigned char>(c)));
    }
    for (const Key key : {Key{'W'}, Key{'A'}, Key::enter, Key::home, Key{'1'}}) {
        EXPECT_FALSE(constraint.press(key, false));
    }
    EXPECT_FALSE(constraint.is_active());
}

TEST(DragConstraint, AnotherAxisReplacesTheFirstAndTheSameOneTakesItBack) {
    DragConstraint constraint;
    constraint.press(Key{'X'}, false);
    EXPECT_EQ(constraint.axis(), 0);
    constraint.press(Key{'Z'}, true);
    EXPECT_EQ(constraint.axis(), 2);
    EXPECT_TRUE(constraint.is_plane());
    constraint.press(Key{'Z'}, false);
    EXPECT_EQ(constraint.axis(), 2);
    EXPECT_FALSE(constraint.is_plane());
    constraint.press(Key{'Z'}, false);
    EXPECT_FALSE(constraint.is_active());
}

TEST(DragConstraint, GoesAlongTheAxisOrTheDirectionInWhichTypingBegan) {
    DragConstraint free = typed("2");
    EXPECT_EQ(free.displacement(kCursor, kStart), 2.0 * Vec3(0.6, 0.8, 0.0));
    EXPECT_EQ(free.displacement(Vec3{9.0}, kStart), 2.0 * Vec3(0.6, 0.8, 0.0)) << "it stays";
    DragConstraint still = typed("-2");
    EXPECT_EQ(still.displacement(Vec3{1e-3}, kStart), Vec3(0, 0, -2)) << "less than the start";
    DragConstraint along = typed("2");
    along.press(Key{'Y'}, false);
    EXPECT_EQ(along.displacement(kCursor, kStart), Vec3(0, 2, 0));
    // Within a plane the direction has no part across it, even if there is no movement yet.
    DragConstraint across = typed("2");
    across.press(Key{'Z'}, true);
    const Vec3 within = across.displacement(Vec3{0.0}, kStart);
    EXPECT_EQ(within.z, 0.0);
    EXPECT_DOUBLE_EQ(glm::length(within), 2.0);
}

TEST(DragConstraint, BackspaceReturnsToTheCursorOnceNothingIsLeft) {
    DragConstraint constraint = typed("-12");
    for (const std::optional<double> left : {std::optional(-1.0), std::optional<double>()}) {
        constraint.press(Key::backspace, false);
        EXPECT_EQ(constraint.distance(), left);
    }
    EXPECT_TRUE(constraint.is_typing()) << "the minus";
    constraint.press(Key::backspace, false);
    EXPECT_FALSE(constraint.is_active());
    EXPECT_EQ(constraint.displacement(kCursor, kStart), kCursor);
}

TEST(DragConstraint, SaysWhatItDoes) {
    DragConstraint constraint;
    constraint.press(Key{'X'}, false);
    EXPECT_EQ(constraint.description({0.25, 0, 0}), "Distance along X: 0.25");
    EXPECT_EQ(constraint.description({-0.125, 0, 0}), "Distance along X: -0.125");
    constraint.press(Key{'Y'}, true);
    EXPECT_EQ(constraint.description({3, 0, 4}), "Distance in the plane across Y: 5");
    EXPECT_EQ(typed("-1.").description({}), "Distance: −1.|");
}

TEST(PlaneAcrossAnAxis, IsMetUnderTheCursorAndFollowedAlsoFromItsEdge) {
    constexpr IVec2 kSize{800, 600};
    const Camera camera{.eye = {2, 3, 5}};
    const Vec3 from{0.2, 0.1, 0.3};
    const Ray first = camera.ray_through(*camera.project(from, kSize), kSize);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 goal = from + Vec3{0.3, -0.2, 0.25};
        goal[axis] = from[axis];
        const Ray ray = camera.ray_through(*camera.project(goal, kSize), kSize);
        const auto met = on_plane_across(camera, from, axis, first, ray);
        ASSERT_TRUE(met);
        EXPECT_LT(glm::distance(*met, goal), 1e-9) << axis;
    }
    const Camera edge{.eye = {0, 0, 5}};
    const Ray before = edge.ray_through({400, 300}, kSize),
              ray = edge.ray_through({450, 250}, kSize);
    const auto followed = on_plane_across(edge, Vec3{0.0}, 1, before, ray);
    ASSERT_TRUE(followed);
    EXPECT_EQ(followed->y, 0.0);
    EXPECT_GT(followed->x, 0.1);
    // Above the horizon there is no such point.
    EXPECT_FALSE(on_plane_across(camera, from, 1, first, camera.ray_through({400, -900}, kSize)));
}

}  // namespace
}  // namespace pectin
