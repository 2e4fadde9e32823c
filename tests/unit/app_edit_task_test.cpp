// Edits that continue in the background: ends of drags, undo, redo and readapting.
#include <gtest/gtest.h>

#include <thread>

#include "app/ui/interface.h"
#include "app_editor_fixture.h"
#include "io/obj_writer.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;

class EditTaskTest : public EditorTest {
  protected:
    // An editor in which every edit continues in the background. What a drag refines by so small an
    // angle takes far longer than some frames.
    PreparedEditor background_editor(double theta_max = 0.4,
                                     std::optional<Recorder> recorder = {}) const {
        return prepared_editor(std::move(recorder), 5, [&](Editor& made) {
            made.workspace().set_max_edit_time(0ms);
            // Frames stop soon; only the end of the drag does everything.
            made.workspace().set_frame_time(0ms);
            made.execute(
                command::Adapt{.theta_max = Setting::of(theta_max), .drag_budget = Setting::off()});
        });
    }
    static bool is_in_progress(const Editor& editor) {
        return editor.workspace().edit_task() != nullptr;
    }
    static void wait(Editor& editor) {
        while (is_in_progress(editor)) {
            editor.advance();
            std::this_thread::sleep_for(1ms);
        }
    }
    static void press_and_move(Editor& editor) {
        press(editor, kMiddle);
        move(editor, kMiddle + Vec2(90, -120));
    }
    static void release(Editor& editor) {
        editor.handle(event::Release{MouseButton::left, kMiddle + Vec2(90, -120), {}});
    }
    // Input of all kinds except cancelling and quitting.
    static void fumble(Editor& editor) {
        drag(editor, kMiddle, kMiddle + Vec2(30, 30));
        key(editor, Key{'Z'}, {.control = true});
        key(editor, Key{'F'});
        key(editor, Key::enter);
        editor.handle(event::Scroll{3.0, kMiddle});
        editor.handle(event::Character{']'});
        editor.handle(event::Resize{{900, 700}});
        editor.perform(Action::undo);
        editor.perform(Action::frame_all);
        editor.document().new_shape(command::Shape::Kind::cube, 2);
        editor.set_radius(0.123);
        EXPECT_FALSE(editor.execute(command::Readapt{}));
        EXPECT_EQ(editor.workspace().execute(command::Undo{}), Workspace::Outcome::failed);
    }
};

TEST_F(EditTaskTest, TheEndOfADragGivesTheSameAsInTheForeground) {
    auto background = background_editor(4.0, Recorder(path("record.jsonl")));
    auto foreground = background_editor(4.0);
    foreground.workspace().set_max_edit_time(1h);
    for (Editor* editor : {&background, &foreground}) {
        press_and_move(*editor);
        release(*editor);
    }
    EXPECT_FALSE(is_in_progress(foreground));
    ASSERT_TRUE(is_in_progress(background));
    EXPECT_TRUE(background.has_dialog());
    wait(background);
    EXPECT_FALSE(background.has_dialog());
    EXPECT_GT(background.session().statistics().last.splits, 1000u);
    EXPECT_TRUE(background.session().mesh() == foreground.session().mesh());
    EXPECT_TRUE(background.workspace().is_modified());
    EXPECT_TRUE(replayed("record.jsonl").mesh() == foreground.session().mesh());
}

TEST_F(EditTaskTest, UndoRedoAndReadaptDoTheSameAsInTheForeground) {
    auto editor = background_editor(6.0);
    const TriMesh before = editor.session().mesh();
    press_and_move(editor);
    release(editor);
    wait(editor);
    const TriMesh after = editor.session().mesh();
    editor.perform(Action::undo);
    wait(editor);
    EXPECT_TRUE(editor.session().mesh() == before);
    editor.perform(Action::redo);
    wait(editor);
    EXPECT_TRUE(editor.session().mesh() == after);
    editor.execute(command::Readapt{});
    wait(editor);
    EXPECT_EQ(editor.session().mesh().validate(), std::vector<std::string>{});
    EXPECT_EQ(editor.session().statistics().needing_refinement, 0u);
}

TEST_F(EditTaskTest, NoInputDisturbsIt) {
    const double theta_max = test::is_sanitized() ? 2.0 : 0.4;
    auto alone = background_editor(theta_max), disturbed = background_editor(theta_max);
    for (Editor* editor : {&alone, &disturbed}) {
        press_and_move(*editor);
        release(*editor);
        ASSERT_TRUE(is_in_progress(*editor));
    }
    fumble(disturbed);
    wait(alone);
    wait(disturbed);
    EXPECT_TRUE(alone.session().mesh() == disturbed.session().mesh());
    EXPECT_EQ(disturbed.session().undo_count(), 1u);
}

