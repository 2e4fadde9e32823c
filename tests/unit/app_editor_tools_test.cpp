// Settings of drags: pins, symmetry, twist and scale with the wheel, fold-free drags.
#include <algorithm>

#include "app/rounded_numbers.h"
#include "app/tools/cursor_path.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

class EditorToolsTest : public EditorTest {
  protected:
    static void scroll(Editor& editor, double notches, const Vec2& at, Modifiers modifiers = {}) {
        editor.handle(event::MouseMove{at, modifiers});
        editor.handle(event::Scroll{notches, at});
        editor.advance();
    }
    static void release(Editor& editor, const Vec2& at) {
        editor.handle(event::Release{MouseButton::left, at, {}});
        editor.advance();
    }
    static void pin(Editor& editor, const Vec2& at) {
        move(editor, at);
        key(editor, Key{'P'});
    }
    // Returns the vertex nearest to a point.
    static double distance_to(const TriMesh& mesh, const Vec3& point) {
        double nearest = 1e300;
        for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
            if (!mesh.is_live(VertexId{i})) continue;
            nearest = std::min(nearest, glm::distance(mesh.position(VertexId{i}), point));
        }
        return nearest;
    }
};

TEST(CursorPath, SimplifyingKeepsOnlyBendsAndTheLastPosition) {
    const auto simplified = [](const std::vector<Vec2>& path) {
        std::vector<Vec2> kept{{7, 7}};
        simplify_path(path, 2.0, kept);
        return kept;
    };
    EXPECT_TRUE(simplified({}).empty());
    EXPECT_TRUE(simplified({{0, 0}}).empty());
    EXPECT_EQ(simplified({{0, 0}, {10, 1}, {20, -1}, {30, 0}}), (std::vector<Vec2>{{30, 0}}));
    EXPECT_EQ(simplified({{0, 0}, {10, 0}, {20, 1}, {20, 10}, {20, 30}}),
              (std::vector<Vec2>{{20, 1}, {20, 30}}));
    // The path returns to its start.
    EXPECT_EQ(simplified({{0, 0}, {10, 0}, {0, 0}}), (std::vector<Vec2>{{10, 0}, {0, 0}}));
}

TEST(RoundedNumbers, ShortenFractionsAndKeepWholeNumbers) {
    EXPECT_EQ(rounded_numbers("from (0.21176287100961724, -1.5, 1e-17) by 1234567 of 0.25."),
              "from (0.2118, -1.5, 1e-17) by 1234567 of 0.25.");
    EXPECT_EQ(rounded_numbers("-12.000004 and 3.0000001234e-12"), "-12 and 3e-12");
    EXPECT_EQ(rounded_numbers(""), "");
}

TEST_F(EditorToolsTest, TheKeyPSetsAndRemovesThePinUnderTheCursor) {
    auto editor = this->editor();
    pin(editor, kMiddle);
    ASSERT_EQ(editor.pins().points().size(), 1u);
    const auto seen = editor.camera().project(editor.pins().points()[0], kSize);
    EXPECT_NEAR(glm::distance(*seen, kMiddle), 0.0, 1e-6);
    pin(editor, kMiddle + Vec2(60, 0));
    EXPECT_EQ(editor.pins().points().size(), 2u);
    pin(editor, kMiddle + Vec2(4, 3));
    EXPECT_EQ(editor.pins().points().size(), 1u);
    pin(editor, kBeside);
    EXPECT_EQ(editor.pins().points().size(), 1u) << "beside the object there is nothing to pin";
}

TEST_F(EditorToolsTest, APinBehindTheObjectIsNotFound) {
    auto editor = this->editor();
    pin(editor, kMiddle);
    const Vec3 front = editor.pins().points()[0];
    // The camera turns half around, so that the pin lies behind the middle.
    for (int i = 0; i < 2; ++i) drag(editor, {100, 700}, {100 + 400, 700});
    pin(editor, *editor.camera().project(front, kSize));
    EXPECT_EQ(editor.pins().points().size(), 2u);
}

