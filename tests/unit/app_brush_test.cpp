// The brush in the window: its radius in each unit, what rings and tint show, and keys during
// drags.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/editor_scene.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

using BrushTest = EditorTest;

const std::string kLarge =
    "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

void type(Editor& editor, const std::string& text) {
    for (const char c : text) {
        const Key key{std::toupper(static_cast<unsigned char>(c))};
        editor.handle(event::KeyDown{key});
        editor.handle(event::Character{static_cast<unsigned char>(c)});
        editor.handle(event::KeyUp{key});
        editor.advance();
    }
}

void set_unit(Editor& editor, RadiusUnit unit) {
    editor.set_radius_unit(unit);
    ASSERT_EQ(editor.brush_size().unit, unit);
}

double session_radius(const Editor& editor) { return *editor.session().lattice_settings().radius; }

// --- Radius

TEST_F(BrushTest, AShareOfTheObjectIsKeptWhenAnotherObjectIsOpened) {
    write("large.obj", kLarge);
    auto editor = this->editor();
    editor.set_radius_value(0.1);
    EXPECT_NEAR(session_radius(editor), 0.1 * editor.workspace().diagonal(), 1e-12);
    editor.document().open(path("large.obj"));
    ASSERT_GT(editor.workspace().diagonal(), 100.0);
    EXPECT_NEAR(session_radius(editor), 0.1 * editor.workspace().diagonal(), 1e-9);
    EXPECT_NEAR(editor.radius_value(), 0.1, 1e-12);
}

TEST_F(BrushTest, ALengthInModelUnitsIsKeptAsFarAsTheObjectAllows) {
    write("large.obj", kLarge);
    auto editor = this->editor();
    set_unit(editor, RadiusUnit::model);
    editor.set_radius_value(0.5);
    editor.document().open(path("large.obj"));
    EXPECT_EQ(session_radius(editor), 0.5);
    editor.document().new_shape(command::Shape::Kind::sphere, 2);
    editor.set_radius_value(0.01);
    editor.document().open(path("large.obj"));
    EXPECT_EQ(session_radius(editor), editor.min_radius());
}

TEST_F(BrushTest, ARadiusOnTheScreenFollowsTheZoomAtThePressAndIsRecordedBeforeTheDrag) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    set_unit(editor, RadiusUnit::screen);
    editor.set_radius_value(80.0);
    std::vector<double> radii;
    for (int i = 0; i < 2; ++i) {
        move(editor, kMiddle);
        const double pixel = editor.view().pixel_length(editor.hover()->point);
        EXPECT_NEAR(editor.radius(), 80.0 * pixel, 1e-12);
        drag(editor, kMiddle, kMiddle + Vec2(8, -6));
        EXPECT_NEAR(session_radius(editor), 80.0 * pixel, 1e-12);
        radii.push_back(session_radius(editor));
        for (int k = 0; k < 3; ++k) editor.handle(event::Scroll{1.0, kMiddle});
    }
    EXPECT_LT(radii[1], 0.95 * radii[0]) << "nearer, so smaller on the object";
    EXPECT_EQ(replayed("record.jsonl").mesh(), editor.session().mesh());
    EXPECT_EQ(*replayed("record.jsonl").lattice_settings().radius, radii[1]);
}

TEST_F(BrushTest, ChangingTheUnitKeepsTheRadius) {
    auto editor = this->editor();
    move(editor, kMiddle);
    editor.set_radius_value(0.2);
    editor.advance();
    const double radius = editor.radius();
    for (const RadiusUnit unit :
         {RadiusUnit::screen, RadiusUnit::model, RadiusUnit::screen, RadiusUnit::share}) {
        set_unit(editor, unit);
        editor.advance();
        EXPECT_NEAR(editor.radius(), radius, 1e-12);
    }
    EXPECT_NEAR(editor.radius_value(), 0.2, 1e-12);
}

