// Performs actions of the table in the real window, by their shortcuts or else by their names in
// the window that finds actions, and reads what they did in the record of the session.
#pragma once

#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "app/actions.h"
#include "geometry/vec.h"
#include "window/window_fixture.h"

namespace pectin {

// The shortcut as xdotool calls it, such as "ctrl+shift+z".
inline std::string xdotool_name(const Shortcut& shortcut) {
    static const std::map<std::string, std::string> kNames{
        {"[", "bracketleft"}, {"]", "bracketright"},  {".", "period"},
        {",", "comma"},       {"+", "plus"},          {"-", "minus"},
        {"=", "equal"},       {"Keypad +", "KP_Add"}, {"Keypad -", "KP_Subtract"}};
    static const std::string kKeypad = "Keypad ";
    Shortcut plain = shortcut;
    plain.modifiers = {};
    std::string key = label_of(plain);
    if (const auto named = kNames.find(key); named != kNames.end()) key = named->second;
    if (key.starts_with(kKeypad)) key = "KP_" + key.substr(kKeypad.size());
    if (key.size() == 1) key[0] = static_cast<char>(std::tolower(key[0]));
    return std::string(shortcut.modifiers.control ? "ctrl+" : "") +
           (shortcut.modifiers.shift ? "shift+" : "") + key;
}

// A name without the dots at its end.
inline std::string typed_name(const ActionInfo& info) {
    std::string name;
    for (const char c : std::string(info.name)) {
        if (static_cast<unsigned char>(c) < 0x80) name += c;
    }
    return name;
}

struct Viewpoint {
    Vec3 eye, target;
    double distance() const { return glm::distance(eye, target); }
    Vec3 direction() const { return glm::normalize(eye - target); }
};

class WindowActions : public WindowTest, public testing::WithParamInterface<Action> {
  public:
    // The checks are functions beside the class.
    using WindowTest::desktop;
    using WindowTest::folder;
    using WindowTest::last;
    using WindowTest::path;
    using WindowTest::program;
    using WindowTest::record;
    using WindowTest::recorded;
    using WindowTest::records;
    using WindowTest::save_as;
    using WindowTest::wait_until_handled;

    void perform(Action action) {
        const ActionInfo& info = info_of(action);
        if (info.shortcuts.front().exists()) {
            desktop().key(xdotool_name(info.shortcuts.front()));
        } else {
            perform_by_name(action);
        }
    }
    void perform_by_name(Action action) {
        desktop().key(xdotool_name(info_of(Action::show_actions).shortcuts.front()));
        desktop().type(typed_name(info_of(action)));
        desktop().key("Return");
    }
    void drag(int x = kMiddleX, int y = kMiddleY) {
        const std::size_t before = recorded("\"drag\"");
        desktop().drag(x, y, x + 60, y - 70);
        ASSERT_TRUE(records("\"drag\"", before + 1)) << record();
    }
    // The record's line about a picture that is saved now. It says what is shown, and from where.
    std::string picture() {
        const std::string name = "picture" + std::to_string(pictures_++) + ".png";
        perform_by_name(Action::save_picture);
        desktop().type(path(name));
        desktop().key("Return");
        EXPECT_TRUE(records(name)) << record();
        return last("screenshot");
    }
    Viewpoint view() {
        const std::string line = picture();
        Viewpoint view{};
        const std::size_t eye = line.find("\"eye\""), target = line.find("\"target\"");
        EXPECT_NE(target, line.npos) << line;
        if (target == line.npos) return view;
        EXPECT_EQ(std::sscanf(line.c_str() + eye, "\"eye\": [%lf, %lf, %lf]", &view.eye.x,
                              &view.eye.y, &view.eye.z),
                  3);
        EXPECT_EQ(std::sscanf(line.c_str() + target, "\"target\": [%lf, %lf, %lf]", &view.target.x,
                              &view.target.y, &view.target.z),
                  3);
        return view;
    }
    double radius() const {
        const std::string line = last("brush");
        double value = 0.0;
        const std::size_t at = line.find("\"radius\"");
        if (at != line.npos) std::sscanf(line.c_str() + at, "\"radius\": %lf", &value);
        return value;
    }
    std::string obj(const std::string& name) {
        save_as(name);
        return folder().read(name);
    }