TEST_F(EditorToolsTest, PinnedPointsStayAndTheRecordReplaysToTheSameMesh) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    pin(editor, kMiddle + Vec2(70, 0));
    pin(editor, kMiddle + Vec2(-70, 20));
    drag(editor, kMiddle, kMiddle + Vec2(30, -50));
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    EXPECT_EQ(drag.pins.size(), 2u);
    EXPECT_TRUE(drag.connected && drag.fold_free);
    for (const Vec3& pin : editor.pins().points()) {
        const auto pick = editor.workspace().session().pick(
            editor.camera().ray_through(*editor.camera().project(pin, kSize), kSize));
        ASSERT_TRUE(pick);
        EXPECT_NEAR(glm::distance(pick->point, pin), 0.0, 0.01);
    }
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(EditorToolsTest, DraggingAPinIsRefusedWithAMessageAndChangesNothing) {
    auto editor = this->editor(), untouched = this->editor();
    pin(editor, kMiddle);
    press(editor, kMiddle + Vec2(3, 0));
    move(editor, kMiddle + Vec2(50, 50));
    EXPECT_NE(editor.workspace().message().find("pinned"), std::string::npos)
        << editor.workspace().message();
    release(editor, kMiddle + Vec2(50, 50));
    EXPECT_TRUE(editor.session().mesh() == untouched.session().mesh());
    EXPECT_EQ(editor.session().undo_count(), 0u);
}

TEST_F(EditorToolsTest, AnotherObjectAndTheMenuRemoveAllPins) {
    auto editor = this->editor();
    pin(editor, kMiddle);
    editor.document().new_shape(command::Shape::Kind::cube, 4);
    EXPECT_TRUE(editor.pins().is_empty());
    pin(editor, kMiddle);
    ASSERT_FALSE(editor.pins().is_empty());
    editor.perform(Action::remove_pins);
    EXPECT_TRUE(editor.pins().is_empty());
}

TEST_F(EditorToolsTest, WithThePinButtonOnAClickSetsAPinInsteadOfDragging) {
    auto editor = this->editor();
    editor.sets_pins = true;
    drag(editor, kMiddle, kMiddle + Vec2(60, 60));
    EXPECT_EQ(editor.pins().points().size(), 1u);
    EXPECT_EQ(editor.session().undo_count(), 0u);
    key(editor, Key::escape);
    EXPECT_FALSE(editor.sets_pins);
}

TEST_F(EditorToolsTest, TheFirstSphereIsSymmetricAndTheKeyXSwitchesSymmetry) {
    Editor editor;
    editor.begin("");
    ASSERT_TRUE(editor.session().symmetry());
    EXPECT_EQ(*editor.session().symmetry(), (MirrorPlane{0, 0.0}));
    key(editor, Key{'X'});
    EXPECT_FALSE(editor.session().symmetry());
    editor.choose_mirror({command::Symmetry::Plane::z, true});
    EXPECT_FALSE(editor.session().symmetry()) << "a choice alone switches nothing on";
    key(editor, Key{'X'});
    EXPECT_EQ(editor.session().symmetry()->axis, 2);
}

TEST_F(EditorToolsTest, TheSymmetryPlaneFollowsTheCentreOfANewObject) {
    write("aside.obj", "v 4 0 0\nv 6 0 0\nv 4 2 0\nv 4 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    auto editor = this->editor();
    editor.choose_mirror({command::Symmetry::Plane::x, true});
    editor.set_symmetry(true);
    EXPECT_NEAR(editor.session().symmetry()->at, 0.0, 1e-12);
    editor.document().open(path("aside.obj"));
    EXPECT_EQ(editor.session().symmetry()->at, 5.0);
}

TEST_F(EditorToolsTest, ASymmetricDragMovesBothSidesAndReplaysToTheSameMesh) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    editor.set_symmetry(true);
    drag(editor, kMiddle + Vec2(80, 0), kMiddle + Vec2(120, -60));
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    const Vec3 to = drag.moves.front().to, image{-to.x, to.y, to.z};
    ASSERT_GT(to.x, 0.1);
    const TriMesh& mesh = editor.session().mesh();
    EXPECT_NEAR(distance_to(mesh, to), distance_to(mesh, image), 1e-9);
    EXPECT_TRUE(replayed("record.jsonl").mesh() == mesh);
}

