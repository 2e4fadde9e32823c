// Tests how input reaches panels and dialogs if there are many events between two frames. The
// panels are laid out without a window, and nothing is drawn.
#include "app/ui/interface.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <memory>
#include <thread>

#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

constexpr Modifiers kControl{.control = true};
constexpr Modifiers kControlShift{.shift = true, .control = true};

class InterfaceTest : public EditorTest {
  protected:
    void SetUp() override {
        editor_.reset(new PreparedEditor(editor()));  // made in its place
        interface_.set_size(kSize, kSize);
        interface_.lay_out(*editor_, {});
    }

    // All of these are sent between the same two frames.
    void give(const InputEvent& input) { interface_.handle(*editor_, input); }
    void press_key(Key key, Modifiers modifiers = {}) {
        give(event::KeyDown{key, modifiers});
        give(event::KeyUp{key});
    }
    void type(const std::string& text) {
        for (const char c : text) {
            const int capital = std::toupper(static_cast<unsigned char>(c));
            give(event::KeyDown{Key{capital}});
            give(event::Character{static_cast<unsigned char>(c)});
            give(event::KeyUp{Key{capital}});
        }
    }
    void click(const Vec2& at) {
        give(event::MouseMove{at});
        give(event::Press{MouseButton::left, at});
        give(event::Release{MouseButton::left, at});
    }

    std::unique_ptr<PreparedEditor> editor_;
    std::string clipboard_;
    Interface interface_{1.0f,
                         {.read = [this] { return clipboard_; },
                          .write = [this](const std::string& text) { clipboard_ = text; }}};
};

TEST_F(InterfaceTest, EnterAcceptsThePathThatWasTypedBeforeItInTheSameFrame) {
    press_key(Key{'S'}, kControlShift);
    type(path("typed.obj"));
    press_key(Key::enter);
    EXPECT_FALSE(editor_->document().browser());
    EXPECT_TRUE(fs::exists(path("typed.obj"))) << editor_->workspace().message();
    EXPECT_EQ(editor_->workspace().path(), path("typed.obj"));
}

