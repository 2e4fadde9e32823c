// Performs every action of the table in the real window, by its shortcut or else by its name in the
// window that finds actions, and looks at what it did: to the object, or to the settings that the
// record of the session shows. An action without a check fails.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "app/actions.h"
#include "geometry/vec.h"
#include "window/window_fixture.h"

namespace pectin {
namespace {

// The shortcut as xdotool calls it, such as "ctrl+shift+z".
std::string xdotool_name(const Shortcut& shortcut) {
    static const std::map<std::string, std::string> kNames{
        {"[", "bracketleft"}, {"]", "bracketright"}, {".", "period"},     {",", "comma"},
        {"Keypad 1", "KP_1"}, {"Keypad 3", "KP_3"},  {"Keypad 7", "KP_7"}};
    Shortcut plain = shortcut;
    plain.modifiers = {};
    std::string key = label_of(plain);
    if (const auto named = kNames.find(key); named != kNames.end()) key = named->second;
    if (key.size() == 1) key[0] = static_cast<char>(std::tolower(key[0]));
    return std::string(shortcut.modifiers.control ? "ctrl+" : "") +
           (shortcut.modifiers.shift ? "shift+" : "") + key;
}

// A name without the dots at its end.
std::string typed_name(const ActionInfo& info) {
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
    void drag() {
        const std::size_t before = recorded("\"drag\"");
        desktop().drag(kMiddleX, kMiddleY, kMiddleX + 60, kMiddleY - 70);
        ASSERT_TRUE(records("\"drag\"", before + 1)) << record();
    }
    // The last line of the record with this command.
    std::string last(const std::string& command) const {
        const std::string text = record();
        const std::size_t begin = text.rfind("{\"cmd\": \"" + command + "\"");
        if (begin == text.npos) return "";
        return text.substr(begin, text.find('\n', begin) - begin);
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
        desktop().key("Escape");  // ends it
        drag();
        EXPECT_EQ(recorded("\"drag\""), drags + 1);
        desktop().key("ctrl+z");
        ASSERT_TRUE(records("\"undo\""));
        EXPECT_EQ(recorded("\"shape\""), shapes + 1);
    }

  private:
    int pictures_ = 0;
};

using Test = WindowActions;

void check_open(Test& test) {
    test.folder().write("wedge.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
                        "f 2 3 4\n");
    test.perform(Action::open);
    test.desktop().type(test.path("wedge.obj"));
    test.desktop().key("Return");
    ASSERT_TRUE(test.records("\"open\"")) << test.record();
    EXPECT_EQ(test.obj("copy.obj").find("\nf ") != std::string::npos, true);
}

void check_saving(Test& test, Action action) {
    test.perform(action);
    test.desktop().type(test.path("saved.obj"));
    test.desktop().key("Return");
    ASSERT_TRUE(test.records("saved.obj")) << test.record();
    EXPECT_TRUE(test.folder().read("saved.obj") == test.obj("again.obj"));
}

void check_save(Test& test) {
    test.save_as("ball.obj");
    const std::string before = test.folder().read("ball.obj");
    test.drag();
    test.perform(Action::save);
    ASSERT_TRUE(test.records("\"save\"", 2)) << test.record();
    EXPECT_TRUE(test.folder().read("ball.obj") != before);
}

void check_quit(Test& test) {
    test.perform(Action::quit);
    EXPECT_EQ(test.program().wait(), 0);
}

void check_undo(Test& test, Action undo) {
    const std::string before = test.obj("before.obj");
    test.drag();
    test.perform(undo);
    ASSERT_TRUE(test.records("\"undo\""));
    EXPECT_TRUE(test.obj("after.obj") == before);
}

void check_redo(Test& test) {
    test.drag();
    const std::string before = test.obj("before.obj");
    test.perform(Action::undo);
    ASSERT_TRUE(test.records("\"undo\""));
    test.perform(Action::redo);
    ASSERT_TRUE(test.records("\"redo\""));
    EXPECT_TRUE(test.obj("after.obj") == before);
}

void check_symmetry(Test& test) {
    const std::size_t before = test.recorded("\"symmetry\"");
    const bool was_on = test.last("symmetry").find("null") == std::string::npos;
    test.perform(Action::toggle_symmetry);
    ASSERT_TRUE(test.records("\"symmetry\"", before + 1)) << test.record();
    EXPECT_NE(test.last("symmetry").find("null") == std::string::npos, was_on);
}

void check_remove_pins(Test& test) {
    test.desktop().move(kMiddleX + 60, kMiddleY + 70);
    test.desktop().key("p");
    test.desktop().move(kMiddleX, kMiddleY);
    test.drag();
    EXPECT_NE(test.last("drag").find("\"pins\": [["), std::string::npos) << test.record();
    test.perform(Action::remove_pins);
    test.desktop().drag(kMiddleX - 90, kMiddleY + 60, kMiddleX - 120, kMiddleY + 90);
    ASSERT_TRUE(test.records("\"drag\"", 2));
    EXPECT_EQ(test.last("drag").find("\"pins\": [["), std::string::npos) << test.record();
}

void check_bake(Test& test) {
    // With a small radius the drag bends the surface enough to refine it.
    for (int i = 0; i < 6; ++i) test.perform(Action::smaller_radius);
    test.drag();
    test.perform(Action::bake);
    ASSERT_TRUE(test.records("\"bake\"")) << test.record();
}

void check_frame_all(Test& test) {
    const double before = test.view().distance();
    test.desktop().move(kMiddleX, kMiddleY);
    for (int i = 0; i < 4; ++i) {
        test.desktop().press(4);
        test.desktop().release(4);
    }
    EXPECT_LT(test.view().distance(), 0.9 * before);
    test.perform(Action::frame_all);
    EXPECT_NEAR(test.view().distance(), before, 0.01 * before);
}

// What the window shows of the plane is no setting of the record, so only the picture tells.
void check_symmetry_plane(Test& test) {
    const auto digest = [&] {
        return test.desktop().screen_digest(kMiddleX - 200, 150, kMiddleX + 200, 600);
    };
    const auto leave_object = [&] { test.desktop().move(kMiddleX, kMiddleY + 330); };
    leave_object();
    std::string before = digest();
    ASSERT_TRUE(eventually([&] { return digest() == std::exchange(before, digest()); }));
    test.perform(Action::toggle_symmetry_plane);
    leave_object();
    EXPECT_TRUE(eventually([&] { return digest() != before; }));
    test.perform(Action::toggle_symmetry_plane);
    leave_object();
    EXPECT_TRUE(eventually([&] { return digest() == before; }));
}

void check_pinning(Test& test) {
    test.perform(Action::toggle_pinning);
    test.desktop().move(kMiddleX + 60, kMiddleY + 70);
    test.desktop().press();
    test.desktop().release();
    test.perform(Action::toggle_pinning);
    test.drag();
    EXPECT_NE(test.last("drag").find("\"pins\": [["), std::string::npos) << test.record();
}

void check_pin(Test& test) {
    test.desktop().move(kMiddleX + 60, kMiddleY + 70);
    test.perform(Action::toggle_pin);
    test.drag();
    EXPECT_NE(test.last("drag").find("\"pins\": [["), std::string::npos) << test.record();
}

void check_radius(Test& test) {
    test.perform(Action::smaller_radius);
    ASSERT_TRUE(test.records("\"brush\"", 1)) << test.record();
    const double first = test.radius();
    test.perform(Action::smaller_radius);
    ASSERT_TRUE(test.records("\"brush\"", 2)) << test.record();
    const double smaller = test.radius();
    EXPECT_LT(smaller, first);
    test.perform(Action::larger_radius);
    ASSERT_TRUE(test.records("\"brush\"", 3)) << test.record();
    EXPECT_GT(test.radius(), smaller);
}

void check_palette(Test& test) {
    const std::size_t before = test.recorded("\"shape\"");
    test.perform(Action::show_actions);
    test.desktop().type("toru");
    test.desktop().key("Return");
    ASSERT_TRUE(test.records("\"shape\"", before + 1)) << test.record();
    EXPECT_NE(test.last("shape").find("torus"), std::string::npos);
}

using Check = void (*)(Test&);

// A new action needs a line here.
const std::map<Action, Check>& checks() {
    static const std::map<Action, Check> kChecks{
        {Action::new_sphere, [](Test& t) { t.expect_shape(Action::new_sphere, "sphere"); }},
        {Action::new_cube, [](Test& t) { t.expect_shape(Action::new_cube, "cube"); }},
        {Action::new_plane, [](Test& t) { t.expect_shape(Action::new_plane, "plane"); }},
        {Action::new_torus, [](Test& t) { t.expect_shape(Action::new_torus, "torus"); }},
        {Action::new_cylinder, [](Test& t) { t.expect_shape(Action::new_cylinder, "cylinder"); }},
        {Action::open, check_open},
        {Action::save, check_save},
        {Action::save_as, [](Test& t) { check_saving(t, Action::save_as); }},
        {Action::export_obj, [](Test& t) { check_saving(t, Action::export_obj); }},
        {Action::save_picture,
         [](Test& t) { EXPECT_NE(t.picture().find("\"eye\""), std::string::npos); }},
        {Action::quit, check_quit},
        {Action::undo, [](Test& t) { check_undo(t, Action::undo); }},
        {Action::redo, check_redo},
        {Action::toggle_symmetry, check_symmetry},
        {Action::remove_pins, check_remove_pins},
        {Action::bake, check_bake},
        {Action::frame_all, check_frame_all},
        {Action::view_front,
         [](Test& t) {
             t.expect_view(Action::view_front, {0, 0, 1});
         }},
        {Action::view_right,
         [](Test& t) {
             t.expect_view(Action::view_right, {1, 0, 0});
         }},
        {Action::view_top,
         [](Test& t) {
             t.expect_view(Action::view_top, {0, 1, 0});
         }},
        {Action::toggle_wireframe,
         [](Test& t) { t.expect_shown(Action::toggle_wireframe, "\"wireframe\""); }},
        {Action::toggle_lattice,
         [](Test& t) { t.expect_shown(Action::toggle_lattice, "\"lattice\""); }},
        {Action::toggle_levels,
         [](Test& t) { t.expect_shown(Action::toggle_levels, "\"levels\""); }},
        {Action::toggle_symmetry_plane, check_symmetry_plane},
        {Action::toggle_connected,
         [](Test& t) {
             t.expect_option_of_drags(Action::toggle_connected, "\"connected\": true");
         }},
        {Action::toggle_fold_free,
         [](Test& t) {
             t.expect_option_of_drags(Action::toggle_fold_free, "\"fold_free\": true");
         }},
        {Action::toggle_pinning, check_pinning},
        {Action::toggle_pin, check_pin},
        {Action::smaller_radius, check_radius},
        {Action::larger_radius, check_radius},
        {Action::show_inputs, [](Test& t) { t.expect_dialog(Action::show_inputs); }},
        {Action::show_actions, check_palette},
        {Action::example_nose, [](Test& t) { t.expect_example(Action::example_nose); }},
        {Action::example_elephant, [](Test& t) { t.expect_example(Action::example_elephant); }},
        {Action::example_cage, [](Test& t) { t.expect_example(Action::example_cage); }},
        {Action::show_reference, [](Test& t) { t.expect_dialog(Action::show_reference); }},
        {Action::show_about, [](Test& t) { t.expect_dialog(Action::show_about); }},
    };
    return kChecks;
}

TEST_P(WindowActions, DoWhatTheirNamesSay) {
    const auto check = checks().find(GetParam());
    ASSERT_NE(check, checks().end())
        << "the action \"" << info_of(GetParam()).name << "\" has no check in this file";
    open_window();
    if (HasFatalFailure()) return;
    check->second(*this);
}

std::vector<Action> every_action() {
    std::vector<Action> actions;
    for (const ActionInfo& info : all_actions()) actions.push_back(info.action);
    return actions;
}

std::string test_name(const testing::TestParamInfo<Action>& info) {
    std::string name;
    for (const char c : typed_name(info_of(info.param))) {
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, WindowActions, testing::ValuesIn(every_action()), test_name);

}  // namespace
}  // namespace pectin
