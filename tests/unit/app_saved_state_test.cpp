// Whether the object counts as modified, and the message that confirms a save.
#include <thread>

#include "io/obj_writer.h"
#include "support/random_commands.h"
#include "support/test_run.h"
#include "unit/app_recovery_fixture.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;
using command::Bake;
using command::Redo;
using command::Save;
using command::Undo;

class SavedStateTest : public RecoveryTest {
  protected:
    static bool is_modified(const Editor& editor) { return editor.workspace().is_modified(); }
    static void execute(Editor& editor, const std::vector<Command>& commands) {
        for (const Command& command : commands) {
            ASSERT_TRUE(editor.execute(command)) << editor.workspace().message();
        }
    }
    Save save() const { return {path("saved.obj")}; }
    // An editor that does all work on files and all edits in the background. Its sphere takes far
    // longer to save than to cancel.
    PreparedEditor background_editor() const {
        return PreparedEditor({}, 0ms, [](Editor& made) {
            made.handle(event::Resize{kSize});
            made.document().new_shape(command::Shape::Kind::sphere, 6);
            made.workspace().set_max_edit_time(0ms);
        });
    }
    static void wait(Editor& editor) {
        while (editor.is_working()) {
            editor.advance();
            std::this_thread::sleep_for(1ms);
        }
    }
    static void execute_and_wait(Editor& editor, const Command& command) {
        editor.execute(command);
        wait(editor);
    }
};

TEST_F(SavedStateTest, UndoAndRedoLeadBackToTheSavedState) {
    auto editor = this->editor();
    execute(editor, {kFirst, save(), kSecond});
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_TRUE(is_modified(editor)) << "the state before the one that was saved";
    execute(editor, {Redo{}});
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {Redo{}});
    EXPECT_TRUE(is_modified(editor));
}

TEST_F(SavedStateTest, NothingIsAskedAfterEverythingWasUndone) {
    write("a.obj", kTetrahedron);
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    EXPECT_TRUE(is_modified(editor));
    key(editor, Key{'Z'}, {.control = true});
    EXPECT_FALSE(is_modified(editor)) << "a shape as it was made needs no save";
    editor.document().open(path("a.obj"));
    EXPECT_FALSE(editor.document().question());
    EXPECT_EQ(editor.workspace().object_name(), "a.obj");
    execute(editor, {kWide, kFirst, Undo{}});
    EXPECT_FALSE(is_modified(editor)) << "a model as it was opened needs no save";
    editor.document().new_shape(command::Shape::Kind::cube, 2);
    EXPECT_FALSE(editor.document().question());
    execute(editor, {kFirst, Undo{}});
    editor.handle(event::Close{});
    EXPECT_FALSE(editor.document().question());
    EXPECT_TRUE(editor.document().wants_to_end());
}

TEST_F(SavedStateTest, AnotherStepWithTheNumberOfTheSavedOneIsModified) {
    auto editor = this->editor();
    execute(editor, {kFirst, save(), Undo{}, kSecond});
    ASSERT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_TRUE(is_modified(editor));
}

TEST_F(SavedStateTest, ASaveBetweenUndoAndRedoSavesThePresentState) {
    auto editor = this->editor();
    execute(editor, {kFirst, kSecond, Undo{}, save()});
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {Redo{}});
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_FALSE(is_modified(editor));
}

TEST_F(SavedStateTest, BakingIsAStepLikeOthers) {
    auto editor = this->editor();
    execute(editor, {command::Adapt{.theta_max = Setting::of(5.0)}, kFirst, save(), Bake{}});
    ASSERT_EQ(editor.session().undo_count(), 2u);
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {Redo{}, save(), Undo{}});
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Redo{}});
    EXPECT_FALSE(is_modified(editor));
}

