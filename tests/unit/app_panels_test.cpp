// The panels on both sides: whether everything can be seen, reached, understood and typed.
#include <imgui.h>
#include <imgui_internal.h>

#include <functional>
#include <set>
#include <vector>

#include "app/editor_scene.h"
#include "unit/app_panels_fixture.h"

namespace pectin {
namespace {

// --- Layout.

struct Screen {
    IVec2 size;
    float scale;
    bool has_cage = false;
};

std::ostream& operator<<(std::ostream& out, const Screen& s) {
    return out << s.size.x << " x " << s.size.y << " at scale " << s.scale
               << (s.has_cage ? " with a cage" : "");
}

class PanelLayoutTest : public PanelsTest, public testing::WithParamInterface<Screen> {
  protected:
    void SetUp() override {
        show(GetParam().size, GetParam().scale);
        if (GetParam().has_cage) editor_->use_cage();
        open_advanced();
    }
    // Every control of the panels, by scrolling through them.
    std::set<std::string> names() {
        std::set<std::string> names;
        lay_out();
        for (const Control& control : interface_->controls().all()) names.insert(control.name);
        return names;
    }
};

bool overlap(const Control& a, const Control& b) {
    constexpr double kTouching = 0.6;  // pixels
    return a.min.x + kTouching < b.max.x && b.min.x + kTouching < a.max.x &&
           a.min.y + kTouching < b.max.y && b.min.y + kTouching < a.max.y;
}

TEST_P(PanelLayoutTest, NoControlOverlapsAnotherOrThePanelsEdge) {
    const std::vector<Control>& controls = interface_->controls().all();
    ASSERT_GT(controls.size(), 30u);
    const auto& free = interface_->free_area();
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const Control& a = controls[i];
        SCOPED_TRACE(a.name);
        EXPECT_GE(a.min.x, 0.0);
        EXPECT_LE(a.max.x, size_.x);
        EXPECT_TRUE(a.max.x <= free.min.x || a.min.x >= free.max.x) << "over the object";
        EXPECT_GE(a.max.x - a.min.x, 14.0) << "too narrow to hit";
        EXPECT_GE(a.max.y - a.min.y, 14.0) << "too low to hit";
        for (std::size_t j = i + 1; j < controls.size(); ++j) {
            EXPECT_FALSE(overlap(a, controls[j])) << controls[j].name;
        }
    }
}

TEST_P(PanelLayoutTest, EveryControlCanBeReached) {
    for (const std::string& name : names()) {
        SCOPED_TRACE(name);
        const Vec2 at = reach(name);
        EXPECT_TRUE(at.x > 0.0 && at.x < size_.x && at.y > 0.0 && at.y < size_.y);
        give(event::MouseMove{at});
        EXPECT_TRUE(ImGui::IsMouseHoveringRect({0, 0}, {1e4f, 1e4f}, false));
    }
}

TEST_P(PanelLayoutTest, HalfOfTheWindowIsLeftForTheObject) {
    const auto& free = interface_->free_area();
    EXPECT_GE(free.max.x - free.min.x, 0.4 * size_.x);
    EXPECT_GE(free.max.y - free.min.y, 0.8 * size_.y);
}

INSTANTIATE_TEST_SUITE_P(Screens, PanelLayoutTest,
                         testing::Values(Screen{{1280, 720}, 1.0f}, Screen{{1280, 720}, 1.0f, true},
                                         Screen{{800, 600}, 1.0f}, Screen{{800, 600}, 1.0f, true},
                                         Screen{{1600, 1200}, 2.0f},
                                         Screen{{2560, 1440}, 2.0f, true},
                                         Screen{{1280, 720}, 2.0f, true}));

// --- Tooltips.

// The item under the cursor, and whether a tooltip is shown.
struct Under {
    ImGuiID item;
    bool has_tooltip;
};

class TooltipTest : public PanelsTest {
  protected:
    Under under(const Vec2& at) {
        give(event::MouseMove{at});
        for (int i = 0; i < 2; ++i) interface_->lay_out(*editor_, {});
        const ImGuiContext& context = *ImGui::GetCurrentContext();
        bool has_tooltip = false;
        for (const ImGuiWindow* window : context.Windows) {
            has_tooltip |= window->Active && (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
        }
        return {context.HoveredIdPreviousFrame, has_tooltip};
    }
};

TEST_F(TooltipTest, EveryControlOfThePanelsHasOne) {
    editor_->use_cage();
    open_advanced();
    std::set<ImGuiID> seen;
    const auto look_at = [&](double left, double right) {
        const auto& free = interface_->free_area();
        for (double y = free.min.y + 3.0; y < free.max.y; y += 8.0) {
            for (double x = left + 3.0; x < right; x += 12.0) {
                const Under found = under({x, y});
                if (found.item == 0 || !seen.insert(found.item).second) continue;
                const std::string window = ImGui::GetCurrentContext()->HoveredWindow->Name;
                const bool is_scrollbar =
                    x > size_.x - 14.0 &&
                    found.item == ImGui::GetWindowScrollbarID(
                                      ImGui::GetCurrentContext()->HoveredWindow, ImGuiAxis_Y);
                EXPECT_TRUE(found.has_tooltip || is_scrollbar)
                    << "at " << x << ", " << y << " in " << window;
            }
        }
    };
    const auto free = interface_->free_area();
    look_at(0.0, free.min.x);
    look_at(free.max.x, size_.x);
    give(event::MouseMove{{size_.x - 100.0, 300.0}});
    for (int i = 0; i < 40; ++i) give(event::Scroll{-1.0, {size_.x - 100.0, 300.0}});
    look_at(free.max.x, size_.x);
    EXPECT_GT(seen.size(), 30u);
}

TEST_F(TooltipTest, EachIsOneOrTwoSentencesInPlainWords) {
    editor_->use_cage();
    open_advanced();
    for (const Control& control : interface_->controls().all()) {
        SCOPED_TRACE(control.name + ": " + control.tooltip);
        ASSERT_GT(control.tooltip.size(), 10u);
        EXPECT_TRUE(control.tooltip.ends_with('.') || control.tooltip.ends_with(')'));
        EXPECT_LE(std::ranges::count(control.tooltip, '.'), 6);
        for (const char* word : {"_", "null", "lattice cell", "decimat", "zone"}) {
            EXPECT_EQ(control.tooltip.find(word), std::string::npos) << word;
        }
    }
}

// --- Numbers.

TEST_F(PanelsTest, DoubleClickLetsEveryNumberBeTyped) {
    editor_->use_cage();
    open_advanced();
    const auto adapt = [this] { return editor_->session().adapt_settings(); };
    const auto cage = [this] { return *editor_->session().lattice_settings().cage; };
    struct Typed {
        const char* name;
        const char* text;
        std::function<double()> value;
        double expected;
    };
    const std::vector<Typed> numbers{
        {"Detail", "17.5", [&] { return adapt().theta_max.value; }, 17.5},
        {"θ max", "12.5", [&] { return adapt().theta_max.value; }, 12.5},
        {"θ min", "4", [&] { return adapt().theta_min.value; }, 4.0},
        {"Flatness", "0.125", [&] { return adapt().flatness.value; }, 0.125},
        {"L max", "0.75", [&] { return adapt().l_max.value; }, 0.75},
        {"Floor", "0.001", [&] { return adapt().floor.value; }, 0.001},
        {"Budget", "123456", [&] { return static_cast<double>(adapt().budget); }, 123456.0},
        {"Per drag", "5000", [&] { return adapt().drag_budget.value; }, 5000.0},
        {"Points Y", "20", [&] { return static_cast<double>(cage().counts().y); }, 20.0},
        {"Middle X", "0.5", [&] { return cage().rest(cage().counts() / 2 + cage().margin).x; },
         0.5},
        {"Size Z", "3", [&] { return cage().cell.z * (cage().counts().z - 1); }, 3.0},
    };
    for (const Typed& typed : numbers) {
        SCOPED_TRACE(typed.name);
        type_into(typed.name, typed.text);
        const double slack = std::string(typed.name) == "Middle X" ? 0.5 : 1e-9;
        EXPECT_NEAR(typed.value(), typed.expected, slack);
        EXPECT_EQ(editor_->workspace().message(), "");
    }
    editor_->use_brush();
    type_into("Radius", "20");
    const double fifth = 0.2 * editor_->workspace().diagonal();
    EXPECT_NEAR(editor_->radius(), fifth, 1e-12 * fifth);
    type_into("Points per axis", "11");
    EXPECT_EQ(editor_->session().lattice_settings().span, 11);
}

TEST_F(PanelsTest, TheButtonCageMakesACageThoughItsSectionHasTheSameName) {
    lay_out();
    const std::vector<Control> all = interface_->controls().all();
    const auto button = std::ranges::find(all.rbegin(), all.rend(), "Cage", &Control::name);
    ASSERT_TRUE(button != all.rend());
    ASSERT_GT(button->min.x, interface_->free_area().max.x) << "that of the panel";
    ASSERT_FALSE(editor_->has_cage());
    click(middle(*button));
    EXPECT_TRUE(editor_->has_cage());
}

TEST_F(PanelsTest, AnglesAreDisabledAndSayWhyWhileTheTriggerAsksForNone) {
    open_advanced();
    using Trigger = command::Adapt::Trigger;
    for (const Trigger trigger : {Trigger::midpoint, Trigger::certified, Trigger::normals}) {
        const bool has_effect = trigger == Trigger::normals;
        editor_->execute(command::Adapt{.trigger = trigger});
        for (const char* name : {"θ max", "θ max mode", "θ min", "θ min mode"}) {
            const Control* const control = find(name);
            ASSERT_TRUE(control) << name;
            EXPECT_EQ(control->is_enabled, has_effect) << name;
        }
        for (const char* name : {"θ max", "θ min"}) {
            const std::string tooltip = find(name)->tooltip;
            EXPECT_EQ(tooltip.find("has no effect now") == std::string::npos, has_effect)
                << tooltip;
        }
        EXPECT_TRUE(find("L max")->is_enabled);
    }
}

TEST_F(PanelsTest, TheDetailIsAToleranceWhereTheTriggerGoesByDistances) {
    using Trigger = command::Adapt::Trigger;
    for (const Trigger trigger : {Trigger::midpoint, Trigger::certified}) {
        editor_->execute(command::Adapt{.trigger = trigger, .tolerance = Setting::automatic()});
        const double theta_max = editor_->session().adapt_settings().theta_max.value;
        type_into("Radius", "20");  // so that the clicks at the detail are the first ones there
        type_into("Detail", "0.0125");
        EXPECT_EQ(editor_->session().adapt_settings().tolerance, Setting::of(0.0125));
        EXPECT_EQ(editor_->session().adapt_settings().theta_max, Setting::of(theta_max));
    }
}

TEST_F(PanelsTest, NumbersBeyondTheLimitsAreRefusedInTheWordsOfTheSchema) {
    open_advanced();
    const AdaptSettings before = editor_->session().adapt_settings();
    const std::vector<std::array<const char*, 3>> refused{
        {"Radius", "0", "Radius must be above 0 %, not 0 %."},
        {"θ max", "0", "θ max must be an angle above 0, not 0."},
        {"θ min", "-3", "θ min must be an angle of at least 0, not -3."},
        {"L max", "-1", "L max must be a length above 0, not -1."},
        {"Floor", "0", "Floor must be a length above 0, not 0."},
        {"Points per axis", "17", "Points per axis must be a whole number from 1 to 16, not 17."},
        {"Points X", "255", "Points X must be a whole number from 1 to 254, not 255."},
        {"Radius", "-2", "Radius must be above 0 %, not -2 %."},
    };
    for (const auto& [name, text, message] : refused) {
        SCOPED_TRACE(name);
        type_into(name, text);
        EXPECT_TRUE(editor_->workspace().message().starts_with(message))
            << editor_->workspace().message();
        EXPECT_TRUE(editor_->workspace().message_warns());
        editor_->workspace().dismiss();
    }
    editor_->set_radius_unit(RadiusUnit::model);
    // A click soon after others would not be the first of a double click.
    std::this_thread::sleep_for(std::chrono::milliseconds(320));
    type_into("Radius", "-2");
    EXPECT_EQ(editor_->workspace().message(), "Radius must be a length above 0, not -2.");
    editor_->set_radius_unit(RadiusUnit::share);
    EXPECT_EQ(editor_->session().adapt_settings(), before);
    EXPECT_EQ(editor_->session().lattice_settings().span, 3);
    editor_->use_cage();
    const auto cage = editor_->session().lattice_settings().cage;
    type_into("Size Z", "-2");
    EXPECT_TRUE(editor_->workspace().message().starts_with("Size"))
        << editor_->workspace().message();
    EXPECT_EQ(editor_->session().lattice_settings().cage, cage);
}

TEST_F(PanelsTest, EscapeLeavesATypedNumberAsItWas) {
    const Vec2 at = reach("Radius");
    const double before = editor_->radius();
    click(at);
    click(at);
    type("0.77");
    press_key(Key::escape);
    lay_out();
    EXPECT_EQ(editor_->radius(), before);
}

TEST_F(PanelsTest, ADragOfANumberIsRelativeAndAClickChangesNothing) {
    const double before = editor_->radius();
    click("Radius");
    EXPECT_EQ(editor_->radius(), before);
    drag_control("Radius", 30.0);
    const double larger = editor_->radius();
    EXPECT_GT(larger, 1.2 * before);
    drag_control("Radius", -30.0);
    EXPECT_NEAR(editor_->radius(), before, 0.02 * before) << "rounded to what is shown";
    drag_control("Radius", 5000.0);
    EXPECT_NEAR(editor_->radius(), editor_->max_radius(), 0.01 * editor_->max_radius());
}

// --- Detail.

TEST_F(PanelsTest, TheDetailSetsThetaMaxAndThetaMinFollows) {
    editor_->execute(command::Adapt{.theta_min = Setting::of(11.0)});
    type_into("Detail", "9");
    EXPECT_EQ(editor_->session().adapt_settings().theta_max, Setting::of(9.0));
    EXPECT_EQ(editor_->session().adapt_settings().theta_min, Setting::automatic());
    editor_->execute(command::Adapt{.theta_min = Setting::of(0.0)});
    type_into("Detail", "30");
    EXPECT_EQ(editor_->session().adapt_settings().theta_min, Setting::of(0.0))
        << "nothing is merged, whatever the detail";
    const double coarse = editor_->session().adapt_settings().theta_max.value;
    drag_control("Detail", 40.0);
    EXPECT_LT(editor_->session().adapt_settings().theta_max.value, coarse) << "finer to the right";
}

TEST_F(PanelsTest, TheEdgesThatADetailWouldSplitAreShownWhileItIsDragged) {
    drag(*editor_, kMiddle, kMiddle + Vec2{80, -120});
    const Vec2 from = reach("Detail");
    give(event::MouseMove{from});
    give(event::Press{MouseButton::left, from});
    EXPECT_FALSE(editor_->detail_preview.is_active());
    give(event::MouseMove{from + Vec2{60, 0}});
    lay_out();
    ASSERT_TRUE(editor_->detail_preview.is_active());
    EXPECT_TRUE(editor_->has_unfinished_frame());
    while (editor_->has_unfinished_frame()) editor_->advance();
    Overlay overlay;
    editor_->detail_preview.add_to(overlay);
    EXPECT_GT(overlay.lines.size(), 20u);
    EXPECT_EQ(overlay.lines.size(), editor_->detail_preview.count());
    give(event::Release{MouseButton::left, from + Vec2{60, 0}});
    lay_out();
    EXPECT_FALSE(editor_->detail_preview.is_active());
    const std::size_t steps = editor_->session().undo_count();
    EXPECT_EQ(steps, 1u) << "the object has not changed";
}

// --- Cage.

TEST_F(PanelsTest, InTheModeOfTheCageTheControlsOfTheBrushAreDisabled) {
    for (const char* name : {"Radius", "Points per axis"}) EXPECT_TRUE(find(name)->is_enabled);
    click("Cage");
    ASSERT_TRUE(editor_->session().lattice_settings().cage);
    for (const char* name : {"Radius", "Points per axis"}) EXPECT_FALSE(find(name)->is_enabled);
    const Lattice cage = *editor_->session().lattice_settings().cage;
    drag_control("Radius", 40.0);
    type("[");
    EXPECT_EQ(editor_->session().lattice_settings().cage, cage);
    click("Sculpt");
    EXPECT_FALSE(editor_->session().lattice_settings().cage);
    EXPECT_TRUE(find("Radius")->is_enabled);
}

TEST_F(PanelsTest, TheToolsOfTheStripExcludeEachOther) {
    const auto is_on = [this](Action action) { return info_of(action).is_on(*editor_); };
    const std::vector<std::pair<const char*, Action>> tools{
        {"Cage", Action::use_cage}, {"Pin", Action::toggle_pinning}, {"Sculpt", Action::use_brush}};
    EXPECT_TRUE(is_on(Action::use_brush));
    for (const auto& [name, chosen] : tools) {
        click(name);
        for (const auto& [other, action] : tools)
            EXPECT_EQ(is_on(action), action == chosen) << other;
    }
}

// --- Hiding the panels, theme and scale.

TEST_F(PanelsTest, TabHidesThePanelsAndGivesTheirPlaceToTheObject) {
    const auto before = interface_->free_area();
    press_key(Key::tab);
    lay_out();
    EXPECT_TRUE(editor_->preferences.hides_panels);
    const auto& free = interface_->free_area();
    EXPECT_EQ(free.min.x, 0.0);
    EXPECT_EQ(free.max.x, size_.x);
    EXPECT_EQ(free.min.y, before.min.y);
    EXPECT_TRUE(interface_->controls().all().empty());
    press_key(Key::tab);
    lay_out();
    EXPECT_EQ(interface_->free_area().max.x, before.max.x);
}

TEST_F(PanelsTest, KeysMakeTextLargerSmallerAndNormalAgain) {
    const float normal = ImGui::GetFontSize();
    const int version = interface_->font_version();
    press_key(Key{'='}, {.control = true});
    press_key(Key{'='}, {.shift = true, .control = true});
    EXPECT_GT(ImGui::GetFontSize(), 1.15f * normal);
    EXPECT_GT(interface_->font_version(), version);
    press_key(Key{'0'}, {.control = true});
    EXPECT_EQ(ImGui::GetFontSize(), normal);
    press_key(Key{'-'}, {.control = true});
    EXPECT_LT(ImGui::GetFontSize(), normal);
}

TEST_F(PanelsTest, TheThemeChangesTheColoursOfPanelsAndPicture) {
    const auto lightness = [] { return ImGui::GetStyleColorVec4(ImGuiCol_WindowBg).y; };
    EXPECT_LT(lightness(), 0.3f);
    editor_->perform(Action::toggle_light_theme);
    lay_out();
    EXPECT_GT(lightness(), 0.7f);
    EXPECT_GT(editor_scene(*editor_, 1.0f).background.top.y, 0.7f);
    editor_->perform(Action::toggle_light_theme);
    lay_out();
    EXPECT_LT(lightness(), 0.3f);
}

TEST_F(PanelsTest, LettersOfMathematicsHaveGlyphs) {
    const ImFont& font = *ImGui::GetFont();
    for (const int letter : {0x3B8, 0x2212, 0xB0, 0xD7, 0xB7, 0x2026, 0x2264}) {
        EXPECT_TRUE(font.FindGlyphNoFallback(static_cast<ImWchar>(letter))) << std::hex << letter;
    }
}

}  // namespace
}  // namespace pectin
