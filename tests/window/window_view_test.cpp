// The view in the real window: keys of the keypad, the wheel, held keys. Where a point of the
// surface is seen is found out by dragging it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "geometry/vec.h"
#include "window/window_fixture.h"

namespace pectin {
namespace {

class WindowViewTest : public WindowTest {
  protected:
    // The last point of this name in the record, such as "from" or "to".
    Vec3 last(const std::string& name) const {
        const std::string text = record(), key = "\"" + name + "\": [";
        const std::size_t at = text.rfind(key);
        Vec3 point{std::nan("")};
        if (at == text.npos || std::sscanf(text.c_str() + at + key.size(), "%lf, %lf, %lf",
                                           &point.x, &point.y, &point.z) != 3) {
            ADD_FAILURE() << "no point \"" << name << "\" in " << text;
        }
        return point;
    }
    // The point of the surface that is seen there. A drag of it is done and undone.
    Vec3 surface_at(int x, int y) {
        const std::size_t drags = recorded("\"drag\""), undos = recorded("\"undo\"");
        desktop().drag(x, y, x + 12, y + 9);
        EXPECT_TRUE(records("\"drag\"", drags + 1)) << "no surface at " << x << ' ' << y;
        desktop().key("ctrl+z");
        EXPECT_TRUE(records("\"undo\"", undos + 1));
        desktop().move(kMiddleX, kMiddleY);
        return last("from");
    }
    Vec3 surface_in_the_middle() { return surface_at(kMiddleX, kMiddleY); }
    void scroll(int button, int times) {
        for (int i = 0; i < times; ++i) {
            desktop().press(button);
            desktop().release(button);
        }
    }
};

TEST_F(WindowViewTest, KeysOfTheKeypadShowTheObjectFromEachSide) {
    open_window();
    struct Case {
        const char* key;
        Vec3 side;
    };
    for (const Case& c :
         {Case{"KP_1", {0, 0, 1}}, Case{"ctrl+KP_1", {0, 0, -1}}, Case{"KP_3", {1, 0, 0}},
          Case{"ctrl+KP_3", {-1, 0, 0}}, Case{"KP_7", {0, 1, 0}}, Case{"ctrl+KP_7", {0, -1, 0}}}) {
        desktop().key(c.key);
        EXPECT_GT(glm::dot(surface_in_the_middle(), c.side), 0.9) << c.key;
    }
    quit();
}

TEST_F(WindowViewTest, KeysOfTheKeypadTurnTheViewInSteps) {
    open_window();
    desktop().key("KP_1");
    const auto turned = [this](const char* key, int times) {
        for (int i = 0; i < times; ++i) desktop().key(key);
        desktop().key("Home");  // the view has turned about the point that was dragged last
        return surface_in_the_middle();
    };
    EXPECT_GT(turned("KP_6", 6).x, 0.9) << "a right angle to the right";
    EXPECT_LT(turned("KP_4", 12).x, -0.9) << "and two back";
    EXPECT_GT(turned("KP_8", 6).y, 0.9);
    EXPECT_LT(turned("KP_2", 12).y, -0.9);
    quit();
}

TEST_F(WindowViewTest, WithoutPerspectiveEqualDistancesOnTheScreenAreEqualInTheObject) {
    open_window();
    desktop().key("KP_1");
    const auto difference = [this] {
        const double a = surface_at(600, kMiddleY).x, b = surface_at(670, kMiddleY).x,
                     c = surface_at(740, kMiddleY).x;
        return std::abs((c - b) - (b - a));
    };
    EXPECT_GT(difference(), 0.003);
    desktop().key("KP_5");
    EXPECT_LT(difference(), 1e-6);
    desktop().key("KP_5");
    EXPECT_GT(difference(), 0.003);
    quit();
}

TEST_F(WindowViewTest, TheWheelZoomsTowardsThePointUnderTheCursorAndNotThroughIt) {
    open_window();
    const int x = 560, y = 350;
    const Vec3 before = surface_at(x, y), beside = surface_at(x + 40, y);
    desktop().move(x, y);
    scroll(4, 12);
    EXPECT_NEAR(glm::distance(surface_at(x, y), before), 0.0, 1e-6);
    EXPECT_LT(glm::distance(surface_at(x + 40, y), before), 0.5 * glm::distance(beside, before));
    desktop().move(x, y);
    scroll(4, 50);
    EXPECT_NEAR(glm::distance(surface_at(x, y), before), 0.0, 1e-6) << "the same side";
    desktop().key("Home");
    EXPECT_GT(glm::distance(surface_at(x + 40, y), surface_at(x, y)), 0.05) << "framed again";
    quit();
}

TEST_F(WindowViewTest, TheWheelWithShiftOrSidewaysPans) {
    open_window();
    const int x = 560, y = 350;
    desktop().move(x, y);
    desktop().key("KP_1");
    const Vec3 before = surface_at(x, y);
    desktop().move(x, y);
    desktop().hold("shift");
    scroll(4, 2);  // up, so the object moves down
    desktop().release_key("shift");
    const Vec3 lower = surface_at(x, y);
    EXPECT_GT(lower.y, before.y + 0.1);
    EXPECT_NEAR(lower.x, before.x, 0.02);
    desktop().move(x, y);
    scroll(6, 2);  // to the left, so the object moves to the right
    EXPECT_LT(surface_at(x, y).x, lower.x - 0.1);
    quit();
}

TEST_F(WindowViewTest, KeypadPlusAndMinusZoom) {
    open_window();
    const auto width = [this] {
        return glm::distance(surface_at(600, kMiddleY), surface_at(680, kMiddleY));
    };
    const double before = width();
    for (int i = 0; i < 3; ++i) desktop().key("KP_Add");
    const double nearer = width();
    EXPECT_LT(nearer, 0.7 * before);
    for (int i = 0; i < 3; ++i) desktop().key("KP_Subtract");
    EXPECT_GT(width(), 1.3 * nearer);
    quit();
}

TEST_F(WindowViewTest, SpaceAndTheLeftButtonRotateTheViewOverTheObject) {
    open_window();
    const Vec3 beside = surface_at(kMiddleX + 60, kMiddleY), before = surface_in_the_middle();
    const std::size_t drags = recorded("\"drag\"");
    desktop().hold("space");
    desktop().drag(kMiddleX, kMiddleY, kMiddleX + 90, kMiddleY);
    desktop().release_key("space");
    wait_until_handled();
    EXPECT_EQ(recorded("\"drag\""), drags) << "nothing is dragged";
    EXPECT_NEAR(glm::distance(surface_in_the_middle(), before), 0.0, 1e-6)
        << "the view turns about the point under the cursor";
    EXPECT_GT(glm::distance(surface_at(kMiddleX + 60, kMiddleY), beside), 0.02);
    quit();
}

class WindowNormalTest : public WindowViewTest {
  protected:
    // Seen from the front, the normal points to the right and towards the eye.
    void expect_drag_along_normal(const std::string& key) {
        open_window();
        desktop().key("KP_1");
        desktop().move(kMiddleX, kMiddleY);
        desktop().press();
        desktop().hold(key);
        desktop().move(kMiddleX + 30, kMiddleY);
        desktop().move(kMiddleX + 60, kMiddleY);
        desktop().release();
        desktop().release_key(key);
        ASSERT_TRUE(records("\"drag\""));
        const Vec3 from = last("from"), moved = last("to") - from;
        EXPECT_GT(moved.z, 0.05);
        EXPECT_NEAR(glm::dot(moved, from) / (glm::length(moved) * glm::length(from)), 1.0, 1e-3);
    }
};

TEST_F(WindowNormalTest, NDragsAlongTheNormal) { expect_drag_along_normal("n"); }
TEST_F(WindowNormalTest, AltDragsAlongTheNormal) { expect_drag_along_normal("alt"); }

TEST_F(WindowViewTest, AModelWithZUpIsShownUpright) {
    folder().write("z.obj",
                   "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    open_window({path("z.obj")});
    desktop().key("KP_1");
    const Vec3 low = surface_at(kMiddleX - 40, 600), high = surface_at(kMiddleX - 40, 300);
    EXPECT_GT(high.z, low.z + 1.0);
    EXPECT_LT(high.y, 0.1) << "seen from -y";
    quit();
}

}  // namespace
}  // namespace pectin