TEST_F(SavedStateTest, CommandsThatAddNoStepDoNotModify) {
    auto editor = this->editor();
    execute(editor, {kFirst, save(), command::Adapt{.theta_max = Setting::of(40.0)}, kWide,
                     command::Symmetry{.plane = command::Symmetry::Plane::x},
                     command::Cage{.fit = IVec3{3, 3, 3}}, command::History{Setting::of(1.0)}});
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {Save{path("other.obj")}, Bake{}, save(), Bake{}});
    EXPECT_FALSE(is_modified(editor)) << "there is nothing left to bake";
}

TEST_F(SavedStateTest, StepsThatTheLimitDropsAreNotConfusedWithTheSavedOne) {
    const command::History limit{Setting::of(1e-3)};
    auto editor = this->editor();
    execute(editor, {kFirst, save(), kSecond, kFirst, limit});
    ASSERT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {Undo{}});
    EXPECT_TRUE(is_modified(editor)) << "the saved state can no longer be reached";
    // The step that led to the saved state is dropped, and undo still leads back to that state.
    auto other = this->editor();
    execute(other, {kFirst, kSecond, save(), kFirst, limit});
    ASSERT_EQ(other.session().undo_count(), 1u);
    EXPECT_TRUE(is_modified(other));
    execute(other, {Undo{}});
    EXPECT_FALSE(is_modified(other));
    execute(other, {Redo{}});
    EXPECT_TRUE(is_modified(other));
}

TEST_F(SavedStateTest, AFailedSaveChangesNothing) {
    auto editor = this->editor();
    execute(editor, {kFirst, save(), kSecond});
    const Save fails{path("no such folder/saved.obj")};
    EXPECT_FALSE(editor.execute(fails));
    EXPECT_TRUE(is_modified(editor));
    EXPECT_EQ(editor.workspace().path(), path("saved.obj"));
    EXPECT_FALSE(editor.workspace().message_is_confirmation()) << editor.workspace().message();
    execute(editor, {Undo{}});
    EXPECT_FALSE(is_modified(editor));
    EXPECT_FALSE(editor.execute(fails));
    EXPECT_FALSE(is_modified(editor));
}

TEST_F(SavedStateTest, WorkInTheBackgroundCountsOnceItIsDone) {
    auto editor = background_editor();
    execute_and_wait(editor, kFirst);
    editor.execute(save());
    ASSERT_TRUE(editor.workspace().file_task());
    EXPECT_TRUE(is_modified(editor)) << "not yet saved";
    wait(editor);
    EXPECT_FALSE(is_modified(editor));
    EXPECT_EQ(editor.workspace().message(), "Saved saved.obj.");
    editor.execute(kSecond);
    ASSERT_TRUE(editor.workspace().edit_task());
    EXPECT_FALSE(is_modified(editor)) << "not yet changed";
    wait(editor);
    EXPECT_TRUE(is_modified(editor));
    execute_and_wait(editor, Undo{});
    EXPECT_FALSE(is_modified(editor));
}

TEST_F(SavedStateTest, CancelledWorkChangesNothing) {
    auto editor = background_editor();
    execute_and_wait(editor, kFirst);
    editor.execute(save());
    editor.document().cancel_work();
    wait(editor);
    EXPECT_FALSE(fs::exists(path("saved.obj")));
    EXPECT_TRUE(is_modified(editor));
    EXPECT_EQ(editor.workspace().message(), "");
    execute_and_wait(editor, Undo{});
    EXPECT_FALSE(is_modified(editor));
    editor.execute(kSecond);
    editor.document().cancel_work();
    wait(editor);
    EXPECT_EQ(is_modified(editor), editor.session().undo_count() > 0);
}

TEST_F(SavedStateTest, ARestoredSessionKnowsWhatTheLostOneHadSaved) {
    crash_after({kSphere, kFirst, save(), kSecond});
    auto editor = this->editor();
    restore(editor);
    EXPECT_TRUE(is_modified(editor));
    EXPECT_EQ(format_obj(editor.session().mesh()), bytes_after({kSphere, kFirst, kSecond}));
    execute(editor, {Undo{}});
    EXPECT_FALSE(is_modified(editor));
    EXPECT_EQ(format_obj(editor.session().mesh()), read("saved.obj"));
    execute(editor, {Undo{}});
    EXPECT_TRUE(is_modified(editor));
}

