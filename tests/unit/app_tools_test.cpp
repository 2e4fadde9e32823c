// How an Editor passes input to its tools and to navigation, and what the tools show.
#include "app/tools/tool.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "app/editor_scene.h"
#include "app/tools/pin_tool.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

// Writes down what it is asked.
class Recording : public Tool {
  public:
    Recording(std::string name, std::string& log) : name_(std::move(name)), log_(log) {}

    bool hover(const ToolContext&, bool is_free) override {
        if (is_free && takes_hover) log_ += name_ + ".hover ";
        return is_free && takes_hover;
    }
    bool press(ToolContext&, MouseButton) override {
        log_ += name_ + ".press ";
        if (throws_bad_alloc) throw std::bad_alloc();
        if (throws) throw std::runtime_error("it is broken");
        is_active_ = takes_press;
        return takes_press;
    }
    bool key(ToolContext&, const event::KeyDown&) override {
        log_ += name_ + ".key ";
        return takes_key;
    }
    bool scroll(ToolContext&, double) override {
        log_ += name_ + ".scroll ";
        return takes_scroll;
    }
    bool escape(ToolContext&) override {
        log_ += name_ + ".escape ";
        return takes_escape;
    }
    bool is_active() const override { return is_active_; }
    void move(ToolContext&) override { log_ += name_ + ".move "; }
    void release(ToolContext&, MouseButton) override {
        log_ += name_ + ".release ";
        is_active_ = false;
    }
    void key_up(ToolContext&, Key) override { log_ += name_ + ".key_up "; }
    void advance(ToolContext&) override {
        log_ += name_ + ".advance ";
        if (throws) throw std::runtime_error("it is broken");
    }
    void cancel(ToolContext&) noexcept override {
        is_cancelled = true;
        is_active_ = false;
    }
    std::string_view status_hint(const ToolContext&) const override { return hint; }

    bool takes_hover = false, takes_press = false, takes_key = false, takes_scroll = false,
         takes_escape = false;
    bool throws = false, throws_bad_alloc = false, is_cancelled = false;
    std::string hint;

  private:
    std::string name_;
    std::string& log_;
    bool is_active_ = false;
};

// An editor with two such tools.
class ToolRoutingTest : public testing::Test {
  protected:
    ToolRoutingTest() : editor_({}, std::chrono::hours(1), tools()) {
        editor_.handle(event::Resize{kSize});
        editor_.document().new_shape(command::Shape::Kind::sphere, 3);
        editor_.handle(event::MouseMove{kMiddle});
        log_.clear();
    }
    Tools tools() {
        Tools made;
        for (const char* name : {"first", "second"}) {
            auto tool = std::make_unique<Recording>(name, log_);
            (made.empty() ? first_ : second_) = tool.get();
            made.push_back(std::move(tool));
        }
        return made;
    }
    // What the tools were asked since the last call.
    std::string asked() { return std::exchange(log_, {}); }
    void press(MouseButton button = MouseButton::left, const UiClaims& claims = {}) {
        editor_.handle(event::Press{button, kMiddle}, claims);
    }
    void move() { editor_.handle(event::MouseMove{kMiddle + Vec2(30, 20)}); }

    std::string log_;
    Recording* first_ = nullptr;
    Recording* second_ = nullptr;
    Editor editor_;
};

TEST_F(ToolRoutingTest, WhatNoToolTakesGoesToNavigation) {
    const Camera before = editor_.camera();
    press();
    EXPECT_EQ(asked(), "first.press second.press ");
    move();
    EXPECT_NE(editor_.camera(), before);
    const Camera turned = editor_.camera();
    editor_.handle(event::Release{MouseButton::left, kMiddle});
    editor_.handle(event::Scroll{1.0, kMiddle});
    EXPECT_EQ(asked(), "first.scroll second.scroll ");
    EXPECT_NE(editor_.camera(), turned);
    editor_.handle(event::KeyDown{Key{'W'}});
    EXPECT_EQ(asked(), "first.key second.key ");
    EXPECT_TRUE(editor_.display.wireframe) << "a key that no tool takes is an action";
}

