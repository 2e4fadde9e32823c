// Keys of the brush in the real window.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "geometry/vec.h"
#include "window/window_fixture.h"

namespace pectin {
namespace {

using BrushWindowTest = WindowTest;

// The numbers of the last field of this name in the record, such as "\"to\": [".
Vec3 last_point(const std::string& record, const std::string& field) {
    const std::string text = record.substr(record.rfind(field));
    double x = 0, y = 0, z = 0;
    EXPECT_EQ(std::sscanf(text.c_str() + field.size(), "%lf, %lf, %lf", &x, &y, &z), 3) << text;
    return {x, y, z};
}

TEST_F(BrushWindowTest, ALetterAndATypedNumberSetTheWayOfADragAndEnterAccepts) {
    open_window();
    desktop().key("x");  // no symmetry, so that the point may move along x
    ASSERT_TRUE(records("\"symmetry\"", 2));
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(700, 370);
    desktop().key("x");
    desktop().type("0.25");
    desktop().key("Return");
    ASSERT_TRUE(records("\"drag\"")) << "before the button is released";
    desktop().release();
    const Vec3 way = last_point(record(), "\"to\": [") - last_point(record(), "\"from\": [");
    EXPECT_LT(glm::distance(way, Vec3(0.25, 0, 0)), 1e-9) << record();
    wait_until_handled();
    EXPECT_EQ(recorded("\"symmetry\""), 2u) << "X is no action during the drag";
    EXPECT_EQ(recorded("\"drag\""), 1u);
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(BrushWindowTest, ShiftRRepeatsTheLastDragUnderTheCursor) {
    open_window();
    desktop().key("x");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(642, 398);
    desktop().type("0.2");
    desktop().key("Return");
    desktop().release();
    ASSERT_TRUE(records("\"drag\""));
    const Vec3 first = last_point(record(), "\"from\": [");
    desktop().move(540, 460);
    desktop().key("shift+r");
    ASSERT_TRUE(records("\"drag\"", 2)) << record();
    const Vec3 from = last_point(record(), "\"from\": [");
    EXPECT_GT(glm::distance(from, first), 0.2);
    EXPECT_NEAR(glm::distance(last_point(record(), "\"to\": ["), from), 0.2, 1e-9);
    desktop().key("ctrl+z");
    desktop().key("ctrl+z");
    ASSERT_TRUE(records("\"undo\"", 2)) << "each is a step of its own";
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(BrushWindowTest, HoldingFSetsTheRadiusAndReleasingItKeepsIt) {
    open_window();
    desktop().move(kMiddleX, kMiddleY);
    desktop().hold("f");
    desktop().move(kMiddleX + 80, kMiddleY);
    desktop().move(kMiddleX + 160, kMiddleY);
    desktop().release_key("f");
    ASSERT_TRUE(records("\"radius\"")) << record();
    double radius = 0;
    const std::string text = record();
    ASSERT_EQ(std::sscanf(text.c_str() + text.find("\"radius\": "), "\"radius\": %lf", &radius), 1);
    // Twice a quarter of the diagonal of a box of side 2.
    EXPECT_NEAR(radius, 0.5 * 2.0 * std::sqrt(3.0), 0.01);
    quit();
}

}  // namespace
}  // namespace pectin
