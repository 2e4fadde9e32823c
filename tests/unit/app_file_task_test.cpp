// Files that are read and written in the background, while the window stays responsive.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <thread>

#include "io/obj_writer.h"
#include "support/scratch_folder.h"
#include "support/small_files.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;
constexpr Modifiers kControl{.control = true};

class FileTaskTest : public testing::Test {
  protected:
    FileTaskTest() { write("tetrahedron.obj", kTetrahedron); }

    std::string path(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    std::string read(const std::string& name) const { return folder_.read(name); }
    // An editor that does all work on files in the background. It shows a sphere; one of resolution
    // 6 takes far longer to save than to cancel.
    PreparedEditor editor(int resolution = 3, std::optional<Recorder> recorder = {}) const {
        return PreparedEditor(std::move(recorder), 0ms, [=](Editor& made) {
            made.handle(event::Resize{kSize});
            made.document().new_shape(command::Shape::Kind::sphere, resolution);
        });
    }
    static void drag(Editor& editor) {
        editor.handle(event::MouseMove{kMiddle, {}});
        editor.handle(event::Press{MouseButton::left, kMiddle, {}});
        editor.handle(event::MouseMove{kMiddle + Vec2(60, -80), {}});
        editor.handle(event::Release{MouseButton::left, kMiddle + Vec2(60, -80), {}});
        editor.advance();
    }
    static void key(Editor& editor, Key key, Modifiers modifiers = {}) {
        editor.handle(event::KeyDown{key, modifiers});
        editor.handle(event::KeyUp{key});
    }
    static bool is_in_progress(const Editor& editor) {
        return editor.workspace().file_task() != nullptr;
    }
    // Advances frames until no work on a file is in progress.
    static void wait(Editor& editor) {
        while (is_in_progress(editor)) {
            editor.advance();
            std::this_thread::sleep_for(1ms);
        }
    }
    // Sends all kinds of input except cancelling and quitting.
    static void fumble(Editor& editor, const std::string& file) {
        drag(editor);
        key(editor, Key{'Z'}, kControl);
        key(editor, Key{'S'}, kControl);
        key(editor, Key{'O'}, kControl);
        key(editor, Key{'F'});
        key(editor, Key::enter);
        editor.handle(event::Character{']'});
        editor.handle(event::Scroll{3.0, kMiddle});
        editor.handle(event::Drop{{file}});
        editor.perform(Action::undo);
        editor.perform(Action::save_as);
        editor.document().new_shape(command::Shape::Kind::cube, 2);
        editor.document().open(file);
        editor.set_radius(0.123);
        EXPECT_FALSE(editor.execute(command::Readapt{}));
        EXPECT_EQ(editor.workspace().execute(command::Undo{}), Workspace::Outcome::failed);
        EXPECT_EQ(editor.workspace().execute(command::Open{file}), Workspace::Outcome::failed);
    }

  private:
    ScratchFolder folder_;
};

TEST_F(FileTaskTest, AQuickFileIsDoneImmediately) {
    Editor editor({}, 1h);
    editor.document().open(path("tetrahedron.obj"));
    EXPECT_FALSE(is_in_progress(editor));
    EXPECT_EQ(editor.session().mesh().face_count(), 4u);
    EXPECT_TRUE(editor.execute(command::Save{path("copy.obj")}));
    EXPECT_TRUE(fs::exists(path("copy.obj")));
}

TEST_F(FileTaskTest, OpeningKeepsTheOldObjectUntilTheNewOneIsRead) {
    auto editor = this->editor();
    const TriMesh sphere = editor.session().mesh();
    const Camera camera = editor.camera();
    editor.document().open(path("tetrahedron.obj"));
    ASSERT_TRUE(is_in_progress(editor));
    EXPECT_TRUE(editor.has_dialog());
    while (!editor.workspace().file_task()->work.has_ended(1h)) {
    }
    EXPECT_EQ(editor.workspace().file_task()->work.fraction(), 1.0);
    EXPECT_EQ(editor.session().mesh(), sphere) << "read, but not yet taken over";
    EXPECT_EQ(editor.workspace().object_name(), "sphere");
    editor.advance();
    EXPECT_FALSE(is_in_progress(editor));
    EXPECT_EQ(editor.session().mesh().face_count(), 4u);
    EXPECT_EQ(editor.workspace().object_name(), "tetrahedron.obj");
    EXPECT_NE(editor.camera(), camera) << "not framed";
}

TEST_F(FileTaskTest, NoInputChangesTheObjectWhileItIsSaved) {
    auto editor = this->editor(5);
    drag(editor);
    ASSERT_EQ(editor.session().undo_count(), 1u);
    const TriMesh before = editor.session().mesh();
    const double radius = editor.radius();
    const Camera camera = editor.camera();
    editor.execute(command::Save{path("ball.obj")});
    ASSERT_TRUE(is_in_progress(editor));
    fumble(editor, path("tetrahedron.obj"));
    EXPECT_FALSE(editor.document().browser() || editor.document().question());
    wait(editor);
    EXPECT_EQ(editor.session().mesh(), before);
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_EQ(editor.radius(), radius);
    EXPECT_EQ(editor.camera(), camera);
    EXPECT_EQ(editor.workspace().path(), path("ball.obj"));
    EXPECT_FALSE(editor.workspace().is_modified());
    EXPECT_EQ(read("ball.obj"), format_obj(before));
}

TEST_F(FileTaskTest, ASecondFileIsRefusedWhileOneIsInProgress) {
    write("other.obj", std::string(kTetrahedron) + "v 5 5 5\n");
    auto editor = this->editor();
    editor.document().open(path("tetrahedron.obj"));
    fumble(editor, path("other.obj"));
    wait(editor);
    EXPECT_EQ(editor.workspace().object_name(), "tetrahedron.obj");
    EXPECT_EQ(editor.session().mesh().face_count(), 4u);
}

TEST_F(FileTaskTest, EscapeCancelsAndKeepsTheObjectWithoutAMessage) {
    auto editor = this->editor();
    const TriMesh sphere = editor.session().mesh();
    editor.document().open(path("tetrahedron.obj"));
    key(editor, Key::escape);
    ASSERT_TRUE(is_in_progress(editor)) << "until the work has stopped";
    EXPECT_TRUE(editor.workspace().file_task()->work.is_cancelled());
    wait(editor);
    EXPECT_EQ(editor.session().mesh(), sphere);
    EXPECT_EQ(editor.workspace().message(), "");
    EXPECT_EQ(editor.workspace().object_name(), "sphere");
    editor.advance();
    editor.document().open(path("tetrahedron.obj"));
    wait(editor);
    EXPECT_EQ(editor.session().mesh().face_count(), 4u) << "and it can be opened again";
}

TEST_F(FileTaskTest, AModelThatWasReadBeforeItWasCancelledIsNotAdopted) {
    auto editor = this->editor();
    const TriMesh sphere = editor.session().mesh();
    editor.document().open(path("tetrahedron.obj"));
    ASSERT_TRUE(editor.workspace().file_task()->work.has_ended(1h));
    key(editor, Key::escape);
    wait(editor);
    EXPECT_EQ(editor.session().mesh(), sphere);
    EXPECT_EQ(editor.workspace().message(), "");
}

TEST_F(FileTaskTest, CancellingASaveKeepsTheOldFileAndTheChanges) {
    write("ball.obj", "precious");
    auto editor = this->editor(6);
    drag(editor);
    editor.execute(command::Save{path("ball.obj")});
    key(editor, Key::escape);
    wait(editor);
    EXPECT_EQ(read("ball.obj"), "precious");
    EXPECT_TRUE(editor.workspace().is_modified());
    EXPECT_EQ(editor.workspace().path(), "");
    EXPECT_EQ(std::distance(fs::directory_iterator(path("")), fs::directory_iterator()), 2)
        << "something half-written is left";
}

TEST_F(FileTaskTest, ErrorsInAFileAreReported) {
    write("letter.obj", "v 0 0 0\nv Dear reader\n");
    auto editor = this->editor();
    const TriMesh sphere = editor.session().mesh();
    editor.document().open(path("letter.obj"));
    wait(editor);
    EXPECT_NE(editor.workspace().message().find("letter.obj cannot be opened: line 2: "),
              std::string::npos)
        << editor.workspace().message();
    EXPECT_EQ(editor.session().mesh(), sphere);
    editor.execute(command::Save{path("no such folder/ball.obj")});
    wait(editor);
    EXPECT_NE(editor.workspace().message().find("no such folder"), std::string::npos);
    EXPECT_EQ(editor.workspace().path(), "");
}

TEST_F(FileTaskTest, FindingsInTheInputAreReported) {
    write("loose.obj", std::string(kTetrahedron) + "v 5 5 5\nv 6 6 6\n");
    auto editor = this->editor();
    editor.document().open(path("loose.obj"));
    wait(editor);
    EXPECT_EQ(editor.workspace().message(), "2 unused vertices kept.");
}

TEST_F(FileTaskTest, TheRecordHoldsCommandsThatAreDoneAndNotCancelledOnes) {
    auto editor = this->editor(6, Recorder(path("record.jsonl")));
    const std::string before = read("record.jsonl");
    editor.execute(command::Save{path("never.obj")});
    key(editor, Key::escape);
    wait(editor);
    editor.document().open(path("tetrahedron.obj"));
    EXPECT_EQ(read("record.jsonl"), before);
    wait(editor);
    const std::string added = read("record.jsonl").substr(before.size());
    EXPECT_TRUE(added.starts_with("{\"cmd\": \"open\"")) << added;
    EXPECT_EQ(std::count(added.begin(), added.end(), '\n'), 1) << added;
}

TEST_F(FileTaskTest, QuittingCancelsTheWorkAndEndsOnceItHasStopped) {
    for (const bool by_key : {false, true}) {
        auto editor = this->editor();
        editor.document().open(path("tetrahedron.obj"));
        if (by_key) {
            key(editor, Key{'Q'}, kControl);
        } else {
            editor.handle(event::Close{});
        }
        EXPECT_FALSE(editor.document().wants_to_end());
        wait(editor);
        EXPECT_TRUE(editor.document().wants_to_end());
        EXPECT_EQ(editor.workspace().object_name(), "sphere");
    }
}

TEST_F(FileTaskTest, QuittingDuringASaveAsksAboutTheUnsavedChanges) {
    auto editor = this->editor(6);
    drag(editor);
    editor.execute(command::Save{path("ball.obj")});
    editor.handle(event::Close{});
    wait(editor);
    EXPECT_FALSE(fs::exists(path("ball.obj")));
    EXPECT_TRUE(editor.document().question());
    EXPECT_FALSE(editor.document().wants_to_end());
}

TEST_F(FileTaskTest, ThePendingActionFollowsOnlyASuccessfulSave) {
    auto editor = this->editor(6);
    editor.execute(command::Save{path("ball.obj")});
    wait(editor);
    for (const bool cancels : {true, false}) {
        drag(editor);
        editor.document().open(path("tetrahedron.obj"));
        ASSERT_TRUE(editor.document().question());
        editor.document().answer(DocumentController::Answer::save);
        ASSERT_TRUE(is_in_progress(editor));
        EXPECT_TRUE(std::holds_alternative<command::Save>(editor.workspace().file_task()->command));
        if (cancels) key(editor, Key::escape);
        wait(editor);  // for the save, and then for the model if it follows
        EXPECT_EQ(editor.session().mesh().face_count() == 4u, !cancels);
    }
}

TEST_F(FileTaskTest, IfTheFirstModelIsCancelledOrInvalidASphereIsShown) {
    write("letter.obj", "Dear sphere\n");
    for (const char* name : {"tetrahedron.obj", "letter.obj"}) {
        Editor editor({}, 0ms);
        editor.handle(event::Resize{kSize});
        editor.begin(path(name));
        ASSERT_TRUE(is_in_progress(editor));
        EXPECT_EQ(editor.session().mesh().face_slots(), 0u);
        if (name == std::string("tetrahedron.obj")) key(editor, Key::escape);
        wait(editor);
        EXPECT_EQ(editor.session().mesh().face_count(), 5120u) << name;
        EXPECT_EQ(editor.workspace().object_name(), "sphere") << name;
        EXPECT_EQ(editor.workspace().message().empty(), name == std::string("tetrahedron.obj"));
    }
}

TEST_F(FileTaskTest, ADroppedFileClosesTheBrowser) {
    auto editor = this->editor();
    editor.perform(Action::open);
    ASSERT_TRUE(editor.document().browser());
    editor.handle(event::Drop{{path("tetrahedron.obj")}});
    EXPECT_TRUE(is_in_progress(editor));
    EXPECT_FALSE(editor.document().browser());
}

TEST_F(FileTaskTest, TheDestructorOfTheEditorWaitsForTheWork) {
    write("ball.obj", "precious");
    {
        auto editor = this->editor(6);
        editor.execute(command::Save{path("ball.obj")});
        ASSERT_TRUE(is_in_progress(editor));
    }
    EXPECT_EQ(read("ball.obj"), "precious");
}

}  // namespace
}  // namespace pectin