// The mouse cannot hit the plane exactly, and two points that lie this close could not be
// separated.
TEST_F(EditorToolsTest, APointGrabbedNearThePlaneOfSymmetrySnapsToIt) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    editor.perform(Action::view_front);
    editor.set_symmetry(true);
    drag(editor, kMiddle + Vec2(3, 0), kMiddle + Vec2(90, -60));
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    EXPECT_EQ(drag.moves.front().from.x, 0.0);
    EXPECT_EQ(drag.moves.front().to.x, 0.0);
    EXPECT_GT(drag.moves.front().to.y, 0.1);
}

TEST_F(EditorToolsTest, ADragTowardsThePlaneOfSymmetryStopsBeforeItWithoutAMessage) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    editor.perform(Action::view_front);
    editor.set_symmetry(true);
    const Vec2 from = kMiddle + Vec2(60, 0);
    drag(editor, from, from - Vec2(200, 0));
    EXPECT_TRUE(editor.workspace().message().empty()) << editor.workspace().message();
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    const double from_x = drag.moves.front().from.x, to_x = drag.moves.front().to.x;
    EXPECT_GT(to_x, 0.0);
    EXPECT_LT(to_x, 0.2 * from_x);
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(EditorToolsTest, TheWheelDuringADragTwistsAndWithShiftScales) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    const Camera before = editor.camera();
    const Vec2 end = kMiddle + Vec2(20, -30);
    press(editor, kMiddle);
    const Vec3 normal = test::sculptor(editor).normal();
    move(editor, end);
    scroll(editor, 1.0, end);
    scroll(editor, 2.0, end);
    EXPECT_NEAR(editor.figures().degrees, 15.0, 1e-12);
    scroll(editor, 2.0, end, {.shift = true});
    EXPECT_NEAR(editor.figures().scale, 1.05 * 1.05, 1e-12);
    scroll(editor, -1.0, end, {.shift = true});
    scroll(editor, -1.0, end, {.shift = true});
    EXPECT_EQ(editor.figures().scale, 1.0) << "back again is all the way back";
    scroll(editor, -1.0, end, {.shift = true});
    release(editor, end);
    EXPECT_EQ(editor.camera(), before) << "the wheel has zoomed as well";
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    ASSERT_TRUE(drag.moves.front().twist);
    EXPECT_EQ(drag.moves.front().twist->axis, normal);
    EXPECT_NEAR(drag.moves.front().twist->degrees, 15.0, 1e-12);
    EXPECT_NEAR(drag.moves.front().scale, 1.0 / 1.05, 1e-12);
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(EditorToolsTest, AFoldFreeDragFollowsTheCursorPathBetweenTwoFrames) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    editor.set_radius(0.3);
    const Vec2 corner = kMiddle + Vec2(220, 0), end = corner + Vec2(0, -220);
    press(editor, kMiddle);
    for (int i = 1; i <= 8; ++i) {
        editor.handle(event::MouseMove{kMiddle + i / 8.0 * (corner - kMiddle), {}});
    }
    for (int i = 1; i <= 8; ++i)
        editor.handle(event::MouseMove{corner + i / 8.0 * (end - corner), {}});
    editor.advance();
    EXPECT_GT(editor.figures().steps, 2u);
    release(editor, end);
    const auto drag = std::get<command::Drag>(last_of("record.jsonl"));
    double nearest = 1e300;
    for (const Vec3& waypoint : drag.via) {
        nearest =
            std::min(nearest, glm::distance(*editor.camera().project(waypoint, kSize), corner));
    }
    // A straight path would pass at a distance of 155 pixels.
    EXPECT_LT(nearest, 60.0) << drag.via.size() << " waypoints";
    EXPECT_EQ(editor.session().folded_vertices(), 0u);
    EXPECT_TRUE(replayed("record.jsonl").mesh() == editor.session().mesh());
}

TEST_F(EditorToolsTest, WithoutFoldFreeFoldedVerticesAreReported) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(0, -300));
    EXPECT_EQ(editor.figures().folded, 0u);
    EXPECT_TRUE(editor.workspace().message().empty());
    editor.perform(Action::undo);
    editor.drag_options.fold_free = false;
    drag(editor, kMiddle, kMiddle + Vec2(0, -300));
    EXPECT_GT(editor.figures().folded, 0u);
    EXPECT_NE(editor.workspace().message().find(std::to_string(editor.figures().folded)),
              std::string::npos)
        << editor.workspace().message();
    editor.perform(Action::undo);
    EXPECT_EQ(editor.figures().folded, 0u);
}

}  // namespace
}  // namespace pectin