// Esc during the end of a drag that takes seconds. Meanwhile the window is laid out again and
// again.
TEST_F(EditTaskTest, EscapeGivesTheObjectBackWhileTheWindowIsRedrawn) {
    Interface interface(1.0f, {});
    auto editor = background_editor(0.05);
    interface.set_size(kSize, kSize);
    const TriMesh before = editor.session().mesh();
    const std::string text = format_obj(before);
    press_and_move(editor);
    release(editor);
    constexpr int kFrames = 40;
    int frames = 0;
    for (; frames < kFrames && is_in_progress(editor); ++frames) {
        editor.advance();
        interface.lay_out(editor, {});
    }
    ASSERT_EQ(frames, kFrames) << "it had ended before the window was redrawn so often";
    interface.handle(editor, event::KeyDown{Key::escape, {}});
    EXPECT_TRUE(editor.workspace().edit_task()->is_cancelled());
    while (is_in_progress(editor)) {
        editor.advance();
        interface.lay_out(editor, {});
    }
    EXPECT_TRUE(editor.session().mesh() == before);
    EXPECT_EQ(format_obj(editor.session().mesh()), text);
    EXPECT_EQ(editor.session().undo_count(), 0u);
    EXPECT_FALSE(editor.workspace().is_modified());
    EXPECT_EQ(editor.workspace().message(), "");
    EXPECT_FALSE(test::sculptor(editor).is_dragging());
    // The next drag works as ever.
    editor.execute(command::Adapt{.theta_max = Setting::of(20.0)});
    press_and_move(editor);
    release(editor);
    wait(editor);
    EXPECT_EQ(editor.session().undo_count(), 1u);
    editor.perform(Action::undo);
    wait(editor);
    EXPECT_TRUE(editor.session().mesh() == before);
}

TEST_F(EditTaskTest, CancellingUndoRedoAndReadaptGivesBackWhatWasThere) {
    auto editor = background_editor(6.0);
    press_and_move(editor);
    release(editor);
    wait(editor);
    const TriMesh dragged = editor.session().mesh();
    editor.perform(Action::undo);
    editor.document().cancel_work();
    wait(editor);
    // Undo may have ended before it was cancelled, but nothing lies in between.
    const bool is_undone = editor.session().undo_count() == 0;
    EXPECT_NE(editor.session().mesh() == dragged, is_undone);
    if (is_undone) editor.perform(Action::redo);
    wait(editor);
    editor.execute(command::Adapt{.theta_max = Setting::of(0.05)});
    EXPECT_FALSE(editor.execute(command::Readapt{}));
    editor.document().cancel_work();
    wait(editor);
    EXPECT_TRUE(editor.session().mesh() == dragged);
    EXPECT_EQ(editor.workspace().message(), "");
}

TEST_F(EditTaskTest, ControlPointsAreReleasedInTheBackground) {
    auto editor = background_editor(2.0);
    editor.display.lattice = true;
    editor.set_cage(editor.workspace().box(), IVec3{3});
    editor.perform(Action::view_front);
    const Lattice cage = *editor.editable_cage();
    const auto at =
        editor.camera().project(cage.rest(cage.control_of_user_index({1, 1, 2})), kSize);
    ASSERT_TRUE(at);
    const TriMesh before = editor.session().mesh();
    drag(editor, *at, *at + Vec2(80, 60));
    wait(editor);
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_FALSE(test::cage_points(editor).is_dragging());
    EXPECT_FALSE(editor.session().mesh() == before);
}

TEST_F(EditTaskTest, QuittingCancelsItFirst) {
    auto editor = background_editor(0.05);
    press_and_move(editor);
    release(editor);
    ASSERT_TRUE(is_in_progress(editor));
    editor.document().quit();
    EXPECT_FALSE(editor.document().wants_to_end());
    wait(editor);
    EXPECT_TRUE(editor.document().wants_to_end())
        << "nothing has changed, so nothing has to be saved";
}

TEST_F(EditTaskTest, AnEditorMayEndWhileItIsInProgress) {
    auto editor = background_editor(0.05);
    press_and_move(editor);
    release(editor);
    ASSERT_TRUE(is_in_progress(editor));
}

}  // namespace
}  // namespace pectin