TEST_F(BrushTest, BracketsAndFWorkInEachUnitWithinItsLimits) {
    auto editor = this->editor();
    for (const RadiusUnit unit : {RadiusUnit::share, RadiusUnit::model, RadiusUnit::screen}) {
        move(editor, kMiddle);
        set_unit(editor, unit);
        editor.advance();
        const double before = editor.radius_value();
        editor.handle(event::Character{']'});
        EXPECT_GT(editor.radius_value(), 1.1 * before);
        editor.handle(event::Character{'['});
        EXPECT_NEAR(editor.radius_value(), before, 1e-9 * before);
        move(editor, kMiddle);
        editor.handle(event::KeyDown{Key{'F'}});
        move(editor, kMiddle + Vec2(160, 0));
        EXPECT_NEAR(editor.radius_value(), 2.0 * before, 1e-9 * before);
        move(editor, kMiddle + Vec2(1e5, 0));
        EXPECT_EQ(editor.radius_value(), editor.radius_range().most);
        move(editor, kMiddle - Vec2(1e5, 0));
        EXPECT_EQ(editor.radius_value(), editor.radius_range().least);
        key(editor, Key::escape);
        editor.handle(event::KeyUp{Key{'F'}});
        EXPECT_NEAR(editor.radius_value(), before, 1e-9 * before);
    }
}

TEST_F(BrushTest, ALossOfFocusKeepsTheRadiusThatIsBeingSetAndEndsTheTool) {
    auto editor = this->editor();
    move(editor, kMiddle);
    const double before = editor.radius();
    editor.handle(event::KeyDown{Key{'F'}});
    move(editor, kMiddle + Vec2(160, 0));
    editor.handle(event::Focus{false});
    EXPECT_FALSE(editor.is_setting_radius());
    EXPECT_NEAR(session_radius(editor), 2.0 * before, 1e-9);
    move(editor, kMiddle + Vec2(320, 0));
    EXPECT_NEAR(editor.radius(), 2.0 * before, 1e-9);
}

TEST_F(BrushTest, ALossOfFocusEndsADragAndForgetsModifiersAndTheTurningOfTheView) {
    auto editor = this->editor();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(20, -30), {.alt = true});
    editor.handle(event::Focus{false});
    EXPECT_FALSE(editor.is_dragging());
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_EQ(editor.pointer().modifiers, Modifiers{});
    press(editor, kBeside);
    editor.handle(event::Focus{false});
    const Camera before = editor.camera();
    move(editor, kBeside + Vec2(50, -50));
    EXPECT_EQ(editor.camera(), before);
}

TEST_F(BrushTest, WithACageNothingChangesTheBrush) {
    auto editor = this->editor();
    editor.set_cage(editor.workspace().box(), IVec3{3});
    const double before = editor.radius();
    move(editor, kMiddle);
    for (const char bracket : {'[', ']'}) {
        editor.handle(event::Character{static_cast<unsigned char>(bracket)});
    }
    editor.handle(event::KeyDown{Key{'F'}});
    move(editor, kMiddle + Vec2(160, 0));
    editor.handle(event::KeyUp{Key{'F'}});
    editor.set_radius_unit(RadiusUnit::screen);
    EXPECT_TRUE(editor.has_cage());
    EXPECT_EQ(editor.radius(), before);
    EXPECT_EQ(editor.brush_size().unit, RadiusUnit::share);
}

// --- Rings, tint and lattice

double offset_weight(const Editor& editor, const Vec3& point, const Vec3& centre) {
    return editor.brush_profile().weight((point - centre) / editor.radius());
}