    // --- Checks of several actions.

    void expect_shape(Action action, const std::string& kind) {
        const std::size_t before = recorded("\"shape\"");
        perform(action);
        ASSERT_TRUE(records("\"shape\"", before + 1)) << record();
        EXPECT_NE(last("shape").find("\"" + kind + "\""), std::string::npos) << record();
    }
    void expect_shown(Action action, const std::string& what) {
        EXPECT_EQ(picture().find(what), std::string::npos) << record();
        perform(action);
        EXPECT_NE(picture().find(what), std::string::npos) << record();
        perform(action);
        EXPECT_EQ(picture().find(what), std::string::npos) << record();
    }
    void expect_view(Action action, const Vec3& direction) {
        ASSERT_LT(glm::dot(view().direction(), direction), 0.95);
        perform(action);
        EXPECT_GT(glm::dot(view().direction(), direction), 0.999);
    }
    // The action turns the eye by 15 degrees in this direction of the picture.
    void expect_turn(Action action, const Vec2& towards) {
        perform(Action::view_front);
        perform(action);
        const Vec3 direction = view().direction();
        EXPECT_NEAR(direction.z, std::cos(glm::radians(15.0)), 2e-3);
        EXPECT_GT(glm::dot(Vec2(direction), towards), 0.2);
    }
    // The words in the file of the preferences; empty while there is none.
    std::string preferences() const {
        const std::string file = "config/pectin/preferences.json";
        return folder().holds(file) ? folder().read(file) : "";
    }
    void expect_preference(Action action, const std::string& words) {
        ASSERT_EQ(preferences().find(words), std::string::npos);
        perform(action);
        EXPECT_TRUE(eventually([&] { return preferences().find(words) != std::string::npos; }))
            << preferences();
    }
    void expect_option_of_drags(Action action, const std::string& option) {
        drag();
        const bool before = last("drag").find(option) != std::string::npos;
        perform(action);
        desktop().drag(kMiddleX - 90, kMiddleY + 60, kMiddleX - 120, kMiddleY + 90);
        ASSERT_TRUE(records("\"drag\"", 2)) << record();
        EXPECT_NE(last("drag").find(option) != std::string::npos, before) << record();
    }
    // The window takes all keys while it is open.
    void expect_dialog(Action action) {
        const std::string key = xdotool_name(info_of(Action::toggle_wireframe).shortcuts.front());
        perform(action);
        desktop().key(key);
        desktop().key("Escape");
        EXPECT_EQ(picture().find("wireframe"), std::string::npos) << record();
        desktop().key(key);
        EXPECT_NE(picture().find("wireframe"), std::string::npos) << record();
    }
    void expect_example(Action action) {
        drag();
        const std::size_t shapes = recorded("\"shape\""), drags = recorded("\"drag\"");
        perform(action);
        desktop().key("Escape");  // answers the question about unsaved changes
        EXPECT_EQ(recorded("\"shape\""), shapes);
        save_as("kept.obj");
        perform(action);
        ASSERT_TRUE(records("\"shape\"", shapes + 1)) << record();
        desktop().key("Escape");              // ends it
        drag(kMiddleX - 132, kMiddleY - 70);  // the object is above the captions
        EXPECT_EQ(recorded("\"drag\""), drags + 1);
        desktop().key("ctrl+z");
        ASSERT_TRUE(records("\"undo\""));
        EXPECT_EQ(recorded("\"shape\""), shapes + 1);
    }

  private:
    int pictures_ = 0;
};

}  // namespace pectin
