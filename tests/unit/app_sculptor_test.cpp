// Dragging of a point with the mouse.
#include "app/tools/sculptor.h"

#include <gtest/gtest.h>

namespace pectin {
namespace {

constexpr IVec2 kSize{800, 600};

Session sphere() {
    Session session;
    EXPECT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 3}));
    return session;
}

TEST(ViewPlane, ThePointStaysUnderTheCursorAtItsDepth) {
    const Camera camera{.eye = {1, 2, 5}, .target = {0.2, 0.1, 0}};
    const Vec3 from{0.3, 0.4, 0.5};
    const Vec2 at{523, 111};
    const auto to = on_view_plane(camera, from, camera.ray_through(at, kSize));
    ASSERT_TRUE(to);
    EXPECT_NEAR(glm::distance(*camera.project(*to, kSize), at), 0.0, 1e-9);
    EXPECT_NEAR(glm::dot(*to - from, camera.forward()), 0.0, 1e-12);
}

TEST(AlongNormal, ThePointOfTheNormalNearestToTheRayIsFound) {
    const Camera camera{.eye = {0, 0, 5}};
    const Vec3 from{0.2, 0.1, 0.9}, normal = glm::normalize(Vec3{1, 0.5, 0.1});
    const Ray first = camera.ray_through(*camera.project(from, kSize), kSize);
    EXPECT_NEAR(glm::distance(on_normal(camera, from, normal, first, first), from), 0.0, 1e-12);
    // If the cursor is on the projected normal, the point moves exactly under it.
    const Vec3 goal = from + 0.37 * normal;
    const Ray ray = camera.ray_through(*camera.project(goal, kSize), kSize);
    EXPECT_NEAR(glm::distance(on_normal(camera, from, normal, first, ray), goal), 0.0, 1e-9);
}

TEST(AlongNormal, IfTheNormalPointsToTheEyeThePointFollowsTheHeightOfTheCursor) {
    const Camera camera{.eye = {0, 0, 5}};
    const Vec3 from{0, 0, 1}, normal{0, 0, 1};
    const Ray first = camera.ray_through({400, 300}, kSize);
    const Vec3 up = on_normal(camera, from, normal, first, camera.ray_through({400, 250}, kSize));
    const Vec3 down = on_normal(camera, from, normal, first, camera.ray_through({400, 350}, kSize));
    EXPECT_GT(up.z, 1.1);
    EXPECT_NEAR(up.z - 1.0, 1.0 - down.z, 1e-12);
    EXPECT_NEAR(up.z - 1.0, 50 * camera.pixel_length(from, kSize), 1e-9);
}

TEST(Sculptor, ReleaseGivesTheSameMeshAsTheDragCommand) {
    const Camera camera{.eye = {0, 0, 5}};
    Session session = sphere(), other = sphere();
    const Ray ray = camera.ray_through({430, 280}, kSize);
    const auto pick = session.pick(ray);
    ASSERT_TRUE(pick);
    Sculptor sculptor;
    ASSERT_TRUE(sculptor.grab(session, *pick, ray));
    for (int i = 1; i <= 5; ++i) {
        const Ray next = camera.ray_through({430 + 12 * i, 280 - 15 * i}, kSize);
        ASSERT_TRUE(sculptor.drag(session, camera, next, DragPath::view_plane));
    }
    EXPECT_EQ(sculptor.from(), pick->point);
    EXPECT_NEAR(glm::distance(*camera.project(sculptor.to(), kSize), Vec2(490, 205)), 0.0, 1e-6);
    const auto done = session.end_drag();
    sculptor.end();
    ASSERT_TRUE(done);
    EXPECT_FALSE(sculptor.is_dragging());
    ASSERT_TRUE(other.execute(*done));
    EXPECT_EQ(session.mesh(), other.mesh());
}

TEST(Sculptor, CancelRestoresTheObject) {
    const Camera camera{.eye = {0, 0, 5}};
    Session session = sphere(), untouched = sphere();
    const Ray ray = camera.ray_through({400, 300}, kSize);
    Sculptor sculptor;
    ASSERT_TRUE(sculptor.grab(session, *session.pick(ray), ray));
    ASSERT_TRUE(
        sculptor.drag(session, camera, camera.ray_through({500, 200}, kSize), DragPath::normal));
    EXPECT_FALSE(session.mesh() == untouched.mesh());
    session.cancel_drag();
    sculptor.end();
    EXPECT_EQ(session.mesh(), untouched.mesh());
}

TEST(Sculptor, AClickDoesNotCountAsADrag) {
    const Camera camera{.eye = {0, 0, 5}};
    Session session = sphere();
    const Ray ray = camera.ray_through({400, 300}, kSize);
    Sculptor sculptor;
    ASSERT_TRUE(sculptor.grab(session, *session.pick(ray), ray));
    EXPECT_FALSE(session.end_drag());
    EXPECT_EQ(session.undo_count(), 0u);
}

}  // namespace
}  // namespace pectin
