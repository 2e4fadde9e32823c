// Editor, driven by input events.
#include "app/editor.h"

#include <cmath>
#include <sstream>

#include "app/words.h"
#include "command/check.h"
#include "command/script.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST_F(EditorTest, ADragOnTheSurfaceIsOneUndoStepAndHidesTheHint) {
    auto editor = this->editor();
    EXPECT_TRUE(editor.shows_hint());
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_FALSE(editor.shows_hint());
    EXPECT_TRUE(editor.workspace().is_modified());
    EXPECT_GT(editor.figures().seconds, 0.0);
}

TEST_F(EditorTest, TheGrabbedPointStaysUnderTheCursor) {
    auto editor = this->editor();
    press(editor, kMiddle);
    ASSERT_TRUE(test::sculptor(editor).is_dragging());
    move(editor, {700, 310});
    const auto seen = editor.camera().project(test::sculptor(editor).to(), kSize);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(glm::distance(*seen, Vec2(700, 310)), 0.0, 1e-6);
}

TEST_F(EditorTest, ADragBesideTheObjectOnlyOrbitsTheCamera) {
    auto editor = this->editor();
    const Camera before = editor.camera();
    const Vec3 middle = editor.workspace().box().centre();
    drag(editor, kBeside, kBeside + Vec2(200, -100));
    EXPECT_EQ(editor.session().undo_count(), 0u);
    EXPECT_NEAR(glm::distance(*editor.view().project(middle), *before.project(middle, kSize)), 0.0,
                1e-6);
    EXPECT_GT(glm::distance(editor.camera().eye, before.eye), 0.1);
}

TEST_F(EditorTest, ClicksOnPanelsDoNotReachTheObject) {
    auto editor = this->editor();
    const Camera before = editor.camera();
    editor.handle(event::Press{MouseButton::left, kMiddle, {}}, {.mouse = true});
    move(editor, kMiddle + Vec2(50, 50));
    EXPECT_FALSE(test::sculptor(editor).is_dragging());
    EXPECT_EQ(editor.camera(), before);
}

TEST_F(EditorTest, EscapeDuringADragRestoresTheObjectAndTheReleaseDoesNothing) {
    auto editor = this->editor(), untouched = this->editor();
    press(editor, kMiddle);
    move(editor, {760, 300});
    EXPECT_FALSE(editor.session().mesh() == untouched.session().mesh());
    key(editor, Key::escape);
    EXPECT_EQ(editor.session().mesh(), untouched.session().mesh());
    editor.handle(event::Release{MouseButton::left, {760, 300}, {}});
    editor.advance();
    EXPECT_EQ(editor.session().undo_count(), 0u);
    EXPECT_FALSE(editor.workspace().is_modified());
}

TEST_F(EditorTest, KeysDuringADragAreIgnored) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(40, 40));
    press(editor, kMiddle - Vec2(60, 60));
    move(editor, kMiddle);
    key(editor, Key{'Z'}, {.control = true});
    key(editor, Key{'F'});
    editor.handle(event::Drop{{path("none.obj")}});
    EXPECT_TRUE(test::sculptor(editor).is_dragging());
    editor.handle(event::Release{MouseButton::left, kMiddle, {}});
    EXPECT_EQ(editor.session().undo_count(), 2u);
}

TEST_F(EditorTest, UndoAndRedoKeysRestoreTheExactMesh) {
    auto editor = this->editor(), untouched = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    const TriMesh dragged = editor.session().mesh();
    key(editor, Key{'Z'}, {.control = true});
    EXPECT_EQ(editor.session().mesh(), untouched.session().mesh());
    key(editor, Key{'Y'}, {.control = true});
    EXPECT_EQ(editor.session().mesh(), dragged);
    key(editor, Key{'Y'}, {.control = true});
    EXPECT_EQ(editor.workspace().message(), "There is nothing to redo.");
    EXPECT_EQ(editor.workspace().command_message_kind(), Messages::Kind::information);
}

TEST_F(EditorTest, DroppedStepsStillCountAsChangesAndAreReported) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    editor.execute(command::Save{path("saved.obj")});
    ASSERT_FALSE(editor.workspace().is_modified());
    editor.execute(command::History{Setting::of(1e-3)});
    EXPECT_FALSE(editor.workspace().is_modified());
    // The new step replaces a dropped one, so the number of steps to undo does not change.
    drag(editor, kMiddle, kMiddle + Vec2(-60, -80));
    ASSERT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(editor.workspace().is_modified());
    editor.execute(command::Save{path("saved.obj")});
    editor.execute(command::Bake{});
    ASSERT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(editor.workspace().is_modified());
    editor.workspace().dismiss();
    key(editor, Key{'Z'}, {.control = true});
    EXPECT_TRUE(editor.workspace().message().empty());
    key(editor, Key{'Z'}, {.control = true});
    EXPECT_NE(editor.workspace().message().find("dropped"), std::string::npos);
}