TEST_F(BrushTest, TheRingsAreWhereMotionEndsAndWhereItIsHalfAlsoInTheMirror) {
    for (const Falloff falloff : {Falloff::sharp, Falloff::plateau}) {
        auto editor = this->editor();
        editor.set_symmetry(true);
        editor.execute(command::Brush{.radius = 0.4, .span = 4, .falloff = falloff});
        move(editor, kMiddle + Vec2(90, 20));
        const Overlay overlay = editor_scene(editor, 1.0f).overlay;
        const Vec3 centre = editor.hover()->point;
        const Vec3 image = editor.session().symmetry()->image(centre);
        int ends = 0, halves = 0, mirrored = 0;
        for (const Overlay::Line& line : overlay.lines) {
            const double here = offset_weight(editor, line.from, centre);
            const double there = offset_weight(editor, line.from, image);
            ends += std::abs(here - kEndOfMotion) < 1e-5 ? 1 : 0;
            halves += std::abs(here - 0.5) < 1e-5 ? 1 : 0;
            mirrored += std::abs(there - 0.5) < 1e-5 || std::abs(there - kEndOfMotion) < 1e-5;
        }
        EXPECT_GE(ends, 96);
        EXPECT_GE(halves, 96);
        EXPECT_GE(mirrored, 192);
    }
}

TEST_F(BrushTest, DuringADragTheInnerRingHasMovedHalfAsFarAsThePoint) {
    auto editor = this->editor();
    editor.drag_options.fold_free = false;
    editor.set_radius(0.5);
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(30, -20));
    const command::Drag drag = editor.session().active_drag();
    const Vec3 from = drag.moves.front().from, d = drag.moves.front().to - from;
    const Overlay overlay = editor_scene(editor, 1.0f).overlay;
    int ends = 0, halves = 0;
    for (const Overlay::Line& line : overlay.lines) {
        ends += std::abs(offset_weight(editor, line.from, from) - kEndOfMotion) < 1e-5 ? 1 : 0;
        halves += std::abs(offset_weight(editor, line.from - 0.5 * d, from) - 0.5) < 1e-5 ? 1 : 0;
    }
    EXPECT_EQ(ends, 96);
    EXPECT_EQ(halves, 96);
}

TEST_F(BrushTest, DragsShowTheirLatticeOnlyIfThatIsSwitchedOn) {
    auto editor = this->editor();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(30, -20));
    const std::size_t without = editor_scene(editor, 1.0f).overlay.points.size();
    EXPECT_LT(without, 10u);
    key(editor, Key::escape);
    editor.perform(Action::toggle_drag_lattice);
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(30, -20));
    EXPECT_GT(editor_scene(editor, 1.0f).overlay.points.size(), without + 26);
}

TEST_F(BrushTest, TheSurfaceIsTintedOnlyWhileTheRadiusIsBeingSet) {
    auto editor = this->editor();
    move(editor, kMiddle);
    EXPECT_FALSE(editor_scene(editor, 1.0f).tint);
    editor.handle(event::KeyDown{Key{'F'}});
    move(editor, kMiddle + Vec2(80, 0));
    const auto tint = editor_scene(editor, 1.0f).tint;
    ASSERT_TRUE(tint);
    EXPECT_EQ(tint->centre, editor.hover()->point);
    EXPECT_EQ(tint->radius, editor.radius());
    EXPECT_EQ(tint->samples.data(), editor.brush_profile().samples().data());
    editor.handle(event::KeyUp{Key{'F'}});
    EXPECT_FALSE(editor_scene(editor, 1.0f).tint);
    // A slider is beside the viewport, so the middle of the window shows the radius.
    editor.handle(event::Leave{});
    editor.radius_preview = 0.4;
    editor.advance();
    ASSERT_TRUE(editor_scene(editor, 1.0f).tint);
    EXPECT_NEAR(editor_scene(editor, 1.0f).tint->radius, 0.4 * editor.workspace().diagonal(), 1e-9);
}

// --- Strength and keys during drags

