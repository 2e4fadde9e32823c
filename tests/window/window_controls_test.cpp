// Every control of the panels in the real window, and the axes in its corner. What a control did is
// read from the record of the session, from saved pictures' lines there, or from the object.
//
// All controls are used in one window, since opening one takes longer than using a control.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "window/window_twin.h"

namespace pectin {
namespace {

class WindowControls : public WindowTwinTest {
  public:
    // The checks are functions beside the class.
    using WindowTwinTest::click;
    using WindowTwinTest::desktop;
    using WindowTwinTest::drag;
    using WindowTwinTest::editor;
    using WindowTwinTest::find;
    using WindowTwinTest::last;
    using WindowTwinTest::move;
    using WindowTwinTest::picture;
    using WindowTwinTest::reach;
    using WindowTwinTest::record;
    using WindowTwinTest::recorded;
    using WindowTwinTest::records;
    using WindowTwinTest::scroll;
    using WindowTwinTest::twin;
    using WindowTwinTest::viewpoint;

    // Drags the surface beside the middle, and returns the record's line.
    std::string dragged() {
        const std::size_t before = recorded("\"drag\"");
        drag(surface(), surface() + Vec2{40, -50});
        EXPECT_TRUE(records("\"drag\"", before + 1)) << record();
        return last("drag");
    }
    Vec2 surface() {
        const auto free = twin().interface().free_area();
        return glm::floor(0.5 * (free.min + free.max)) + Vec2{-50, 40};
    }
    // The pixels of the object, once they stay the same.
    std::string pixels(int left, int right) {
        move({300, 780});  // the status line
        std::string before, now;
        EXPECT_TRUE(eventually([&] {
            before = std::exchange(now, desktop().screen_digest(left, 40, right, 770));
            return now == before;
        }));
        return now;
    }
    std::string pixels_of_object() { return pixels(60, 960); }
    std::string pixels_of_panel() { return pixels(970, 1280); }