TEST_F(EditorTest, HoldingFAndMovingSetsTheRadius) {
    auto editor = this->editor();
    const double before = editor.radius();
    move(editor, kMiddle);
    editor.handle(event::KeyDown{Key{'F'}, {}});
    move(editor, kMiddle + Vec2(160, 0));
    EXPECT_NEAR(editor.radius(), 2.0 * before, 1e-9);
    editor.handle(event::KeyUp{Key{'F'}});
    EXPECT_NEAR(*editor.session().lattice_settings().radius, 2.0 * before, 1e-9);
    // Escape restores the radius.
    editor.handle(event::KeyDown{Key{'F'}, {}});
    move(editor, kMiddle);
    key(editor, Key::escape);
    editor.handle(event::KeyUp{Key{'F'}});
    EXPECT_NEAR(editor.radius(), 2.0 * before, 1e-9);
}

TEST_F(EditorTest, BracketsStepTheRadiusWithinBounds) {
    auto editor = this->editor();
    const double before = editor.radius();
    editor.handle(event::Character{']'});
    EXPECT_GT(editor.radius(), before);
    for (int i = 0; i < 300; ++i) editor.handle(event::Character{'['});
    EXPECT_EQ(editor.radius(), editor.min_radius());
}

TEST_F(EditorTest, TheRecordReplaysToTheSameMesh) {
    {
        auto editor = this->editor(Recorder(path("record.jsonl")));
        drag(editor, kMiddle, kMiddle + Vec2(60, -80));
        editor.handle(event::Character{'['});
        drag(editor, kMiddle, kMiddle + Vec2(10, 90), {.alt = true});
        key(editor, Key{'Z'}, {.control = true});
        editor.execute(command::Adapt{.theta_max = Setting::of(12.0)});
        editor.execute(command::Readapt{});
        editor.execute(command::Undo{.count = 99});  // refused and therefore not recorded
        editor.execute(command::Save{path("window.obj")});
    }
    std::istringstream text(read("record.jsonl"));
    ScriptReader reader(text);
    Session session;
    int commands = 0;
    while (const auto line = reader.next()) {
        ++commands;
        Command command = std::get<Command>(line->command);
        if (auto* save = std::get_if<command::Save>(&command)) save->path = path("replay.obj");
        EXPECT_TRUE(session.execute(command));
    }
    EXPECT_EQ(commands, 8);
    EXPECT_EQ(read("window.obj"), read("replay.obj"));
    EXPECT_FALSE(read("window.obj").empty());
}

// A drag that reaches no vertex changes no vertex, but its lattice becomes the one in use.
TEST_F(EditorTest, TheRecordHoldsDragsThatChangeOnlyTheLatticeInUse) {
    auto editor = this->editor(Recorder(path("record.jsonl")), 2);
    editor.drag_options = {};
    editor.execute(command::Adapt{.enabled = false});
    editor.set_radius(editor.min_radius());
    drag(editor, kMiddle + Vec2(13, 7), kMiddle + Vec2(40, -20));
    EXPECT_EQ(editor.session().undo_count(), 0u);
    editor.execute(command::Adapt{.enabled = true, .l_max = Setting::of(0.05)});
    editor.execute(command::Readapt{});
    Session replayed;
    std::istringstream record(read("record.jsonl"));
    ScriptReader reader(record);
    while (const auto line = reader.next()) {
        ASSERT_TRUE(replayed.execute(std::get<Command>(line->command)));
    }
    EXPECT_TRUE(replayed.mesh() == editor.session().mesh());
    EXPECT_GT(replayed.mesh().face_count(), 320u);
}

TEST_F(EditorTest, DialogsTakeAllInputAsSoonAsTheyAreRequested) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    const double radius = editor.radius();
    editor.perform(Action::open);
    editor.handle(event::Character{'['});
    editor.handle(event::Press{MouseButton::left, kMiddle, {}});
    EXPECT_FALSE(test::sculptor(editor).is_dragging());
    EXPECT_EQ(editor.radius(), radius);
    editor.handle(event::Close{});
    EXPECT_TRUE(editor.document().question());
    EXPECT_FALSE(editor.document().browser()) << "two dialogs at once";
}