class DragKeysTest : public EditorTest {
  protected:
    PreparedEditor prepared() const {
        return prepared_editor(Recorder(path("record.jsonl")), 3, [](Editor& editor) {
            editor.drag_options = {};
            editor.set_radius(0.6);
        });
    }
    Vec3 recorded_displacement() const {
        const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
        return drag.moves.front().to - drag.moves.front().from;
    }
};

TEST_F(DragKeysTest, StrengthIsHowMuchOfTheCursorsWayThePointFollows) {
    auto editor = prepared();
    drag(editor, kMiddle, kMiddle + Vec2(40, -30));
    const Vec3 whole = recorded_displacement();
    key(editor, Key{'Z'}, {.control = true});
    editor.drag_strength = 0.25;
    drag(editor, kMiddle, kMiddle + Vec2(40, -30));
    EXPECT_LT(glm::distance(recorded_displacement(), 0.25 * whole), 1e-12);
    EXPECT_GT(glm::length(whole), 0.1);
}

TEST_F(DragKeysTest, LettersKeepTheDragToAnAxisAndWithShiftToAPlane) {
    auto editor = prepared();
    const auto displacement = [&] {
        editor.advance();
        const Move& move = editor.session().active_drag().moves.front();
        return move.to - move.from;
    };
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(60, -40));
    const Vec3 free = displacement();
    EXPECT_GT(std::min({std::abs(free.x), std::abs(free.y), std::abs(free.z)}), 1e-3);
    for (int axis = 0; axis < 3; ++axis) {
        const Key letter{'X' + axis};
        key(editor, letter);
        const Vec3 along = displacement();
        EXPECT_GT(std::abs(along[axis]), 1e-3) << axis;
        for (int other = 0; other < 3; ++other) {
            if (other != axis) {
                EXPECT_EQ(along[other], 0.0) << axis;
            }
        }
        key(editor, letter, {.shift = true});
        const Vec3 across = displacement();
        EXPECT_EQ(across[axis], 0.0) << axis;
        EXPECT_GT(std::abs(across[(axis + 1) % 3]), 1e-3) << axis;
        key(editor, letter, {.shift = true});
        EXPECT_LT(glm::distance(displacement(), free), 1e-12) << "the same key takes it back";
    }
    EXPECT_FALSE(editor.session().symmetry()) << "X is no action during a drag";
    editor.handle(event::Release{MouseButton::left, kMiddle});
    EXPECT_EQ(editor.session().undo_count(), 1u);
}

TEST_F(DragKeysTest, ATypedNumberIsTheDistanceAndEnterAccepts) {
    auto editor = prepared();
    const Camera camera = editor.camera();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(30, -10));
    type(editor, "x0.25");
    EXPECT_EQ(editor.status_hint(), "Distance along X: 0.25|  (Enter accepts, Esc gives back)");
    move(editor, kMiddle + Vec2(-80, 60));
    key(editor, Key::enter);
    EXPECT_FALSE(editor.is_dragging());
    EXPECT_LT(glm::distance(recorded_displacement(), Vec3(0.25, 0, 0)), 1e-12);
    editor.handle(event::Release{MouseButton::left, kMiddle});
    EXPECT_EQ(editor.session().undo_count(), 1u);
    EXPECT_EQ(editor.camera(), camera) << "the point is no action during a drag";
    EXPECT_EQ(replayed("record.jsonl").mesh(), editor.session().mesh());
}

TEST_F(DragKeysTest, MinusAndBackspaceEditTheDistance) {
    auto editor = prepared();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(30, -10));
    type(editor, "z-0,34");
    key(editor, Key::backspace);
    EXPECT_NE(editor.status_hint().find("Z: −0.3|"), std::string_view::npos);
    key(editor, Key::enter);
    EXPECT_LT(glm::distance(recorded_displacement(), Vec3(0, 0, -0.3)), 1e-12);
}