TEST_F(ToolRoutingTest, TheFirstToolThatTakesAnEventHidesItFromTheRest) {
    const Camera before = editor_.camera();
    first_->takes_key = first_->takes_scroll = first_->takes_press = true;
    editor_.handle(event::KeyDown{Key{'W'}});
    EXPECT_FALSE(editor_.display.wireframe);
    editor_.handle(event::Scroll{1.0, kMiddle});
    press();
    EXPECT_EQ(asked(), "first.key first.scroll first.press ");
    move();
    EXPECT_EQ(editor_.camera(), before);
}

TEST_F(ToolRoutingTest, AnActiveToolAloneGetsAllEvents) {
    second_->takes_press = true;
    press();
    asked();
    const Camera before = editor_.camera();
    move();
    press(MouseButton::right, {.mouse = true});
    editor_.handle(event::Scroll{1.0, kMiddle}, {.mouse = true});
    editor_.handle(event::KeyDown{Key{'W'}});
    editor_.handle(event::KeyUp{Key{'W'}});
    editor_.advance();
    editor_.handle(event::Release{MouseButton::left, kMiddle});
    EXPECT_EQ(asked(),
              "second.move second.press second.scroll second.key second.key_up second.advance "
              "second.release ");
    EXPECT_EQ(editor_.camera(), before);
    EXPECT_FALSE(editor_.display.wireframe) << "there are no actions during a gesture";
    editor_.perform(Action::toggle_wireframe);
    EXPECT_TRUE(editor_.display.wireframe) << "the gesture has ended";
}

TEST_F(ToolRoutingTest, InputOfPanelsAndOfNavigationDoesNotReachTheTools) {
    press(MouseButton::left, {.mouse = true});
    editor_.handle(event::Scroll{1.0, kMiddle}, {.mouse = true});
    editor_.handle(event::KeyDown{Key{'W'}}, {.keyboard = true});
    EXPECT_EQ(asked(), "");
    press();
    asked();
    press(MouseButton::right);
    editor_.handle(event::KeyDown{Key{'F'}});
    EXPECT_EQ(asked(), "") << "navigation is active";
}

TEST_F(ToolRoutingTest, ToolsGetNothingDuringWorkInTheBackground) {
    editor_.execute(command::Drag{.moves = {{Vec3(0, 0, 1), Vec3(0, 0, 1.2)}}});
    editor_.workspace().set_max_edit_time(std::chrono::milliseconds(0));
    first_->takes_press = true;
    press();
    asked();
    // The tool ends its drag, and this goes on in the background.
    for (int i = 0; i < 1000 && !editor_.is_working(); ++i) {  // some end at once
        editor_.workspace().execute(i % 2 == 0 ? Command{command::Undo{}} : command::Redo{});
    }
    ASSERT_TRUE(editor_.is_working());
    move();
    press();
    editor_.handle(event::Scroll{1.0, kMiddle});
    editor_.handle(event::KeyDown{Key{'W'}});
    editor_.handle(event::KeyUp{Key{'W'}});
    editor_.handle(event::Release{MouseButton::left, kMiddle});
    EXPECT_EQ(asked(), "");
    while (editor_.is_working()) editor_.advance();
}

TEST_F(ToolRoutingTest, OnlyOneToolTakesTheCursor) {
    editor_.advance();
    EXPECT_TRUE(editor_.hover());
    first_->takes_hover = second_->takes_hover = true;
    editor_.advance();
    EXPECT_EQ(asked(), "first.hover ");
    EXPECT_FALSE(editor_.hover()) << "the tool shows something else there";
    editor_.handle(event::Leave{});
    editor_.advance();
    EXPECT_EQ(asked(), "") << "the cursor has left the viewport";
}

TEST_F(ToolRoutingTest, EscapeCancelsTheGestureAndLaterAsksTheLastToolFirst) {
    first_->takes_press = second_->takes_escape = true;
    press();
    asked();
    editor_.handle(event::KeyDown{Key::escape});
    EXPECT_TRUE(first_->is_cancelled);
    EXPECT_EQ(asked(), "");
    editor_.handle(event::KeyDown{Key::escape});
    EXPECT_EQ(asked(), "second.escape ");
    second_->takes_escape = false;
    editor_.handle(event::KeyDown{Key::escape});
    EXPECT_EQ(asked(), "second.escape first.escape ");
}

