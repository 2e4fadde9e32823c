// Selecting and dragging a cage's control points with the mouse.
#include "app/tools/cage_points.h"

#include <algorithm>

#include "app/cage_box.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

class CagePointsTest : public EditorTest {
  protected:
    // Shows a sphere in a cage of 3 control points per axis.
    PreparedEditor caged(std::optional<Recorder> recorder = {}) const {
        return prepared_editor(std::move(recorder), 3, [](Editor& made) {
            made.execute(command::Cage{.fit = IVec3{3}});
            made.display.lattice = true;
            made.advance();
        });
    }
    static Vec2 seen(const Editor& editor, const IVec3& index) {
        const Vec3 rest = editor.session().lattice_settings().cage->rest(index);
        return *editor.camera().project(rest, kSize);
    }
    static void click(Editor& editor, const Vec2& at, Modifiers modifiers = {}) {
        press(editor, at, modifiers);
        editor.handle(event::Release{MouseButton::left, at, modifiers});
        editor.advance();
    }
};

// Corners of the box on the side of the camera. One more layer of control points lies between them
// and the camera.
constexpr IVec3 kCorner{3, 3, 3}, kOther{1, 3, 3}, kBelow{3, 1, 3};

TEST(CageBox, FittingACageToItGivesTheSameCage) {
    const Box box{.min = {-1, 0, 2}, .max = {3, 0.5, 7}};
    for (const IVec3& counts : {IVec3{2, 3, 4}, IVec3{1, 5, 1}}) {
        const Box again = cage_box(fit_lattice(box, counts));
        EXPECT_NEAR(glm::distance(again.min, box.min), 0.0, 1e-12);
        EXPECT_NEAR(glm::distance(again.max, box.max), 0.0, 1e-12);
    }
}

TEST_F(CagePointsTest, ControlPointsAreFoundOnlyWhileTheCageIsShown) {
    auto editor = caged();
    move(editor, seen(editor, kCorner) + Vec2(3, -2));
    EXPECT_EQ(test::cage_points(editor).hovered(), kCorner);
    editor.display.lattice = false;
    move(editor, seen(editor, kCorner));
    EXPECT_FALSE(test::cage_points(editor).hovered());
}

TEST_F(CagePointsTest, PointsHiddenByTheObjectAreNotFound) {
    auto editor = caged();
    move(editor, seen(editor, {2, 2, 2}));
    EXPECT_FALSE(test::cage_points(editor).hovered());
    EXPECT_TRUE(editor.hover()) << "the surface is";
}

TEST_F(CagePointsTest, InnerPointsOfALargeCageAreSelectedOnlyByABox) {
    auto editor = caged();
    // The cage is wider than the object, so that its inner control points lie beside the object.
    editor.set_cage({.min = Vec3{-4.0}, .max = Vec3{4.0}}, IVec3{7});
    for (int i = 0; i < 3; ++i) editor.handle(event::Scroll{-8.0, kMiddle});
    editor.advance();
    // Only the points on the sides of the box and those beyond it are drawn.
    const auto is_drawn = [](int i) { return i <= 1 || i >= 7; };
    for (int i = 0; i < 9; ++i) {
        for (int j = 0; j < 9; ++j) {
            for (int k = 0; k < 9; ++k) {
                move(editor, seen(editor, {i, j, k}));
                const auto& hovered = test::cage_points(editor).hovered();
                EXPECT_TRUE(!hovered || is_drawn(hovered->x) || is_drawn(hovered->y) ||
                            is_drawn(hovered->z));
            }
        }
    }
    drag(editor, {0, 0}, Vec2(kSize), {.control = true});
    EXPECT_EQ(test::cage_points(editor).selected().size(), 729u);
}

TEST_F(CagePointsTest, ClicksSelectOnePointAndWithShiftSeveral) {
    auto editor = caged();
    const auto& selected = test::cage_points(editor).selected();
    click(editor, seen(editor, kCorner));
    EXPECT_EQ(selected, std::vector{kCorner});
    click(editor, seen(editor, kOther), {.shift = true});
    EXPECT_EQ(selected, (std::vector{kCorner, kOther}));
    click(editor, seen(editor, kOther), {.shift = true});
    EXPECT_EQ(selected, std::vector{kCorner});
    click(editor, seen(editor, kBelow));
    EXPECT_EQ(selected, std::vector{kBelow});
    key(editor, Key::escape);
    EXPECT_TRUE(selected.empty());
    EXPECT_EQ(editor.session().undo_count(), 0u);
}

TEST_F(CagePointsTest, ABoxSelectsAllPointsInsideIt) {
    auto editor = caged();
    editor.handle(event::Scroll{-10.0, kMiddle});  // so that the whole cage is in the window
    const Vec2 at = seen(editor, kCorner);
    drag(editor, at - Vec2(5, 5), at + Vec2(5, 5), {.control = true});
    EXPECT_EQ(test::cage_points(editor).selected(), std::vector{kCorner});
    drag(editor, {0, 0}, Vec2(kSize), {.control = true});
    EXPECT_EQ(test::cage_points(editor).selected().size(), 125u);
    press(editor, at - Vec2(5, 5), {.control = true});
    move(editor, at + Vec2(5, 5), {.control = true});
    key(editor, Key::escape);
    EXPECT_FALSE(test::cage_points(editor).box());
    EXPECT_EQ(test::cage_points(editor).selected().size(), 125u)
        << "a cancelled box changes nothing";
}