    void use(const std::string& name, int which = 0) { click(reach(name, which)); }
    void type(const std::string& name, const std::string& text) { type_at(reach(name), text); }
    void choose(const std::string& name, const std::string& entry) {
        choose_at(reach(name), entry);
    }
};

using Test = WindowControls;
enum class Gesture { click, type, choose, check };

// A control, what is done with it, and what the record's last line with this command has then.
struct Row {
    const char* control;
    int which;  // of the controls of this name
    Gesture gesture;
    const char* argument;  // the text that is typed, or the entry that is chosen
    const char* command;
    const char* field;
    void (*check)(Test&) = nullptr;  // instead
};

// --- Checks that need more than a line of the record.

void expect_shown(Test& test, const char* control, int which, const char* what) {
    const bool before = test.picture().find(what) != std::string::npos;
    test.use(control, which);
    EXPECT_NE(test.picture().find(what) != std::string::npos, before) << test.record();
}

// Switches an option of drags, drags, and switches it back.
void expect_option(Test& test, const char* control, int which, const char* option) {
    const bool before = test.dragged().find(option) != std::string::npos;
    test.use(control, which);
    EXPECT_NE(test.dragged().find(option) != std::string::npos, before) << test.record();
    test.use(control, which);
}

double length_of_drag(const std::string& line) {
    Vec3 from{0.0}, to{0.0};
    const std::size_t begin = line.find("\"from\": ["), end = line.find("\"to\": [");
    EXPECT_NE(end, line.npos) << line;
    if (end == line.npos) return 0.0;
    EXPECT_EQ(
        std::sscanf(line.c_str() + begin, "\"from\": [%lf, %lf, %lf]", &from.x, &from.y, &from.z),
        3);
    EXPECT_EQ(std::sscanf(line.c_str() + end, "\"to\": [%lf, %lf, %lf]", &to.x, &to.y, &to.z), 3);
    return glm::distance(from, to);
}

// The point follows this part of the cursor's way.
void check_strength(Test& test) {
    const double whole = length_of_drag(test.dragged());
    test.use("Undo");
    test.type("Strength", "50");
    const double half = length_of_drag(test.dragged());
    test.use("Undo");
    test.type("Strength", "100");
    EXPECT_NEAR(half / whole, 0.5, 1e-3);
}

void check_measured_in(Test& test) {
    test.choose("Measured in", "Model units");
    test.type("Radius", "0.5");
    EXPECT_TRUE(test.records("{\"cmd\": \"brush\", \"radius\": 0.5}")) << test.record();
    // The radius is that of the drag's first point, which differs from that of before.
    test.choose("Measured in", "On screen");
    test.type("Radius", "50");
    test.dragged();
    EXPECT_EQ(test.last("brush").find("0.5}"), std::string::npos) << test.record();
    test.choose("Measured in", "Share of the object");
    test.type("Radius", "20");
    EXPECT_TRUE(test.records("\"radius\": 0.692820323")) << test.record();
}

void check_pin_tool(Test& test) {
    test.use("Pin");
    test.click(test.surface() + Vec2{60, 20});
    test.use("Sculpt");
    EXPECT_NE(test.dragged().find("\"pins\": [["), std::string::npos) << test.record();
}
void check_remove_pins(Test& test) {
    test.use("Remove all pins");
    EXPECT_EQ(test.dragged().find("\"pins\": [["), std::string::npos) << test.record();
}

void check_frame_all(Test& test) {
    test.use("Frame all");
    const Vec3 framed = test.viewpoint().eye;
    test.scroll({kMiddleX, kMiddleY}, 3);
    EXPECT_GT(glm::distance(test.viewpoint().eye, framed), 0.1);
    test.use("Frame all");
    EXPECT_LT(glm::distance(test.viewpoint().eye, framed), 1e-9);
}

void check_drag_lattice(Test& test) {
    const auto pixels_of_drag = [&] {
        const std::string at_rest = test.pixels_of_object();
        test.move(test.surface());
        test.desktop().press();
        test.desktop().move(500, 300);
        std::string before, now;
        EXPECT_TRUE(eventually([&] {
            before = std::exchange(now, test.desktop().screen_digest(60, 40, 960, 770));
            return now == before && now != at_rest;
        }));
        test.desktop().key("Escape");
        test.desktop().release();
        return now;
    };
    const std::string without = pixels_of_drag();
    test.use("Lattice during drags");
    EXPECT_NE(pixels_of_drag(), without);
    test.use("Lattice during drags");
}

void check_symmetry_plane(Test& test) {
    const std::string before = test.pixels_of_object();
    test.use("Symmetry plane");
    EXPECT_NE(test.pixels_of_object(), before);
    test.use("Symmetry plane");
    EXPECT_EQ(test.pixels_of_object(), before);
}

// Folds a section. Then another control is where it is only if the section is folded.
void expect_folds(Test& test, const char* section) {
    const std::size_t before = test.recorded("\"adapt\"");
    test.use(section);
    test.use("Refine while dragging");
    EXPECT_TRUE(test.records("\"adapt\"", before + 1)) << test.record();
    test.use("Refine while dragging");
    EXPECT_TRUE(test.records("\"adapt\"", before + 2)) << test.record();
    test.use(section);
}

void check_detail_section(Test& test) {
    test.use("Detail section");
    expect_shown(test, "Wireframe", 1, "\"wireframe\"");
    test.use("Wireframe", 1);
    test.use("Detail section");
}

void expect_folds_panel(Test& test, const char* section) {
    test.reach(section);
    const std::string open = test.pixels_of_panel();
    test.use(section);
    const std::string folded = test.pixels_of_panel();
    EXPECT_NE(folded, open);
    test.use(section);
    EXPECT_NE(test.pixels_of_panel(), folded);  // and scrolled to another place
}

// The counts are those of the cage that the button makes.
void check_counts_of_next_cage(Test& test) {
    const std::size_t before = test.recorded("\"cage\"");
    test.type("Points X", "5");
    test.type("Points Z", "3");
    test.use("Cage", 1);
    EXPECT_TRUE(test.records("\"cage\"", before + 1)) << test.record();
    EXPECT_NE(test.last("cage").find("\"fit\": [5, 4, 3]"), std::string::npos) << test.record();
}

// --- The table, in the order in which the controls are used.

constexpr Gesture kClick = Gesture::click, kType = Gesture::type, kChoose = Gesture::choose,
                  kCheck = Gesture::check;

const std::vector<Row>& brush_rows() {
    static const std::vector<Row> kRows{
        {"Radius", 0, kType, "20", "brush", "\"radius\": 0.692820323"},
        {"Measured in", 0, kCheck, "", "", "", check_measured_in},
        {"Plateau", 0, kClick, "", "brush", "\"falloff\": \"plateau\""},
        {"Sharp", 0, kClick, "", "brush", "\"falloff\": \"sharp\""},
        {"Curve", 0, kCheck, "", "", "", [](Test&) {}},  // a picture
        {"Points per axis", 0, kType, "7", "brush", "\"span\": 7"},
        {"Strength", 0, kCheck, "", "", "", check_strength},
        {"Connected", 0, kCheck, "", "", "",
         [](Test& t) { expect_option(t, "Connected", 0, "\"connected\": true"); }},
        {"Connected", 1, kCheck, "", "", "",
         [](Test& t) { expect_option(t, "Connected", 1, "\"connected\": true"); }},
        {"Fold-free", 0, kCheck, "", "", "",
         [](Test& t) { expect_option(t, "Fold-free", 0, "\"fold_free\": true"); }},
        {"Fold-free", 1, kCheck, "", "", "",
         [](Test& t) { expect_option(t, "Fold-free", 1, "\"fold_free\": true"); }},
        {"Undo", 0, kClick, "", "undo", "undo"},
        {"Redo", 0, kClick, "", "redo", "redo"},
        {"Pin", 0, kCheck, "", "", "", check_pin_tool},
        {"Remove all pins", 0, kCheck, "", "", "", check_remove_pins},
        {"Symmetry", 0, kClick, "", "symmetry", "\"plane\": null"},
        {"Symmetry", 1, kClick, "", "symmetry", "\"plane\": \"x\""},
        {"Y", 0, kClick, "", "symmetry", "\"plane\": \"y\""},
        {"Z", 0, kClick, "", "symmetry", "\"plane\": \"z\""},
        {"X", 0, kClick, "", "symmetry", "\"plane\": \"x\""},
        {"Plane through", 0, kChoose, "Middle of the object", "symmetry", "\"plane\": \"x\""},
        {"Plane through", 0, kChoose, "Origin", "symmetry", "\"plane\": \"x\""},
        {"Brush section", 0, kCheck, "", "", "", [](Test& t) { expect_folds(t, "Brush section"); }},
        {"Refine while dragging", 0, kClick, "", "adapt", "\"enabled\": false"},
        {"Refine while dragging", 0, kClick, "", "adapt", "\"enabled\": true"},
        {"Detail", 0, kType, "17.5", "adapt", "\"theta_max\": 17.5"},
        {"Apply detail to the whole object", 0, kClick, "", "readapt", "readapt"},
        {"Detail section", 0, kCheck, "", "", "", check_detail_section},
        {"Advanced", 0, kClick, "", "", ""},  // the next rows could not be used without
        {"Trigger", 0, kChoose, "certified", "adapt", "\"trigger\": \"certified\""},
        {"Tolerance", 0, kType, "0.25", "adapt", "\"tolerance\": 0.25"},
        {"Tolerance mode", 0, kChoose, "auto", "adapt", "\"tolerance\": \"auto\""},
        {"Detail", 0, kType, "0.125", "adapt", "\"tolerance\": 0.125"},
        {"Trigger", 0, kChoose, "normals", "adapt", "\"trigger\": \"normals\""},
        {"θ max", 0, kType, "12.5", "adapt", "\"theta_max\": 12.5"},
        {"θ max mode", 0, kChoose, "off", "adapt", "\"theta_max\": null"},
        {"θ max mode", 0, kChoose, "set", "adapt", "\"theta_max\": "},
        {"θ min", 0, kType, "4", "adapt", "\"theta_min\": 4"},
        {"θ min mode", 0, kChoose, "auto", "adapt", "\"theta_min\": \"auto\""},
        {"Flatness", 0, kType, "0.125", "adapt", "\"flatness\": 0.125"},
        {"Flatness mode", 0, kChoose, "off", "adapt", "\"flatness\": null"},
        {"L max", 0, kType, "0.75", "adapt", "\"l_max\": 0.75"},
        {"L max mode", 0, kChoose, "auto", "adapt", "\"l_max\": \"auto\""},
        {"Floor", 0, kType, "0.001", "adapt", "\"floor\": 0.001"},
        {"Floor mode", 0, kChoose, "auto", "adapt", "\"floor\": \"auto\""},
        {"Budget", 0, kType, "123456", "adapt", "\"budget\": 123456"},
        {"Per drag", 0, kType, "5000", "adapt", "\"drag_budget\": 5000"},
        {"Per drag mode", 0, kChoose, "off", "adapt", "\"drag_budget\": null"},
        {"Advanced", 0, kClick, "", "", ""},
        {"Wireframe", 0, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Wireframe", 0, "\"wireframe\""); }},
        {"Wireframe", 1, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Wireframe", 1, "\"wireframe\""); }},
        {"Refinement levels", 0, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Refinement levels", 0, "\"levels\""); }},
        {"Refinement levels", 1, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Refinement levels", 1, "\"levels\""); }},
        {"Lattice", 0, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Lattice", 0, "\"lattice\""); }},
        {"Lattice during drags", 0, kCheck, "", "", "", check_drag_lattice},
        {"Symmetry plane", 0, kCheck, "", "", "", check_symmetry_plane},
        {"Display section", 0, kCheck, "", "", "",
         [](Test& t) { expect_folds_panel(t, "Display section"); }},
        {"Frame all", 0, kCheck, "", "", "", check_frame_all},
    };
    return kRows;
}