// The lost session may have ended between replacing the file and recording that.
TEST_F(SavedStateTest, ARestoredSessionDoesNotTrustTheFileOfTheModelThatItHadOpened) {
    write("a.obj", kTetrahedron);
    crash_after({command::Open{path("a.obj")}, kWide, kFirst});
    auto editor = this->editor();
    restore(editor);
    execute(editor, {Undo{}});
    EXPECT_TRUE(is_modified(editor));
    execute(editor, {save(), Redo{}, Undo{}});
    EXPECT_FALSE(is_modified(editor));
}

TEST_F(SavedStateTest, APartOfASessionIsModifiedAndASessionThatIsNotRestoredIsNot) {
    lose({kSphere, kFirst, save(), Redo{}, kSecond});  // the fourth command is invalid
    auto editor = this->editor();
    restore(editor);
    EXPECT_EQ(editor.workspace().path(), "");
    EXPECT_TRUE(is_modified(editor)) << "it has no file that could hold it";
    lose({command::Open{path("gone.obj")}, kFirst});
    execute(editor, {kSecond});
    restore(editor);
    EXPECT_EQ(editor.workspace().object_name(), "sphere");
    EXPECT_FALSE(is_modified(editor));
    execute(editor, {kSecond});
    editor.workspace().reset_session();
    EXPECT_FALSE(is_modified(editor)) << "there is no object";
}

TEST_F(SavedStateTest, SavingIsConfirmedUntilTheNextCommandOrDrag) {
    auto editor = this->editor();
    for (const bool by_drag : {false, true}) {
        execute(editor, {kFirst});
        EXPECT_EQ(editor.workspace().message(), "");
        execute(editor, {save()});
        EXPECT_EQ(editor.workspace().message(), "Saved saved.obj.");
        EXPECT_TRUE(editor.workspace().message_is_confirmation());
        if (by_drag) {
            drag(editor, kMiddle, kMiddle + Vec2(60, -80));
        } else {
            execute(editor, {Undo{}});
        }
        EXPECT_EQ(editor.workspace().message(), "");
        EXPECT_FALSE(editor.workspace().message_is_confirmation());
    }
}

TEST_F(SavedStateTest, AMessageWithAWarningIsNoMereConfirmation) {
    auto editor = this->editor();
    editor.workspace().add_notice("Something is wrong.");
    execute(editor, {save()});
    EXPECT_EQ(editor.workspace().message(), "Something is wrong.\nSaved saved.obj.");
    EXPECT_FALSE(editor.workspace().message_is_confirmation());
    editor.workspace().dismiss();
    execute(editor, {save()});
    editor.workspace().set_message("This went wrong.");
    EXPECT_FALSE(editor.workspace().message_is_confirmation());
}

TEST_F(SavedStateTest, TheConfirmationReportsOnMaterialFiles) {
    for (const char* folder : {"a", "b", "c"}) fs::create_directory(path(folder));
    write("a/model.obj", std::string("mtllib m/m.mtl other.mtl\n") + kTetrahedron);
    fs::create_directory(path("a/m"));
    write("a/m/m.mtl", "newmtl blue\n");
    write("a/other.mtl", "newmtl red\n");
    write("c/m", "a file where the folder has to be");
    auto editor = this->editor();
    editor.document().open(path("a/model.obj"));
    execute(editor, {Save{path("b/copy.obj")}});
    EXPECT_EQ(editor.workspace().message(),
              "Saved copy.obj: material files copied: m/m.mtl, other.mtl.");
    EXPECT_TRUE(editor.workspace().message_is_confirmation());
    execute(editor, {Save{path("c/copy.obj")}});
    const std::string message = editor.workspace().message();
    EXPECT_TRUE(message.starts_with("Saved copy.obj: ")) << message;
    EXPECT_NE(message.find("could not be copied: m/m.mtl"), std::string::npos) << message;
    EXPECT_FALSE(editor.workspace().message_is_confirmation());
    EXPECT_FALSE(is_modified(editor)) << "the model itself is saved";
}