TEST_F(DragKeysTest, WithoutAnAxisTheDistanceGoesAlongThePresentDirectionOrTheNormal) {
    auto editor = prepared();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(50, -20));
    const Move before = editor.session().active_drag().moves.front();
    type(editor, "0.2");
    move(editor, kMiddle + Vec2(-70, 90));
    key(editor, Key::enter);
    const Vec3 direction = glm::normalize(before.to - before.from);
    EXPECT_LT(glm::distance(recorded_displacement(), 0.2 * direction), 1e-12);
    key(editor, Key{'Z'}, {.control = true});
    const Vec3 normal = editor.workspace().session().pick(editor.ray_through_cursor())->normal;
    press(editor, editor.pointer().at);
    type(editor, ".1");
    key(editor, Key::enter);
    EXPECT_LT(glm::distance(recorded_displacement(), 0.1 * normal), 1e-12);
}

TEST_F(DragKeysTest, EscapeGivesBackAlsoATypedDrag) {
    auto editor = prepared();
    const TriMesh before = editor.session().mesh();
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(50, -20));
    type(editor, "y0.4");
    key(editor, Key::escape);
    EXPECT_EQ(editor.session().mesh(), before);
    EXPECT_EQ(editor.session().undo_count(), 0u);
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(50, -20));
    EXPECT_EQ(editor.status_hint().find("Distance"), std::string_view::npos)
        << "the constraint has ended with its drag";
    key(editor, Key::escape);
}

// The way that a fold-free drag has gone before is taken back, so that the result is straight.
TEST_F(DragKeysTest, AConstraintStraightensAFoldFreeDrag) {
    auto editor = prepared();
    editor.drag_options = {.connected = true, .fold_free = true};
    editor.set_radius(0.3);
    press(editor, kMiddle);
    for (int i = 1; i <= 12; ++i) move(editor, kMiddle + Vec2(0, 20 * i));
    ASSERT_FALSE(editor.session().active_drag().via.empty());
    type(editor, "z1.5");
    key(editor, Key::enter);
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    const Vec3 from = drag.moves.front().from;
    EXPECT_LT(glm::distance(drag.moves.front().to, from + Vec3(0, 0, 1.5)), 1e-12);
    for (const Vec3& waypoint : drag.via) {
        EXPECT_LT(std::hypot(waypoint.x - from.x, waypoint.y - from.y), 1e-12);
    }
    EXPECT_EQ(replayed("record.jsonl").mesh(), editor.session().mesh());
}

TEST_F(DragKeysTest, WithSymmetryAPointOnThePlaneStaysOnItWhateverIsTyped) {
    auto editor = prepared();
    editor.set_symmetry(true);
    editor.perform(Action::view_front);
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(2, -20));
    type(editor, "x0.3");
    key(editor, Key::enter);
    EXPECT_EQ(editor.session().undo_count(), 0u) << "it cannot move along x at all";
}

TEST_F(DragKeysTest, EnterAlsoAcceptsADragOfControlPoints) {
    auto editor = prepared();
    editor.set_cage(editor.workspace().box(), IVec3{3});
    editor.display.lattice = true;
    editor.advance();
    const Vec2 corner =
        *editor.camera().project(editor.editable_cage()->rest(IVec3{3, 3, 3}), kSize);
    press(editor, corner);
    move(editor, corner + Vec2(30, -20));
    ASSERT_TRUE(editor.is_dragging());
    key(editor, Key::enter);
    EXPECT_FALSE(editor.is_dragging());
    EXPECT_EQ(editor.session().undo_count(), 1u);
}

