// Compares pictures of the whole window with inspected references: small and large windows, at both
// scales, in both themes, with different panels, menus and dialogs.
//
// Versions of Dear ImGui lay text and frames out differently by some pixels, so each has a set of
// its own, unless its pictures are close to those of another one.
#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "golden/expect_golden.h"
#include "support/offscreen.h"
#include "support/offscreen_window.h"

namespace pectin {
namespace {

using test::OffscreenWindow;

// A changed word is some hundred pixels, which the tolerance for pictures of objects allows.
constexpr GoldenTolerance kTolerance{.mean = 0.2, .different = 3e-4};

// The sets of references that there are, by the version without its last number.
constexpr std::array kSets{"imgui186", "imgui190"};
std::string present_set() { return "imgui" + std::to_string(IMGUI_VERSION_NUM / 100); }

// The font that scripts/setup installs. With another one every picture differs.
constexpr const char* kFont =
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf";

Vec2 middle(const OffscreenWindow& window) {
    const auto& free = window.interface().free_area();
    return 0.5 * (free.min + free.max);
}

struct State {
    const char* name;
    IVec2 size;
    float scale;
    bool is_light;
    void (*prepare)(OffscreenWindow&);
};

void hover_over_object(OffscreenWindow& window) { window.move(middle(window) + Vec2{60, 20}); }

void show_cage(OffscreenWindow& window) {
    window.key(Key{'C'});
    window.click("Advanced");
    window.move(middle(window));
}

void show_message(OffscreenWindow& window) {
    window.editor().workspace().set_message(
        "The surface intersects itself in 305 places. Undo, or use a larger radius or a shorter "
        "drag.");
}

void open_menu(OffscreenWindow& window) {
    window.key(Key::f10);
    window.key(Key::down);
}

void open_palette(OffscreenWindow& window) {
    window.key(Key::f3);
    window.type("sy");
}

void open_help(OffscreenWindow& window) { window.key(Key::f1); }

const std::vector<State> kStates{
    {"brush_1280x720_dark", {1280, 720}, 1.0f, false, hover_over_object},
    {"cage_1280x720_light", {1280, 720}, 1.0f, true, show_cage},
    {"message_800x600_dark", {800, 600}, 1.0f, false, show_message},
    {"menu_800x600_light", {800, 600}, 1.0f, true, open_menu},
    {"palette_scale_2_dark", {1600, 1200}, 2.0f, false, open_palette},
    {"help_scale_2_light", {1600, 1200}, 2.0f, true, open_help},
};

class WindowGolden : public OffscreenTest, public testing::WithParamInterface<State> {
  protected:
    Image picture() const {
        const State& state = GetParam();
        OffscreenWindow window({.size = state.size, .scale = state.scale});
        test::WindowPainter painter(gl(), window);
        if (state.is_light) window.editor().perform(Action::toggle_light_theme);
        window.settle();
        state.prepare(window);
        window.settle();
        return painter.draw();
    }
};

TEST_P(WindowGolden, LooksAsItDidWhenItWasInspected) {
    if (!std::filesystem::exists(kFont)) GTEST_SKIP() << "install fonts-roboto-unhinted";
    const auto name = [](const std::string& set) {
        return "window_" + set + "_" + GetParam().name;
    };
    const Image image = picture();
    if (remakes_golden() || has_golden(name(present_set()))) {
        return expect_golden(name(present_set()), image, kTolerance);
    }
    for (const char* set : kSets) {
        if (matches_golden(name(set), image, kTolerance)) return;
    }
    GTEST_SKIP() << "there are no pictures for Dear ImGui " << IMGUI_VERSION
                 << ". To make them, run PECTIN_REMAKE_GOLDEN=1 pectin_golden_tests "
                    "--gtest_filter='*WindowGolden*', look at each, and add the set to this file";
}

std::string name_of(const testing::TestParamInfo<State>& state) { return state.param.name; }

INSTANTIATE_TEST_SUITE_P(All, WindowGolden, testing::ValuesIn(kStates), name_of);

}  // namespace
}  // namespace pectin