TEST_F(EditorTest, RecordingOverAModelIsRefused) {
    write("model.obj", kTetrahedron);
    EXPECT_THROW(Recorder(path("model.obj")), std::exception);
    EXPECT_EQ(read("model.obj"), kTetrahedron);
}

TEST_F(EditorTest, ARecordHoldsEachCommandAsSoonAsItIsDone) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    EXPECT_EQ(read("record.jsonl"),
              "{\"pectin\": 1}\n{\"cmd\": \"shape\", \"kind\": \"sphere\", \"resolution\": 3}\n");
}

TEST_F(EditorTest, ACommandWithAPathThatIsNotUtf8IsExecutedButReportedAsNotRecorded) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    const std::string before = read("record.jsonl");
    EXPECT_TRUE(editor.execute(command::Save{path("caf\xe9.obj")}));
    EXPECT_NE(editor.workspace().message().find("UTF-8"), std::string::npos);
    EXPECT_EQ(read("record.jsonl"), before);
}

TEST_F(EditorTest, DroppingAModelOpensIt) {
    write("tetrahedron.obj", kTetrahedron);
    auto editor = this->editor();
    editor.handle(event::Drop{{path("tetrahedron.obj")}});
    EXPECT_EQ(editor.session().mesh().face_count(), 4u);
    EXPECT_EQ(editor.workspace().object_name(), "tetrahedron.obj");
}

// Sizes that suit a sphere would freeze the window on a model that is a hundred times as large.
TEST_F(EditorTest, ANewObjectGetsSizesThatSuitIt) {
    write("large.obj",
          "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    auto editor = this->editor();
    editor.set_radius(0.1 * editor.workspace().diagonal());
    editor.execute(command::Adapt{.l_max = Setting::of(0.02), .floor = Setting::of(0.001)});
    editor.document().open(path("large.obj"));
    const double diagonal = editor.workspace().diagonal();
    EXPECT_NEAR(diagonal, 100.0 * std::sqrt(3.0), 1e-9);
    EXPECT_DOUBLE_EQ(editor.radius(), 0.1 * diagonal);
    EXPECT_TRUE(editor.session().adapt_settings().l_max.is_automatic());
    EXPECT_TRUE(editor.session().adapt_settings().floor.is_automatic());
    // A cage around the object before goes, too; settings that are no sizes stay.
    editor.execute(command::Adapt{.theta_max = Setting::of(12.0), .l_max = Setting::off()});
    editor.set_cage(editor.workspace().box(), IVec3{4});
    editor.document().new_shape(command::Shape::Kind::sphere, 2);
    EXPECT_FALSE(editor.session().lattice_settings().cage.has_value());
    EXPECT_DOUBLE_EQ(editor.radius(), 0.1 * editor.workspace().diagonal());
    EXPECT_EQ(editor.session().adapt_settings().theta_max, Setting::of(12.0));
    EXPECT_TRUE(editor.session().adapt_settings().l_max.is_off());
    EXPECT_EQ(editor.workspace().message(), "");
}

TEST_F(EditorTest, DroppingAFileThatIsNoModelShowsAMessageAndKeepsTheObject) {
    write("letter.obj", "Dear v,\nf 1 2 3\n");
    auto editor = this->editor(), untouched = this->editor();
    for (const char* name : {"letter.obj", "absent.obj", "."}) {
        editor.handle(event::Drop{{path(name)}});
        EXPECT_FALSE(editor.workspace().message().empty()) << name;
        EXPECT_EQ(editor.session().mesh(), untouched.session().mesh());
        editor.workspace().dismiss();
    }
}

TEST_F(EditorTest, OpeningOverUnsavedChangesAsksFirst) {
    write("tetrahedron.obj", kTetrahedron);
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    editor.handle(event::Drop{{path("tetrahedron.obj")}});
    ASSERT_TRUE(editor.document().question());
    EXPECT_EQ(editor.session().undo_count(), 1u);
    editor.document().answer(DocumentController::Answer::cancel);
    EXPECT_EQ(editor.session().undo_count(), 1u);
    editor.handle(event::Drop{{path("tetrahedron.obj")}});
    editor.document().answer(DocumentController::Answer::discard);
    EXPECT_EQ(editor.session().mesh().face_count(), 4u);
}

TEST_F(EditorTest, ClosingWithChangesSavesThemToTheChosenFile) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    editor.handle(event::Close{});
    ASSERT_TRUE(editor.document().question());
    EXPECT_FALSE(editor.document().wants_to_end());
    editor.document().answer(DocumentController::Answer::save);
    ASSERT_TRUE(editor.document().browser());
    editor.document().browser()->name = path("kept");
    editor.document().accept_file();
    EXPECT_TRUE(fs::exists(path("kept.obj")));
    EXPECT_TRUE(editor.document().wants_to_end());
}