TEST_F(DragKeysTest, ControlPointsAreKeptToAnAxisAndATypedDistance) {
    auto editor = prepared();
    editor.set_cage(editor.workspace().box(), IVec3{3});
    editor.display.lattice = true;
    editor.advance();
    const IVec3 index{3, 3, 3};
    const Vec3 rest = editor.editable_cage()->rest(index);
    const Vec2 corner = *editor.camera().project(rest, kSize);
    press(editor, corner);
    type(editor, "y0.5");
    EXPECT_EQ(editor.status_hint(), "Distance along Y: 0.5|  (Enter accepts, Esc gives back)");
    key(editor, Key::enter);
    const auto control = std::get<command::Control>(last_of("record.jsonl"));
    ASSERT_EQ(control.points.size(), 1u);
    EXPECT_LT(glm::distance(control.points.front().to, rest + Vec3(0, 0.5, 0)), 1e-12);
    press(editor, corner);
    move(editor, corner + Vec2(30, -20));
    key(editor, Key{'X'}, {.shift = true});
    key(editor, Key::enter);
    const Vec3 to = std::get<command::Control>(last_of("record.jsonl")).points.front().to;
    EXPECT_EQ(to.x, rest.x);
    EXPECT_GT(glm::distance(to, rest), 0.05);
}

// --- Repetition

TEST_F(DragKeysTest, RepeatLastPullsOutwardsWhereTheCursorIs) {
    auto editor = prepared();
    EXPECT_FALSE(info_of(Action::repeat_drag).is_enabled(editor));
    press(editor, kMiddle);
    editor.handle(event::Scroll{2.0, kMiddle});
    type(editor, "0.2");
    key(editor, Key::enter);
    const auto first = std::get<command::Drag>(last_of("record.jsonl"));
    move(editor, kMiddle + Vec2(120, 60));
    const Pick there = *editor.workspace().session().pick(editor.ray_through_cursor());
    key(editor, Key{'R'}, {.shift = true});
    ASSERT_EQ(editor.session().undo_count(), 2u) << editor.workspace().message();
    const auto second = std::get<command::Drag>(last_of("record.jsonl"));
    const Move& move = second.moves.front();
    EXPECT_LT(glm::distance(move.from, there.point), 1e-12);
    EXPECT_LT(glm::distance(move.to, there.point + 0.2 * there.normal), 1e-9);
    ASSERT_TRUE(move.twist);
    EXPECT_EQ(move.twist->degrees, first.moves.front().twist->degrees);
    EXPECT_LT(glm::distance(glm::normalize(move.twist->axis), there.normal), 1e-9);
    EXPECT_EQ(replayed("record.jsonl").mesh(), editor.session().mesh());
}

TEST_F(DragKeysTest, RepeatLastTurnsDirectionsWithinTheSurfaceAsLittleAsPossible) {
    auto editor = prepared();
    editor.perform(Action::view_front);
    press(editor, kMiddle);
    move(editor, kMiddle + Vec2(0, -30));
    editor.handle(event::Release{MouseButton::left, kMiddle});
    editor.advance();
    const Vec3 up = recorded_displacement();
    EXPECT_NEAR(up.y, glm::length(up), 1e-9);
    editor.perform(Action::undo);
    move(editor, kMiddle + Vec2(100, 0));
    key(editor, Key{'R'}, {.shift = true});
    const Vec3 repeated = recorded_displacement();
    EXPECT_NEAR(glm::length(repeated), glm::length(up), 1e-9);
    EXPECT_GT(repeated.y, 0.98 * glm::length(up)) << "the normal turns about the y axis";
}

TEST_F(DragKeysTest, RepeatLastIsNotForAnotherObjectNorForACage) {
    auto editor = prepared();
    drag(editor, kMiddle, kMiddle + Vec2(30, -20));
    move(editor, kMiddle);
    EXPECT_TRUE(info_of(Action::repeat_drag).is_enabled(editor));
    editor.set_cage(editor.workspace().box(), IVec3{3});
    EXPECT_FALSE(info_of(Action::repeat_drag).is_enabled(editor));
    editor.perform(Action::undo);
    editor.document().new_shape(command::Shape::Kind::cube, 4);
    editor.set_radius(0.5);
    EXPECT_FALSE(info_of(Action::repeat_drag).is_enabled(editor));
}

}  // namespace
}  // namespace pectin
