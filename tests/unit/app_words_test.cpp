// Messages in the words of the window.
#include "app/words.h"

#include <regex>
#include <set>

#include "ffd/drag_refusal.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

TEST(Words, PartsOfARemarkBecomeSentences) {
    EXPECT_EQ(sentences(""), "");
    EXPECT_EQ(sentences("the surface intersects itself in 305 places; undo, or use a larger radius "
                        "or a shorter drag"),
              "The surface intersects itself in 305 places. Undo, or use a larger radius or a "
              "shorter drag.");
    EXPECT_EQ(sentences("a; b; 3 c."), "A. B; 3 c.");
}

TEST(Words, AMessageAboutAFileBeginsWithItsName) {
    EXPECT_EQ(words_of(FileError("/home/me/pic.png", "is not an OBJ model")),
              "pic.png is not an OBJ model.");
    EXPECT_EQ(words_of(FileError("/a/b.ply",
                                 "is a PLY model, not an OBJ model; open it in a "
                                 "program that reads it, and export it as OBJ")),
              "b.ply is a PLY model, not an OBJ model. Open it in a program that reads it, and "
              "export it as OBJ.");
    EXPECT_EQ(words_of(FileError("/a/gone.obj", "no such file")), "gone.obj: No such file.");
    EXPECT_EQ(words_of(FileError("/a/bad.obj", 12, "v needs 3 numbers; it has 2")),
              "bad.obj cannot be opened: line 12: v needs 3 numbers. It has 2.");
}

TEST(Words, FieldsAreNamedAsInThePanels) {
    EXPECT_EQ(words_of(Refusal{"theta_max must be an angle above 0 or null, not -1", "theta_max"}),
              "θ max must be an angle above 0, not -1.");
}

TEST(Words, EachKindWithWordsOfItsOwnIsOneOfTheRefusalsOfDrags) {
    const Vec3 p{0.0};
    const MirrorPlane plane{0, 0.0};
    const std::vector<DragRefusal> refusals{refuse::pinned(p, p),
                                            refuse::outside_zone(p, {}),
                                            refuse::near_border(p, {}, 1.0),
                                            refuse::target_outside_zone(p, {}),
                                            refuse::dependent(p, p, 2, 1),
                                            refuse::dependent(p, p, 1, 2),
                                            refuse::too_coarse_to_rotate(p),
                                            refuse::too_many_constraints(3),
                                            refuse::near_plane(plane, p),
                                            refuse::off_plane(plane, p, p),
                                            refuse::asymmetric_rotation(plane, p),
                                            refuse::across_plane(plane, p, p),
                                            refuse::onto_plane(p),
                                            refuse::too_many_steps(p, 3),
                                            refuse::on_the_way_to(p, refuse::onto_plane(p))};
    std::set<std::string> words;
    for (const DragRefusal& refusal : refusals) {
        SCOPED_TRACE(refusal.kind);
        ASSERT_TRUE(has_words(refusal.kind));
        const std::string text = words_of(Refusal{.reason = refusal.what, .kind = refusal.kind});
        EXPECT_FALSE(std::regex_search(text, std::regex("[0-9]|\\[|_"))) << text;
        EXPECT_TRUE(text.ends_with('.'));
        words.insert(text);
    }
    EXPECT_EQ(words.size(), refusals.size() - 1) << "the last has those of another";
}

using MessagesTest = EditorTest;

TEST_F(MessagesTest, DraggingAPinnedPointSaysHowToRemoveThePin) {
    auto editor = this->editor();
    editor.execute(command::Symmetry{});
    move(editor, kMiddle);
    key(editor, Key{'P'});
    ASSERT_EQ(editor.pins().points().size(), 1u);
    drag(editor, kMiddle, kMiddle + Vec2{60, -40});
    EXPECT_EQ(editor.workspace().message(),
              "This point is pinned. Press P over it to remove the pin.");
    move(editor, kMiddle);
    key(editor, Key{'P'});
    EXPECT_TRUE(editor.pins().is_empty()) << "as the message says";
}

TEST_F(MessagesTest, APictureIsNotAModel) {
    write("pic.png", "\x89PNG\r\n\x1a\n and more");
    write("pic.obj", "\x89PNG\r\n\x1a\n and more");
    auto editor = this->editor();
    editor.document().open(path("pic.png"));
    EXPECT_EQ(editor.workspace().message(), "pic.png is not an OBJ model.");
    editor.document().open(path("pic.obj"));
    EXPECT_EQ(editor.workspace().message(), "pic.obj is a PNG picture, not an OBJ model.");
}

TEST_F(MessagesTest, RepairsAreAWarningAndWhatIsKeptIsNot) {
    // Three faces at one edge, and two fans that share only a vertex.
    write("fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    write("loose.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 6 6\nf 1 2 3\n");
    auto editor = this->editor();
    editor.document().open(path("fan.obj"));
    EXPECT_TRUE(
        editor.workspace().message().starts_with("Opened with repairs: 1 non-manifold edge split"))
        << editor.workspace().message();
    EXPECT_TRUE(editor.workspace().message_warns());
    editor.document().open(path("loose.obj"));
    EXPECT_EQ(editor.workspace().message(), "2 unused vertices kept.");
    EXPECT_FALSE(editor.workspace().message_warns());
    EXPECT_FALSE(editor.workspace().message_is_confirmation());
}

TEST_F(MessagesTest, FiguresOfADragAreClearedByUndo) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2{60, -120});
    EXPECT_GT(editor.figures().splits, 0u);
    EXPECT_GT(editor.figures().seconds, 0.0);
    editor.undo();
    EXPECT_EQ(editor.figures().splits + editor.figures().unsplits, 0u);
    EXPECT_EQ(editor.figures().seconds, 0.0);
}

TEST_F(MessagesTest, SymmetryIsOnAtFirstWhateverIsOpened) {
    write("wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    for (const std::string& model : {std::string(), path("wedge.obj"), path("none.obj")}) {
        auto editor = prepared_editor({}, 2, [&](Editor& made) { made.begin(model); });
        ASSERT_TRUE(editor.session().symmetry()) << model;
        EXPECT_EQ(editor.session().symmetry()->axis, 0) << model;
    }
}

}  // namespace
}  // namespace pectin
