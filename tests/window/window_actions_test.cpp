// Performs every action of the table in the real window, by its shortcut or else by its name in the
// window that finds actions, and looks at what it did: to the object, or to the settings that the
// record of the session shows. An action without a check fails.
#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include "window/window_actions_fixture.h"

namespace pectin {
namespace {

using Test = WindowActions;

void write_wedge(const Test& test) {
    test.folder().write("wedge.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
                        "f 2 3 4\n");
}

void check_open(Test& test) {
    write_wedge(test);
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

// Drags refine the surface, unless they are undone, and the whole object is refined on request.
void check_readapt(Test& test) {
    test.drag();
    test.perform(Action::readapt);
    ASSERT_TRUE(test.records("\"readapt\"")) << test.record();
}

void check_zoom(Test& test, Action zoom, bool is_nearer) {
    const double before = glm::length(test.view().eye);  // from the middle of the sphere
    test.perform(zoom);
    EXPECT_EQ(glm::length(test.view().eye) < before, is_nearer);
}

// Without perspective the same scale needs another distance, so only the picture's field tells.
void check_orthographic(Test& test) {
    EXPECT_EQ(test.picture().find("orthographic"), std::string::npos);
    test.perform(Action::toggle_orthographic);
    EXPECT_NE(test.picture().find("orthographic"), std::string::npos) << test.record();
}

void check_z_up(Test& test) {
    test.perform(Action::toggle_z_up);
    const std::string line = test.picture();
    EXPECT_NE(line.find("\"up\": [0, 0, 1]"), std::string::npos) << line;
}

void check_larger_text(Test& test) {
    test.expect_preference(Action::larger_text, "\"scale\": 1.1");
}

void check_normal_text(Test& test) {
    check_larger_text(test);
    test.perform(Action::normal_text);
    EXPECT_TRUE(eventually([&] { return test.preferences().find("1.1") == std::string::npos; }))
        << test.preferences();
}

// The menu File is open then, and its second entry opens a model.
void check_open_menus(Test& test) {
    write_wedge(test);
    test.perform(Action::open_menus);
    test.desktop().key("Down");
    test.desktop().key("Return");
    test.desktop().type(test.path("wedge.obj"));
    test.desktop().key("Return");
    ASSERT_TRUE(test.records("\"open\"")) << test.record();
}

void check_cage(Test& test) {
    test.perform(Action::use_cage);
    ASSERT_TRUE(test.records("\"cage\"")) << test.record();
    EXPECT_EQ(test.last("cage").find("null"), std::string::npos);
    const std::size_t before = test.recorded("\"cage\"");
    test.perform(Action::fit_cage);
    ASSERT_TRUE(test.records("\"cage\"", before + 1)) << test.record();
    const std::size_t brushes = test.recorded("\"brush\"");
    test.perform(Action::use_brush);
    ASSERT_TRUE(test.records("\"brush\"", brushes + 1)) << test.record();
}

void check_repeat_drag(Test& test) {
    test.drag();
    test.desktop().move(kMiddleX - 90, kMiddleY + 60);
    test.perform(Action::repeat_drag);
    ASSERT_TRUE(test.records("\"drag\"", 2)) << test.record();
}

// Only the picture on the screen shows the lattice of a drag.
void check_drag_lattice(Test& test) {
    const auto pixels_of_drag = [&] {
        test.desktop().move(kMiddleX, kMiddleY);
        test.desktop().press();
        test.desktop().move(kMiddleX + 10, kMiddleY - 12);
        test.desktop().move(kMiddleX + 40, kMiddleY - 50);
        std::string before, now;
        EXPECT_TRUE(eventually([&] {
            before = std::exchange(now, test.desktop().screen_digest(100, 100, 800, 700));
            return now == before;
        }));
        test.desktop().key("Escape");
        test.desktop().release();
        return now;
    };
    const std::string without = pixels_of_drag();
    test.perform(Action::toggle_drag_lattice);
    EXPECT_NE(pixels_of_drag(), without);
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
        {Action::save_picture,
         [](Test& t) { EXPECT_NE(t.picture().find("\"eye\""), std::string::npos); }},
        {Action::quit, check_quit},
        {Action::undo, [](Test& t) { check_undo(t, Action::undo); }},
        {Action::redo, check_redo},
        {Action::toggle_symmetry, check_symmetry},
        {Action::remove_pins, check_remove_pins},
        {Action::readapt, check_readapt},
        {Action::bake, check_bake},
        {Action::frame_all, check_frame_all},
        {Action::view_front,
         [](Test& t) {
             t.expect_view(Action::view_front, {0, 0, 1});
         }},
        {Action::view_back,
         [](Test& t) {
             t.expect_view(Action::view_back, {0, 0, -1});
         }},
        {Action::view_right,
         [](Test& t) {
             t.expect_view(Action::view_right, {1, 0, 0});
         }},
        {Action::view_left,
         [](Test& t) {
             t.expect_view(Action::view_left, {-1, 0, 0});
         }},
        {Action::view_top,
         [](Test& t) {
             t.expect_view(Action::view_top, {0, 1, 0});
         }},
        {Action::view_bottom,
         [](Test& t) {
             t.expect_view(Action::view_bottom, {0, -1, 0});
         }},
        {Action::turn_left,
         [](Test& t) {
             t.expect_turn(Action::turn_left, {-1, 0});
         }},
        {Action::turn_right,
         [](Test& t) {
             t.expect_turn(Action::turn_right, {1, 0});
         }},
        {Action::turn_up,
         [](Test& t) {
             t.expect_turn(Action::turn_up, {0, 1});
         }},
        {Action::turn_down,
         [](Test& t) {
             t.expect_turn(Action::turn_down, {0, -1});
         }},
        {Action::zoom_in, [](Test& t) { check_zoom(t, Action::zoom_in, true); }},
        {Action::zoom_out, [](Test& t) { check_zoom(t, Action::zoom_out, false); }},
        {Action::toggle_orthographic, check_orthographic},
        {Action::toggle_z_up, check_z_up},
        {Action::navigate_as_blender,
         [](Test& t) {
             t.expect_preference(Action::navigate_as_maya, "Maya");
             t.perform(Action::navigate_as_blender);
             EXPECT_TRUE(
                 eventually([&] { return t.preferences().find("Maya") == std::string::npos; }));
         }},
        {Action::navigate_as_maya,
         [](Test& t) { t.expect_preference(Action::navigate_as_maya, "Maya"); }},
        {Action::navigate_as_zbrush,
         [](Test& t) { t.expect_preference(Action::navigate_as_zbrush, "ZBrush"); }},
        {Action::toggle_wireframe,
         [](Test& t) { t.expect_shown(Action::toggle_wireframe, "\"wireframe\""); }},
        {Action::toggle_lattice,
         [](Test& t) { t.expect_shown(Action::toggle_lattice, "\"lattice\""); }},
        {Action::toggle_levels,
         [](Test& t) { t.expect_shown(Action::toggle_levels, "\"levels\""); }},
        {Action::toggle_drag_lattice, check_drag_lattice},
        {Action::toggle_symmetry_plane, check_symmetry_plane},
        {Action::toggle_panels,
         [](Test& t) { t.expect_preference(Action::toggle_panels, "\"hides_panels\": true"); }},
        {Action::toggle_light_theme,
         [](Test& t) { t.expect_preference(Action::toggle_light_theme, "\"light\""); }},
        {Action::larger_text, check_larger_text},
        {Action::smaller_text,
         [](Test& t) { t.expect_preference(Action::smaller_text, "\"scale\": 0.9"); }},
        {Action::normal_text, check_normal_text},
        {Action::open_menus, check_open_menus},
        {Action::use_brush, check_cage},
        {Action::use_cage, check_cage},
        {Action::fit_cage, check_cage},
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
        {Action::repeat_drag, check_repeat_drag},
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