TEST_F(ToolRoutingTest, AToolThatThrowsIsCancelledWithAMessage) {
    first_->takes_press = true;
    press();
    first_->throws = true;
    editor_.advance();
    EXPECT_TRUE(first_->is_cancelled);
    EXPECT_EQ(editor_.workspace().message(), "The drag was cancelled: it is broken");
    first_->throws = false;
    first_->throws_bad_alloc = true;
    const Camera before = editor_.camera();
    press();
    EXPECT_NE(editor_.workspace().message().find("memory"), std::string::npos);
    move();
    EXPECT_EQ(editor_.camera(), before) << "a press that has failed does not navigate";
}

TEST_F(ToolRoutingTest, TheHintIsThatOfTheActiveToolOrOfTheFirstThatHasOne) {
    EXPECT_NE(editor_.status_hint().find("rotate the view"), std::string::npos);
    second_->hint = "The second.";
    EXPECT_EQ(editor_.status_hint(), "The second.");
    first_->hint = "The first.";
    EXPECT_EQ(editor_.status_hint(), "The first.");
    second_->takes_press = true;
    press();
    EXPECT_EQ(editor_.status_hint(), "The second.");
    editor_.handle(event::KeyDown{Key::escape});
    editor_.handle(event::Leave{});
    EXPECT_EQ(editor_.status_hint(), "");
}

// --- The tools of the program.

using ToolsTest = EditorTest;

TEST_F(ToolsTest, HintsDependOnTheModifiersAndOnWhatIsUnderTheCursor) {
    auto editor = this->editor();
    const auto hint = [&](const Vec2& at, Modifiers modifiers = {}) {
        move(editor, at, modifiers);
        return std::string(editor.status_hint());
    };
    std::vector<std::string> hints{hint(kMiddle), hint(kMiddle, {.alt = true}), hint(kBeside),
                                   hint(kBeside, {.shift = true})};
    press(editor, kMiddle);
    for (const Modifiers modifiers :
         {Modifiers{}, Modifiers{.alt = true}, Modifiers{.shift = true}})
        hints.push_back(hint(kMiddle + Vec2(9, 9), modifiers));
    key(editor, Key::escape);
    move(editor, kMiddle);
    editor.handle(event::KeyDown{Key{'F'}});
    hints.push_back(hint(kMiddle));
    key(editor, Key::escape);
    editor.sets_pins = true;
    hints.push_back(hint(kMiddle));
    editor.sets_pins = false;
    editor.set_cage(editor.workspace().box(), IVec3{3});
    editor.display.lattice = true;
    editor.advance();
    const Vec2 corner =
        *editor.camera().project(editor.editable_cage()->rest(IVec3{3, 3, 3}), kSize);
    hints.insert(hints.end(),
                 {hint(corner), hint(corner, {.shift = true}), hint(corner, {.control = true})});
    press(editor, kBeside, {.control = true});
    hints.push_back(hint(kMiddle, {.control = true}));
    for (const std::string& text : hints) {
        EXPECT_TRUE(text.ends_with('.')) << text;
        EXPECT_EQ(std::ranges::count(text, '.'), 1) << text;
        EXPECT_EQ(std::ranges::count(hints, text), 1) << text;
    }
    EXPECT_EQ(hints.size(), 13u);
}

TEST_F(ToolsTest, NoToolTakesAKeyOfAnAction) {
    auto editor = this->editor();
    for (const ActionInfo& info : all_actions()) {
        for (const Shortcut& shortcut : info.shortcuts) {
            for (const auto& tool : editor.tools()) {
                EXPECT_FALSE(tool->key(editor, {shortcut.key, shortcut.modifiers})) << info.name;
            }
        }
    }
}

