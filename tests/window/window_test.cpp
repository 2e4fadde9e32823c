// Drags, keys and panels in the real window, and the record of what is done there.
#include <gtest/gtest.h>

#include <string>

#include "window/window_fixture.h"

namespace pectin {
namespace {

TEST_F(WindowTest, ReplayOfTheRecordGivesTheBytesThatTheWindowSaved) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\"", 1));
    desktop().key("bracketleft");
    ASSERT_TRUE(records("\"brush\""));
    desktop().drag(560, 420, 520, 470);
    ASSERT_TRUE(records("\"drag\"", 2));
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, PinsSymmetryAndTheWheelAreRecordedAndReplayToTheBytesThatTheWindowSaved) {
    open_window();
    ASSERT_TRUE(records("\"symmetry\"")) << "the first sphere is symmetric";
    desktop().move(700, 470);
    desktop().key("p");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(680, 360);
    desktop().move(720, 330);
    desktop().press(4);
    desktop().release(4);
    desktop().hold("shift");
    desktop().press(4);
    desktop().release(4);
    desktop().release_key("shift");
    desktop().release();
    ASSERT_TRUE(records("\"drag\""));
    EXPECT_EQ(recorded("\"pins\": [["), 1u) << record();
    EXPECT_EQ(recorded("\"degrees\": 5"), 1u) << record();
    EXPECT_EQ(recorded("\"scale\": 1.05"), 1u) << record();
    EXPECT_EQ(recorded("\"connected\": true, \"fold_free\": true"), 1u) << record();
    desktop().key("x");
    ASSERT_TRUE(records("\"symmetry\"", 2));
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, EscapeDuringADragRestoresTheSphere) {
    open_window();
    save_as("before.obj");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(700, 330);
    desktop().move(760, 290);
    desktop().key("Escape");
    desktop().release();
    save_as("after.obj");
    quit();
    EXPECT_EQ(recorded("\"drag\""), 0u);
    EXPECT_TRUE(folder().read("after.obj") == folder().read("before.obj"));
}

TEST_F(WindowTest, UndoAndRedoKeysRestoreTheExactBytes) {
    open_window();
    save_as("sphere.obj");
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    save_as("dragged.obj");
    desktop().key("ctrl+z");
    ASSERT_TRUE(records("\"undo\""));
    save_as("undone.obj");
    desktop().key("ctrl+shift+z");
    ASSERT_TRUE(records("\"redo\""));
    save_as("redone.obj");
    quit();
    EXPECT_TRUE(folder().read("dragged.obj") != folder().read("sphere.obj"));
    EXPECT_TRUE(folder().read("undone.obj") == folder().read("sphere.obj"));
    EXPECT_TRUE(folder().read("redone.obj") == folder().read("dragged.obj"));
    EXPECT_TRUE(folder().read("redone.obj") == replayed());
}

TEST_F(WindowTest, ANumberIsTypedAfterADoubleClickAndAButtonReadaptsTheObject) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    double_click(place_of("Detail"));
    desktop().type("9");
    desktop().key("Return");
    ASSERT_TRUE(records("\"theta_max\": 9")) << record();
    EXPECT_EQ(recorded("\"readapt\""), 0u);
    click(place_of(info_of(Action::readapt).name));
    ASSERT_TRUE(records("\"readapt\"")) << record();
    desktop().move(kMiddleX, kMiddleY);
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, ANumberFollowsADragSideways) {
    open_window();
    const Vec2 at = place_of("Radius");
    const auto x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    desktop().drag(x, y, x - 30, y);
    ASSERT_TRUE(records("\"brush\"")) << record();
    EXPECT_EQ(recorded("\"radius\""), 1u) << "set once, when the button was released";
    quit();
}

TEST_F(WindowTest, MenusAreUsedWithoutTheMouse) {
    open_window();
    desktop().key("F10");
    for (int i = 0; i < 5; ++i) desktop().key("Down");  // to the last entry, Quit
    desktop().key("Return");
    EXPECT_EQ(program().wait(), 0);
}

TEST_F(WindowTest, PreferencesAreKeptForTheNextWindowAndOnlyIfTheyHaveChanged) {
    const std::string file = "config/pectin/preferences.json";
    const auto keeps = [&](const char* what) {
        return eventually([&] {
            return folder().holds(file) && folder().read(file).find(what) != std::string::npos;
        });
    };
    open_window();
    desktop().key("w");
    quit();
    EXPECT_FALSE(folder().holds(file));
    open_window();
    desktop().key("ctrl+equal");
    EXPECT_TRUE(keeps("\"scale\": 1.1"));
    desktop().key("Tab");
    EXPECT_TRUE(keeps("\"hides_panels\": true"));
    quit();
    open_window();
    click(place_of("Y"));  // where the panel was
    desktop().key("bracketleft");
    ASSERT_TRUE(records("\"brush\""));
    EXPECT_EQ(recorded("\"plane\": \"y\""), 0u) << record();
    quit();
}

TEST_F(WindowTest, NothingThatIsTypedDuringASlowFrameIsLost) {
    open_window();
    program().pause();
    desktop().key("ctrl+shift+s");
    desktop().type(path("first.obj"));
    desktop().key("Return");
    desktop().key("x");
    desktop().drag(kMiddleX, kMiddleY, 700, 350);
    desktop().key("ctrl+shift+s");
    desktop().type(path("second.obj"));
    desktop().key("Return");
    program().resume();
    ASSERT_TRUE(records("second.obj")) << record();
    EXPECT_EQ(recorded("first.obj"), 1u);
    EXPECT_EQ(recorded("\"drag\""), 1u);
    EXPECT_EQ(recorded("\"symmetry\""), 2u);
    quit();
    EXPECT_TRUE(folder().read("second.obj") != folder().read("first.obj"));
    EXPECT_TRUE(folder().read("second.obj") == replayed());
}

}  // namespace
}  // namespace pectin