TEST_F(SavedStateTest, SavingAPictureIsConfirmedAndLeavesTheObjectModified) {
    struct BlankViewport : Viewport {
        Done screenshot(const TriMesh&, const std::optional<Lattice>&,
                        const command::Screenshot&) override {
            return {};
        }
    } viewport;
    auto editor = this->editor();
    editor.workspace().set_viewport(&viewport);
    execute(editor, {kFirst, save(), kSecond});
    editor.perform(Action::save_picture);
    editor.document().browser()->name = path("picture.png");
    editor.document().accept_file();
    EXPECT_EQ(editor.workspace().message(), "Saved picture.png.");
    EXPECT_TRUE(editor.workspace().message_is_confirmation());
    EXPECT_TRUE(is_modified(editor));
}

// --- Random commands.

// Knows which states of the object are the same, from the counts of the history alone.
class StateModel {
  public:
    explicit StateModel(const Session& session) : session_(session) {}

    // To be called after each command. Undo and redo only move between known states.
    void update(bool only_moves) {
        const std::size_t number = session_.history().step_number();
        const bool is_new_step = !only_moves && number == number_ + 1;
        if (is_new_step) states_.resize(number);
        if (number == states_.size()) states_.push_back(++last_);
        number_ = number;
    }
    int state() const { return states_.at(number_); }

  private:
    const Session& session_;
    std::vector<int> states_{0};  // by the number of the step that led there
    std::size_t number_ = 0;
    int last_ = 0;
};

TEST_F(SavedStateTest, AnObjectThatIsNotModifiedHasTheBytesOfTheLastSave) {
    const int cases = test::case_count(20);
    int returns = 0;  // to the saved state, by undo or redo
    for (int i = 0; i < cases; ++i) {
        const auto seed = 7100 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        auto editor = this->editor({}, 2);
        execute(editor, {command::Adapt{.floor = Setting::of(0.05), .budget = 2'000}});
        StateModel model(editor.session());
        std::string saved_bytes = format_obj(editor.session().mesh());
        int saved_state = model.state();
        for (int k = 0; k < 80; ++k) {
            Command command = test::random_command(editor.session().mesh(), random, 1.0, 2'000);
            if (random.chance(0.15)) command = Undo{};
            if (random.chance(0.1)) command = Redo{};
            if (random.chance(0.1)) command = save();
            if (random.chance(0.05)) command = Save{path("no such folder/saved.obj")};
            if (random.chance(0.04)) command = command::History{Setting::of(random.scale(0.01, 1))};
            if (random.chance(0.05)) command = Bake{};
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            const bool was_modified = is_modified(editor);
            const bool is_move =
                std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command);
            if (random.chance(0.1)) {
                const Vec2 to{random.uniform(540, 740), random.uniform(300, 500)};
                drag(editor, kMiddle, to);
                model.update(false);
            } else {
                const bool is_done = editor.execute(command);
                model.update(is_move);
                if (is_done && std::holds_alternative<Save>(command)) {
                    saved_bytes = read("saved.obj");
                    saved_state = model.state();
                    ASSERT_FALSE(is_modified(editor));
                }
                returns += is_move && was_modified && !is_modified(editor);
            }
            ASSERT_EQ(is_modified(editor), model.state() != saved_state);
            if (!is_modified(editor)) {
                ASSERT_TRUE(format_obj(editor.session().mesh()) == saved_bytes);
            }
        }
    }
    EXPECT_GT(returns, cases) << "the commands hardly ever lead back to the saved state";
}

}  // namespace
}  // namespace pectin