TEST_F(ToolsTest, EscapeEndsTheSettingOfPinsBeforeItClearsASelection) {
    auto editor = this->editor();
    editor.set_cage(editor.workspace().box(), IVec3{3});
    editor.display.lattice = true;
    editor.sets_pins = true;
    drag(editor, {0, 0}, Vec2(kSize), {.control = true});
    ASSERT_FALSE(test::cage_points(editor).selected().empty());
    key(editor, Key::escape);
    EXPECT_FALSE(editor.sets_pins);
    EXPECT_FALSE(test::cage_points(editor).selected().empty());
    key(editor, Key::escape);
    EXPECT_TRUE(test::cage_points(editor).selected().empty());
}

TEST_F(ToolsTest, AClickKeepsTheRadiusThatIsBeingSetAndAnotherButtonRestoresIt) {
    auto editor = this->editor();
    const double before = editor.radius();
    for (const MouseButton button : {MouseButton::right, MouseButton::left}) {
        move(editor, kMiddle);
        editor.handle(event::KeyDown{Key{'F'}});
        move(editor, kMiddle + Vec2(160, 0));
        EXPECT_TRUE(editor.is_setting_radius());
        EXPECT_NEAR(editor.radius(), 2.0 * before, 1e-9);
        editor.handle(event::Press{button, kMiddle + Vec2(160, 0)}, {.mouse = true});
        EXPECT_FALSE(editor.is_setting_radius());
        const bool keeps = button == MouseButton::left;
        EXPECT_NEAR(editor.radius(), (keeps ? 2.0 : 1.0) * before, 1e-9);
        editor.handle(event::KeyUp{Key{'F'}});
        EXPECT_NEAR(editor.radius(), (keeps ? 2.0 : 1.0) * before, 1e-9);
    }
}

TEST_F(ToolsTest, EachToolDrawsWhatItIsAbout) {
    auto editor = this->editor();
    const auto overlay = [&] {
        editor.advance();
        return editor_scene(editor, 1.0f).overlay;
    };
    const auto has_colour = [](const Overlay& drawn, const Colour& colour) {
        return std::ranges::any_of(drawn.lines, [&](const auto& l) { return l.colour == colour; });
    };
    const Colour circle{255, 255, 255, 190}, circle_being_set{255, 214, 64, 255};
    EXPECT_TRUE(overlay().is_empty());
    move(editor, kMiddle);
    EXPECT_TRUE(has_colour(overlay(), circle));
    editor.handle(event::KeyDown{Key{'F'}});
    EXPECT_TRUE(has_colour(overlay(), circle_being_set));
    EXPECT_FALSE(has_colour(overlay(), circle));
    key(editor, Key::escape);
    key(editor, Key{'P'});
    move(editor, kBeside);
    EXPECT_EQ(overlay().points.size(), 1u) << "the pin";
    key(editor, Key{'P'});
    move(editor, kMiddle);
    key(editor, Key{'P'});
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(40, -30));
    EXPECT_FALSE(has_colour(overlay(), circle)) << "during a drag";
    EXPECT_GT(overlay().lines.size(), 20u) << "the lattice of the drag";
    key(editor, Key::escape);
    editor.set_cage(editor.workspace().box(), IVec3{3});
    move(editor, kBeside);
    EXPECT_TRUE(overlay().is_empty()) << "the cage is not shown";
    editor.display.lattice = true;
    EXPECT_GT(overlay().points.size(), 100u) << "the control points";
}

TEST_F(ToolsTest, TheSettingsOfAllToolsAreShown) {
    const ShownSettings all{.radius = true,
                            .mirror = true,
                            .connected = true,
                            .fold_free = true,
                            .pins = true,
                            .cage = true};
    EXPECT_EQ(editor().shown_settings(), all);
    Tools some;
    some.push_back(std::make_unique<PinTool>());
    some.push_back(std::make_unique<CageTool>());
    const Editor editor({}, std::chrono::hours(1), std::move(some));
    EXPECT_EQ(editor.shown_settings(), (ShownSettings{.mirror = true, .pins = true, .cage = true}));
}

}  // namespace
}  // namespace pectin