TEST_F(EditorTest, SaveGoesToTheOpenFileOnceThereIsOne) {
    auto editor = this->editor();
    key(editor, Key{'S'}, {.control = true});
    ASSERT_TRUE(editor.document().browser());
    editor.document().browser()->name = path("ball.obj");
    editor.document().accept_file();
    EXPECT_FALSE(editor.document().browser());
    const std::string first = read("ball.obj");
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    key(editor, Key{'S'}, {.control = true});
    EXPECT_FALSE(editor.document().browser());
    EXPECT_NE(read("ball.obj"), first);
    EXPECT_FALSE(editor.workspace().is_modified());
}

// A file of any other extension is read as OBJ, but not written. A format without a writer is the
// same case.
TEST_F(EditorTest, SaveAsksForAPathIfTheFormatOfTheOpenFileCannotBeWritten) {
    write("tetrahedron.txt", kTetrahedron);
    auto editor = this->editor();
    editor.document().open(path("tetrahedron.txt"));
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    key(editor, Key{'S'}, {.control = true});
    ASSERT_TRUE(editor.document().browser());
    EXPECT_EQ(editor.document().browser()->name, "tetrahedron.obj");
    editor.document().close_browser();
    editor.handle(event::Close{});
    editor.document().answer(DocumentController::Answer::save);
    ASSERT_TRUE(editor.document().browser());
    editor.document().accept_file();
    EXPECT_EQ(editor.workspace().path(), path("tetrahedron.obj"));
    EXPECT_TRUE(fs::exists(path("tetrahedron.obj")));
    EXPECT_EQ(read("tetrahedron.txt"), kTetrahedron);
    EXPECT_TRUE(editor.document().wants_to_end());
}

TEST_F(EditorTest, SavingAsksBeforeReplacingAnotherFile) {
    write("other.obj", "precious");
    auto editor = this->editor();
    editor.perform(Action::save_as);
    editor.document().browser()->name = path("other.obj");
    editor.document().accept_file();
    EXPECT_EQ(editor.document().file_to_replace(), path("other.obj"));
    EXPECT_EQ(read("other.obj"), "precious");
    key(editor, Key::escape);
    EXPECT_TRUE(editor.document().browser());
    EXPECT_TRUE(editor.document().file_to_replace().empty());
    editor.document().accept_file();
    editor.document().accept_file();
    EXPECT_FALSE(editor.document().browser());
    EXPECT_NE(read("other.obj"), "precious");
}

TEST_F(EditorTest, SavingToAFolderThatDoesNotExistShowsAMessage) {
    auto editor = this->editor();
    editor.perform(Action::save_as);
    editor.document().browser()->name = path("no such folder/ball.obj");
    editor.document().accept_file();
    EXPECT_FALSE(editor.workspace().message().empty());
    EXPECT_TRUE(editor.workspace().path().empty());
}

// Widgets execute commands, so their values meet the limits of scripts.
TEST_F(EditorTest, RefusesAValueWithTheWordsThatAScriptGets) {
    auto editor = this->editor();
    for (const Command& wrong :
         {Command{command::Brush{.span = 17}}, Command{command::Brush{.radius = -1.0}},
          Command{command::Cage{.fit = IVec3{0, 3, 3}}},
          Command{command::Adapt{.theta_max = Setting::of(-3.0)}},
          Command{command::Adapt{.l_max = Setting::of(0.0)}},
          Command{command::History{Setting::of(0.0)}}}) {
        EXPECT_FALSE(editor.execute(wrong));
        const auto in_script = parse_command(format_command(wrong));
        ASSERT_TRUE(std::holds_alternative<CommandError>(in_script));
        const Refusal refusal = check(wrong).refusal();
        EXPECT_EQ(refusal.reason, std::get<CommandError>(in_script).what);
        EXPECT_EQ(editor.workspace().message(), words_of(refusal));
    }
}

}  // namespace
}  // namespace pectin