TEST_F(CagePointsTest, DraggedPointsFollowTheCursorAndTheRecordReplaysToTheSameMesh) {
    auto editor = caged(Recorder(path("record.jsonl")));
    click(editor, seen(editor, kCorner));
    click(editor, seen(editor, kOther), {.shift = true});
    const Vec2 from = seen(editor, kCorner);
    drag(editor, from, from + Vec2(50, -40));
    const auto control = std::get<command::Control>(last_of("record.jsonl"));
    ASSERT_EQ(control.points.size(), 2u);
    EXPECT_EQ(control.points[0].index, kCorner - 1) << "as scripts number them";
    const auto to = editor.camera().project(control.points[0].to, kSize);
    EXPECT_NEAR(glm::distance(*to, from + Vec2(50, -40)), 0.0, 1e-6);
    const Lattice cage = *editor.session().lattice_settings().cage;
    EXPECT_NEAR(glm::distance(control.points[0].to - cage.rest(kCorner),
                              control.points[1].to - cage.rest(kOther)),
                0.0, 1e-12);
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(editor.workspace().is_modified());
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(CagePointsTest, AnOrbitBesideTheObjectTurnsAboutTheControlPointThatWasDraggedLast) {
    auto editor = caged();
    const Vec2 from = seen(editor, kCorner), to = from + Vec2(40, 30);
    drag(editor, from, to);
    ASSERT_EQ(editor.session().undo_count(), 1u);
    const Vec3 rest = editor.session().lattice_settings().cage->rest(kCorner);
    const Ray ray = editor.camera().ray_through(to, kSize);
    const Vec3 forward = editor.camera().forward();
    const Vec3 dragged =
        ray.at(glm::dot(rest - ray.origin, forward) / glm::dot(ray.direction, forward));
    editor.display.lattice = false;
    editor.advance();
    drag(editor, kBeside, kBeside + Vec2(90, -60));
    ASSERT_EQ(editor.session().undo_count(), 1u) << "the view has been dragged";
    EXPECT_NEAR(glm::distance(*editor.camera().project(dragged, kSize), to), 0.0, 0.5);
}

TEST_F(CagePointsTest, EscapeDuringADragRestoresTheObject) {
    auto editor = caged(), untouched = caged();
    press(editor, seen(editor, kCorner));
    move(editor, seen(editor, kCorner) + Vec2(80, 80));
    EXPECT_FALSE(editor.session().mesh() == untouched.session().mesh());
    key(editor, Key::escape);
    EXPECT_TRUE(editor.session().mesh() == untouched.session().mesh());
    EXPECT_FALSE(editor.session().is_dragging());
}

TEST_F(CagePointsTest, WithSymmetryTheOtherSideMovesMirroredEvenIfSelected) {
    auto editor = caged(Recorder(path("record.jsonl")));
    editor.set_symmetry(true);
    const Vec2 from = seen(editor, kCorner);
    click(editor, seen(editor, kOther));
    click(editor, from, {.shift = true});
    press(editor, from);
    move(editor, from + Vec2(60, 0));
    const Lattice cage = *editor.session().lattice_settings().cage;
    const auto displacements = test::cage_points(editor).displacements(editor.session());
    const Vec3 d = displacements[cage.control_index(kCorner)];
    EXPECT_GT(glm::length(d), 0.05);
    EXPECT_EQ(displacements[cage.control_index(kOther)], Vec3(-d.x, d.y, d.z));
    editor.handle(event::Release{MouseButton::left, from + Vec2(60, 0), {}});
    EXPECT_TRUE(editor.workspace().message().empty()) << editor.workspace().message();
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(CagePointsTest, SymmetryWithAnAsymmetricCageIsRefusedWithAMessage) {
    auto editor = caged();
    editor.set_symmetry(true);
    editor.set_cage({.min = Vec3{-1, -1, -1}, .max = Vec3{2, 1, 1}}, IVec3{3});
    editor.advance();
    const Vec2 from = seen(editor, kCorner);
    drag(editor, from, from + Vec2(40, 0));
    EXPECT_NE(editor.workspace().message().find("mirror"), std::string::npos);
    EXPECT_EQ(editor.session().undo_count(), 0u);
}

TEST_F(CagePointsTest, AnotherCageClearsTheSelection) {
    auto editor = caged();
    click(editor, seen(editor, kCorner));
    editor.set_cage(cage_box(*editor.session().lattice_settings().cage), IVec3{2});
    editor.advance();
    EXPECT_TRUE(test::cage_points(editor).selected().empty());
    EXPECT_EQ(editor.session().lattice_settings().cage->counts(), IVec3{2});
}

TEST_F(CagePointsTest, ACageSetAsABoxHasTheSameMarginsAsAFittedOne) {
    auto editor = caged(Recorder(path("record.jsonl")));
    const Lattice fitted = *editor.session().lattice_settings().cage;
    editor.set_cage(cage_box(fitted), IVec3{3});
    const Lattice set = *editor.session().lattice_settings().cage;
    EXPECT_EQ(set.deformable, fitted.deformable);
    EXPECT_EQ(set.margin, fitted.margin);
    EXPECT_NEAR(glm::distance(set.origin, fitted.origin), 0.0, 1e-12);
    editor.set_cage(cage_box(fitted), {1, 2, 3});
    EXPECT_EQ(editor.session().lattice_settings().cage->margin, IVec3(2, 1, 1));
    EXPECT_EQ(*replayed("record.jsonl").lattice_settings().cage,
              *editor.session().lattice_settings().cage);
}

}  // namespace
}  // namespace pectin