const std::vector<Row>& cage_rows() {
    static const std::vector<Row> kRows{
        {"Cage", 0, kClick, "", "cage", "\"fit\": [4, 4, 4]"},
        {"Sculpt", 0, kClick, "", "brush", "\"radius\": "},
        {"Cage", 1, kCheck, "", "", "", check_counts_of_next_cage},
        {"Points X", 0, kType, "6", "cage", "\"deformable\": [6, 4, 3]"},
        {"Points Y", 0, kType, "5", "cage", "\"deformable\": [6, 5, 3]"},
        {"Points Z", 0, kType, "4", "cage", "\"deformable\": [6, 5, 4]"},
        {"Middle X", 0, kType, "0.5", "cage", "\"origin\": [-0.5, -1, -"},
        {"Middle Y", 0, kType, "0.25", "cage", "\"origin\": [-0.5, -0.75, -"},
        {"Middle Z", 0, kType, "2", "cage", "\"origin\": [-0.5, -0.75, 1"},
        {"Size X", 0, kType, "2.5", "cage", "\"cell\": [0.5, 0.5, "},
        {"Size Y", 0, kType, "4", "cage", "\"cell\": [0.5, 1, "},
        {"Size Z", 0, kType, "3", "cage", "\"cell\": [0.5, 1, 1]"},
        {"Fit the cage to the object", 0, kClick, "", "cage", "\"fit\": [6, 5, 4]"},
        {"Lattice", 0, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Lattice", 0, "\"lattice\""); }},
        {"Lattice", 1, kCheck, "", "", "",
         [](Test& t) { expect_shown(t, "Lattice", 1, "\"lattice\""); }},
        {"Cage section", 0, kCheck, "", "", "",
         [](Test& t) { expect_folds_panel(t, "Cage section"); }},
    };
    return kRows;
}

