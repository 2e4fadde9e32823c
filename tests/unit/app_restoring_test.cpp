// Restoring of sessions that ended unexpectedly.
#include "unit/app_recovery_fixture.h"

namespace pectin {
namespace {

using RestoringTest = RecoveryTest;

TEST_F(RestoringTest, RestoringGivesTheExactObjectAndWritesNoFile) {
    write("a.obj", kTetrahedron);
    const command::Open open{path("a.obj")};
    const std::string expected = bytes_after({open, kWide, kFirst, kSecond});
    crash_after({open, kWide, kFirst, kSecond});
    auto editor = this->editor();
    restore(editor);
    EXPECT_FALSE(editor.has_dialog());
    EXPECT_EQ(read("a.obj"), kTetrahedron);
    EXPECT_EQ(file_count(), 0u);
    EXPECT_TRUE(editor.workspace().is_modified());
    EXPECT_EQ(bytes_of(editor), expected);
}

TEST_F(RestoringTest, ASessionThatHadSavedOverItsOwnModelIsRestored) {
    const command::Open open{path("a.obj")};
    for (const char* saved_as : {"a.obj", "link.obj"}) {
        write("a.obj", kTetrahedron);
        std::error_code ignored;
        fs::create_symlink("a.obj", path("link.obj"), ignored);
        const std::string expected = bytes_after({open, kWide, kFirst, kSecond, kSecond});
        crash_after({open, kWide, kFirst, command::Save{path(saved_as)}, kSecond});
        const std::string saved = read("a.obj");
        EXPECT_NE(saved, kTetrahedron);
        EXPECT_EQ(file_count(), 2u) << "commands and model";
        {
            auto editor = this->editor();
            restore_and_begin_recovery(editor);
            EXPECT_EQ(file_count(), 2u) << "the restoring session has its own files";
            ASSERT_TRUE(editor.execute(kSecond)) << editor.workspace().message();
        }  // which crashes, too
        auto editor = this->editor();
        restore(editor);
        EXPECT_EQ(read("a.obj"), saved) << "restoring writes no file";
        EXPECT_EQ(editor.workspace().path(), path(saved_as));
        EXPECT_EQ(bytes_of(editor), expected);
        EXPECT_EQ(file_count(), 0u);
    }
}

TEST_F(RestoringTest, OnlyTheOwnerCanReadCopiesOfModelsAndTheyAreRemovedWithTheSession) {
    write("a.obj", kTetrahedron);
    auto editor = recovering_editor();
    ASSERT_TRUE(editor.execute(command::Open{path("a.obj")}));
    EXPECT_EQ(file_count(), 1u) << "no copy before it is needed";
    ASSERT_TRUE(editor.execute(command::Save{path("b.obj")}));
    EXPECT_EQ(file_count(), 1u) << "the model is still there";
    ASSERT_TRUE(editor.execute(command::Save{path("a.obj")}));
    EXPECT_EQ(file_count(), 2u);
    for (const auto& file : fs::directory_iterator(folder())) {
        EXPECT_EQ(file.status().permissions() & (fs::perms::group_all | fs::perms::others_all),
                  fs::perms::none)
            << file.path();
    }
    editor.workspace().end_recovery();
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(RestoringTest, ASessionIsNotRestoredFromAModelThatHasChanged) {
    write("a.obj", kTetrahedron);
    crash_after({command::Open{path("a.obj")}, kWide, kFirst});
    write("a.obj", kCube);
    auto editor = this->editor();
    restore(editor);
    const std::string message = editor.workspace().message();
    EXPECT_NE(message.find("a.obj was changed after the session had opened it"), std::string::npos)
        << message;
    EXPECT_EQ(editor.workspace().object_name(), "sphere");
    EXPECT_FALSE(editor.workspace().is_modified());
    write("a.obj", kTetrahedron);  // the earlier contents
    auto next = this->editor();
    restore(next);
    EXPECT_EQ(bytes_of(next), bytes_after({command::Open{path("a.obj")}, kWide, kFirst}));
}

TEST_F(RestoringTest, SavingOverAModelThatAnotherProgramHasChangedWarnsThatItCannotBeRestored) {
    write("a.obj", kTetrahedron);
    auto editor = recovering_editor();
    ASSERT_TRUE(editor.execute(command::Open{path("a.obj")}));
    write("a.obj", kCube);
    EXPECT_TRUE(editor.execute(command::Save{path("a.obj")}));
    EXPECT_TRUE(editor.execute(kWide));
    const std::string message = editor.workspace().message();
    EXPECT_NE(message.find("can no longer be restored"), std::string::npos) << message;
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(RestoringTest, OnlyTheModelThatWasOpenedLastIsNeeded) {
    write("a.obj", kCube);
    write("b.obj", kTetrahedron);
    const command::Open first{path("a.obj")}, last{path("b.obj")};
    const command::Symmetry symmetry{.plane = command::Symmetry::Plane::z};
    crash_after({first, symmetry, kWide, kSecond, last, kWide, kFirst});
    const std::string expected = bytes_after({last, symmetry, kWide, kFirst});
    fs::remove(path("a.obj"));
    auto editor = this->editor();
    restore(editor);
    EXPECT_EQ(bytes_of(editor), expected);
}

// A new object drops the cage, but earlier versions kept it.
TEST_F(RestoringTest, ACageThatWasFittedToAnEarlierObjectIsRestored) {
    write("b.obj", kTetrahedron);
    const std::vector<Command> commands{
        kSphere, kDrag, command::Cage{.fit = IVec3{3, 3, 3}}, command::Open{path("b.obj")},
        command::Control{.points = {{.index = {1, 1, 1}, .to = Vec3(0.5, 0.3, 0.6)}}}};
    const std::string expected = bytes_after(commands);
    crash_after_exactly(commands);
    auto editor = this->editor();
    restore(editor);
    EXPECT_EQ(bytes_of(editor), expected);
}

TEST_F(RestoringTest, TheNextSaveGoesWhereTheLostSessionSavedLast) {
    write("a.obj", kTetrahedron);
    crash_after(
        {command::Open{path("a.obj")}, kWide, kFirst, command::Save{path("b.obj")}, kSecond});
    auto editor = this->editor();
    restore(editor);
    EXPECT_EQ(editor.workspace().object_name(), "b.obj");
    const std::string expected =
        bytes_after({command::Open{path("a.obj")}, kWide, kFirst, kSecond});
    editor.perform(Action::save);
    EXPECT_EQ(read("b.obj"), expected);
    EXPECT_EQ(read("a.obj"), kTetrahedron);
}

TEST_F(RestoringTest, SettingsOfTheRestoringWindowHaveNoEffect) {
    const std::vector<Command> commands{kSphere, kDrag, kDrag};
    const std::vector<Command> off_centre{
        kSphere, command::Drag{.moves = {{.from = Vec3(0.6, 0, 0.8), .to = Vec3(0.9, 0.1, 1.2)}}}};
    const std::string expected = bytes_after(off_centre);
    for (const Command& setting :
         {Command(command::Symmetry{.plane = command::Symmetry::Plane::x}),
          Command(command::Adapt{.theta_max = Setting::of(60.0)}), Command(kWide),
          Command(command::Brush{.span = 4}), Command(command::Brush{.falloff = Falloff::plateau}),
          Command(command::Cage{.fit = IVec3{3, 3, 3}}),
          Command(command::History{Setting::of(0.001)})}) {
        lose(off_centre);
        auto editor = this->editor();
        ASSERT_TRUE(editor.execute(setting));
        restore(editor);
        EXPECT_EQ(bytes_of(editor), expected) << name(setting);
        EXPECT_EQ(editor.session().history().limit(), Session().history().limit());
    }
}

TEST_F(RestoringTest, TheRecordOfTheRestoringWindowReplaysToTheSameBytes) {
    lose({kSphere, command::Drag{.moves = {{.from = Vec3(0.6, 0, 0.8), .to = Vec3(0.9, 0, 1.2)}}}});
    Editor editor(Recorder(path("record.jsonl")), std::chrono::hours(1));
    editor.begin("");
    ASSERT_TRUE(editor.session().symmetry()) << "as every window begins";
    ASSERT_TRUE(editor.execute(command::Adapt{.theta_max = Setting::of(60.0)}));
    restore(editor);
    const std::string restored = bytes_of(editor);
    Session session = replayed("record.jsonl");
    ASSERT_TRUE(session.execute(command::Save{path("replayed.obj")}));
    EXPECT_EQ(read("replayed.obj"), restored);
}

TEST_F(RestoringTest, RestoringContinuesFrameByFrameAndCanBeCancelled) {
    std::vector<Command> commands{kSphere, kWide};
    for (int i = 0; i < 400; ++i) {
        commands.push_back(kDrag);
        commands.push_back(command::Undo{});
    }
    commands.push_back(kDrag);
    for (const bool quits : {false, true}) {
        lose(commands);
        auto editor = this->editor();
        editor.document().offer(lost());
        editor.document().answer_recovery(DocumentController::RecoveryAnswer::restore);
        editor.advance();
        ASSERT_TRUE(editor.document().restoration()) << "800 drags and undos in one frame";
        EXPECT_TRUE(editor.has_dialog());
        EXPECT_EQ(lost().size() + 1, file_count()) << "another window is offered this one, too";
        EXPECT_GT(editor.document().restoration()->fraction(), 0.0);
        EXPECT_LT(editor.document().restoration()->fraction(), 1.0);
        EXPECT_FALSE(editor.execute(command::Readapt{}))
            << "no other command may be executed meanwhile";
        if (quits) {
            editor.handle(event::Close{});
        } else {
            key(editor, Key::escape);
        }
        finish_restoring(editor);
        EXPECT_EQ(editor.document().wants_to_end(), quits);
        EXPECT_EQ(editor.workspace().object_name(), "sphere");
        EXPECT_FALSE(editor.workspace().is_modified());
        EXPECT_EQ(editor.session().undo_count(), 0u);
        EXPECT_NE(editor.workspace().message().find("offered again"), std::string::npos);
    }
    EXPECT_EQ(file_count(), 2u);
    EXPECT_EQ(lost().size(), 2u);
}

TEST_F(RestoringTest, TheRestoringSessionIsItselfKeptForRecovery) {
    lose({kSphere, kDrag});
    auto editor = this->editor();
    restore_and_begin_recovery(editor);
    EXPECT_EQ(file_count(), 1u) << "this session's file also holds the restored commands";
    editor.workspace().end_recovery();
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(RestoringTest, IfRestoringFailsTheCommandsStayInAFileThatTheMessageNames) {
    // The third command is invalid.
    write("a.obj", kTetrahedron);
    lose({command::Open{path("a.obj")}, kFirst, command::Redo{}, kSecond});
    auto editor = this->editor();
    restore(editor);
    const std::string message = editor.workspace().message();
    EXPECT_NE(message.find("Restored up to step 2 of 4"), std::string::npos) << message;
    EXPECT_NE(message.find(".incomplete"), std::string::npos) << message;
    EXPECT_EQ(editor.workspace().path(), "") << "a part does not replace the whole";
    EXPECT_EQ(file_count(), 1u);
    EXPECT_TRUE(lost().empty()) << "it is not offered again";
}

TEST_F(RestoringTest, IfTheModelIsMissingTheSessionIsOfferedAgain) {
    lose({kSphere, kDrag, command::Open{path("gone.obj")}, kDrag});
    auto editor = this->editor();
    restore(editor);
    const std::string message = editor.workspace().message();
    EXPECT_NE(message.find("gone.obj"), std::string::npos) << message;
    EXPECT_EQ(editor.workspace().object_name(), "sphere");
    EXPECT_EQ(lost().size(), 1u);
}

}  // namespace
}  // namespace pectin