TEST_F(InterfaceTest, ASequenceOfDialogsAndKeysIsHandledWithinOneFrame) {
    fs::create_directory(path("models"));
    write("models/wedge.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    press_key(Key{'O'}, kControl);
    type(path("models"));  // a folder, which the dialog opens first
    press_key(Key::enter);
    ASSERT_TRUE(editor_->document().browser());
    EXPECT_EQ(editor_->document().browser()->folder(), path("models"));
    type("wedge.obj");
    EXPECT_EQ(editor_->document().browser()->name, "wedge.obj");
    press_key(Key::enter);
    EXPECT_EQ(editor_->workspace().path(), path("models/wedge.obj"));
    EXPECT_EQ(editor_->session().mesh().face_count(), 4u);
    press_key(Key{'S'}, kControlShift);
    type(path("copy.obj"));
    press_key(Key::enter);
    EXPECT_TRUE(fs::exists(path("copy.obj")));
}

TEST_F(InterfaceTest, EnterAnswersTheQuestionThatThePreviousKeyHasOpened) {
    press_key(Key{'S'}, kControlShift);
    type(path("ball.obj"));
    press_key(Key::enter);
    drag(*editor_, kMiddle, kMiddle + Vec2{60, -40});
    ASSERT_TRUE(editor_->workspace().is_modified());
    const std::string before = read("ball.obj");
    press_key(Key{'Q'}, kControl);
    press_key(Key::enter);  // Save
    EXPECT_TRUE(editor_->document().wants_to_end());
    EXPECT_NE(read("ball.obj"), before);
}

TEST_F(InterfaceTest, TextFieldsAllowEditingCopyingAndPasting) {
    press_key(Key{'S'}, kControlShift);
    type("abc");
    press_key(Key::backspace);
    EXPECT_EQ(editor_->document().browser()->name, "ab");
    press_key(Key::home);
    type("x");
    EXPECT_EQ(editor_->document().browser()->name, "xab");
    press_key(Key{'A'}, kControl);
    press_key(Key{'C'}, kControl);
    EXPECT_EQ(clipboard_, "xab");
    clipboard_ = "pasted";
    press_key(Key{'V'}, kControl);
    EXPECT_EQ(editor_->document().browser()->name, "pasted");
    press_key(Key::escape);
    EXPECT_FALSE(editor_->document().browser());
}

TEST_F(InterfaceTest, LettersTypedIntoAFieldDoNotActAsShortcuts) {
    const bool wireframe = editor_->display.wireframe;
    press_key(Key{'S'}, kControlShift);
    type("w");
    press_key(Key::escape);
    EXPECT_EQ(editor_->display.wireframe, wireframe);
    type("w");
    EXPECT_NE(editor_->display.wireframe, wireframe);
}

// A press opens the menu, and the mouse then moves to its entry.
TEST_F(InterfaceTest, AMenuAndItsEntryCanBeClickedInOneFrame) {
    const bool wireframe = editor_->display.wireframe;
    for (float y = 30.0f; y < 300.0f && editor_->display.wireframe == wireframe; y += 12.0f) {
        click({105, 12});  // View
        click({130, y});
        press_key(Key::escape);
    }
    EXPECT_NE(editor_->display.wireframe, wireframe);
}

// After a slow frame, the whole drag of a number is handled at once.
TEST_F(InterfaceTest, ANumberFollowsADragThatEndedBeforeTheNextFrame) {
    const Control* const radius = interface_.controls().find("Radius");
    ASSERT_TRUE(radius);
    const Vec2 at = 0.5 * (radius->min + radius->max);
    const double before = editor_->radius();
    give(event::MouseMove{at});
    give(event::Press{MouseButton::left, at});
    give(event::MouseMove{at - Vec2{25, 0}});
    give(event::Release{MouseButton::left, at - Vec2{25, 0}});
    give(event::MouseMove{{600, 700}});
    EXPECT_LT(editor_->radius(), before);
}

// The section of the cage has a checkbox of its own for showing the cage, and both act.
TEST_F(InterfaceTest, BothCheckboxesOfTheLatticeSwitchIt) {
    give(event::Resize{{1280, 1600}});  // nothing has to be scrolled
    editor_->set_cage(editor_->workspace().box(), IVec3{4});
    for (int i = 0; i < 3; ++i) interface_.lay_out(*editor_, {});
    std::vector<Vec2> checkboxes;
    for (const Control& control : interface_.controls().all()) {
        if (control.name == info_of(Action::toggle_lattice).name) {
            checkboxes.push_back(control.min + Vec2{10, 10});
        }
    }
    ASSERT_EQ(checkboxes.size(), 2u);
    for (const Vec2& at : checkboxes) {
        editor_->display.lattice = false;
        for (int i = 0; i < 3; ++i) interface_.lay_out(*editor_, {});
        click(at);
        EXPECT_TRUE(editor_->display.lattice) << at.y;
    }
}

TEST_F(InterfaceTest, AClickBesideThePanelsReachesTheObject) {
    drag(*editor_, kMiddle, kMiddle);  // dismisses the hint
    const std::size_t steps = editor_->session().undo_count();
    give(event::MouseMove{kMiddle});
    give(event::Press{MouseButton::left, kMiddle});
    give(event::MouseMove{kMiddle + Vec2{50, -30}});
    give(event::Release{MouseButton::left, kMiddle + Vec2{50, -30}});
    EXPECT_EQ(editor_->session().undo_count(), steps + 1);
}

TEST_F(InterfaceTest, WhatIsBehindADialogIsDimmedAtOnce) {
    const auto dimmed = [] { return ImGui::GetCurrentContext()->DimBgRatio; };
    EXPECT_EQ(dimmed(), 0.0f);
    press_key(Key::f1);
    interface_.lay_out(*editor_, {});
    EXPECT_EQ(dimmed(), 1.0f);
    press_key(Key::escape);
    interface_.lay_out(*editor_, {});
    EXPECT_EQ(dimmed(), 0.0f);
}

TEST_F(InterfaceTest, TheCursorShapeDiffersOverTextFieldsAndButtons) {
    EXPECT_EQ(interface_.cursor_shape(), CursorShape::arrow);
    press_key(Key{'O'}, kControl);
    bool found = false;
    for (double y = 540; y < 660 && !found; y += 6) {
        give(event::MouseMove{{600, y}});
        interface_.lay_out(*editor_, {});
        found = interface_.cursor_shape() == CursorShape::text;
    }
    EXPECT_TRUE(found);
}

TEST_F(InterfaceTest, AKeyHeldWhenTheWindowLosesTheFocusIsReleased) {
    press_key(Key{'S'}, kControlShift);
    type("kept");
    give(event::KeyDown{Key::backspace});
    give(event::Focus{false});
    std::this_thread::sleep_for(
        std::chrono::milliseconds(600));  // longer than the delay until keys repeat
    for (int i = 0; i < 3; ++i) interface_.lay_out(*editor_, {});
    EXPECT_EQ(editor_->document().browser()->name, "kep");
}

}  // namespace
}  // namespace pectin