void use_row(Test& test, const Row& row) {
    SCOPED_TRACE(std::string(row.control) + " " + row.argument);
    const Control* const control = test.find(row.control, row.which);
    ASSERT_TRUE(control) << "there is no such control now";
    EXPECT_TRUE(control->is_enabled);
    const std::string command = std::string("{\"cmd\": \"") + row.command + "\"";
    const std::size_t before = test.recorded(command);
    switch (row.gesture) {
        case Gesture::click:
            test.use(row.control, row.which);
            break;
        case Gesture::type:
            test.type(row.control, row.argument);
            break;
        case Gesture::choose:
            test.choose(row.control, row.argument);
            break;
        case Gesture::check:
            return row.check(test);
    }
    if (*row.command == '\0') return;
    ASSERT_TRUE(test.records(command, before + 1)) << test.record();
    EXPECT_NE(test.last(row.command).find(row.field), std::string::npos) << test.last(row.command);
}

class WindowControlRows : public WindowControls {
  protected:
    void use_rows(const std::vector<Row>& rows) {
        open_both();
        if (HasFatalFailure()) return;
        for (const Row& row : rows) {
            use_row(*this, row);
            if (HasFailure()) return;
        }
        save_as("window.obj");
        quit();
        EXPECT_TRUE(folder().read("window.obj") == replayed());
    }
};

TEST_F(WindowControlRows, OfBrushDetailDisplayAndToolsDoWhatTheySay) { use_rows(brush_rows()); }

TEST_F(WindowControlRows, OfTheCageDoWhatTheySay) { use_rows(cage_rows()); }

// --- A new control needs a row.

using Counts = std::map<std::string, int>;

Counts counts_of(test::OffscreenWindow& window) {
    window.settle();
    Counts counts;
    for (const Control& control : window.interface().controls().all()) ++counts[control.name];
    return counts;
}

void expect_rows(const Counts& controls, const std::vector<Row>& rows) {
    EXPECT_GT(controls.size(), 35u);
    for (const auto& [name, count] : controls) {
        for (int which = 0; which < count; ++which) {
            EXPECT_TRUE(std::ranges::any_of(rows,
                                            [&, &name = name](const Row& row) {
                                                return row.control == name && row.which == which;
                                            }))
                << "the control \"" << name << "\" (" << which << ") has no row in this file";
        }
    }
}

TEST(ControlRows, AreThereForEveryControlOfThePanels) {
    test::OffscreenWindow window({.size = {1280, 800}});
    ASSERT_TRUE(window.click("Advanced"));
    window.move({510, 400});
    window.key(Key{'P'});
    std::vector<Row> rows = brush_rows();
    rows.insert(rows.end(), cage_rows().begin(), cage_rows().end());
    ASSERT_TRUE(counts_of(window).contains("Remove all pins"));
    expect_rows(counts_of(window), rows);
    window.key(Key{'C'});
    ASSERT_TRUE(counts_of(window).contains("Middle X"));
    expect_rows(counts_of(window), rows);
}

// --- The axes.

class WindowAxes : public WindowTwinTest {
  protected:
    // Where the eye is, seen from its target.
    Vec3 direction() {
        const Viewpoint view = viewpoint();
        return glm::normalize(view.eye - view.target);
    }
    Vec2 place_of(const AxisEnd& wanted) {
        const std::optional<AxesGizmo> axes = editor().view_control().axes();
        EXPECT_TRUE(axes);
        const auto end = std::ranges::find(axes->ends, wanted, &AxesGizmo::End::end);
        return glm::floor(end->at);
    }
};

TEST_F(WindowAxes, EachEndLooksAlongItsAxisAndASecondClickFromTheOtherSide) {
    open_both();
    if (HasFatalFailure()) return;
    for (int axis = 0; axis < 3; ++axis) {
        const AxisEnd end{axis, true};
        const Vec2 at = place_of(end);
        click(at);
        EXPECT_GT(glm::dot(direction(), end.direction()), 0.999) << record();
        click(place_of(end));  // in the middle now
        EXPECT_GT(glm::dot(direction(), -end.direction()), 0.999) << record();
    }
    quit();
}

TEST_F(WindowAxes, ADragOfThemTurnsTheViewAndNotTheObject) {
    open_both();
    if (HasFatalFailure()) return;
    const Vec3 before = direction();
    const Vec2 centre = glm::floor(editor().view_control().axes()->centre);
    drag(centre, centre + Vec2{-100, 0});
    const Vec3 now = direction();
    EXPECT_NEAR(now.y, before.y, 0.01) << "to the side";
    EXPECT_LT(glm::dot(now, before), 0.97);
    EXPECT_NEAR(glm::distance(now, -editor().camera().forward()), 0.0, 0.05);
    EXPECT_EQ(recorded("\"drag\""), 0u);
    quit();
}

}  // namespace
}  // namespace pectin
