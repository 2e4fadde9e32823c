// The view of an editor: mouse presets, wheel and two fingers, the axes in the corner, views,
// framing in the part of the window between the panels, and the axis that is up.
#include "app/view_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor_scene.h"
#include "app/picture.h"
#include "app/ui/interface.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

constexpr double kPixels = 1e-3;  // tolerance
constexpr ScreenBox kFree{.from = {150, 30}, .to = {950, 770}};

class ViewControlTest : public EditorTest {
  protected:
    static void press(Editor& editor, MouseButton button, const Vec2& at, Modifiers held = {}) {
        editor.handle(event::MouseMove{at, held});
        editor.advance();
        editor.handle(event::Press{button, at, held});
    }
    static void release(Editor& editor, MouseButton button, const Vec2& at, Modifiers held = {}) {
        editor.handle(event::Release{button, at, held});
        editor.advance();
    }
    static void drag(Editor& editor, MouseButton button, const Vec2& from, const Vec2& to,
                     Modifiers held = {}) {
        press(editor, button, from, held);
        move(editor, 0.5 * (from + to), held);
        move(editor, to, held);
        release(editor, button, to, held);
    }
    // The pixel of a point of the surface, where the view has not moved yet.
    static Vec3 surface_at(Editor& editor, const Vec2& at) {
        return editor.workspace().session().pick(editor.view().ray_through(at))->point;
    }
    static void expect_pixel(const Editor& editor, const Vec3& point, const Vec2& pixel) {
        const auto seen = editor.view().project(point);
        ASSERT_TRUE(seen);
        EXPECT_NEAR(seen->x, pixel.x, kPixels);
        EXPECT_NEAR(seen->y, pixel.y, kPixels);
    }
    static Box seen_box(const Editor& editor) {
        Box box;
        for (const Vec3& point : referenced_positions(editor.session().mesh())) {
            const auto pixel = editor.view().project(point);
            EXPECT_TRUE(pixel);
            if (pixel) box.include(Vec3(*pixel, 0.0));
        }
        return box;
    }
    static void expect_framed(const Editor& editor, const ScreenBox& area) {
        const Box seen = seen_box(editor);
        EXPECT_GE(seen.min.x, area.from.x);
        EXPECT_GE(seen.min.y, area.from.y);
        EXPECT_LE(seen.max.x, area.to.x);
        EXPECT_LE(seen.max.y, area.to.y);
        const Vec2 filled = Vec2(seen.extent()) / (area.to - area.from);
        EXPECT_GT(std::max(filled.x, filled.y), 0.8);
    }
};

constexpr MouseButton kLeft = MouseButton::left, kMiddle3 = MouseButton::middle;

// --- Presets.

TEST_F(ViewControlTest, AltAndTheLeftButtonOverTheSurfaceTurnTheViewInTheMayaPresetOnly) {
    for (const MousePreset preset : kMousePresets) {
        SCOPED_TRACE(name(preset));
        auto editor = this->editor();
        editor.preferences.mouse = preset;
        const Camera before = editor.camera();
        const Vec3 point = surface_at(editor, kMiddle);
        drag(editor, kLeft, kMiddle, kMiddle + Vec2(40, 30), {.alt = true});
        const bool is_maya = preset == MousePreset::maya;
        EXPECT_EQ(editor.camera() != before, is_maya);
        EXPECT_EQ(editor.session().undo_count(), is_maya ? 0u : 1u);
        if (is_maya) expect_pixel(editor, point, kMiddle);
    }
}

TEST_F(ViewControlTest, HoldingNDragsAlongTheNormalInEveryPreset) {
    for (const MousePreset preset : kMousePresets) {
        SCOPED_TRACE(name(preset));
        auto editor = this->editor();
        editor.preferences.mouse = preset;
        const Pick pick = *editor.workspace().session().pick(editor.view().ray_through({560, 330}));
        press(editor, kLeft, {560, 330});
        editor.handle(event::KeyDown{Key{'N'}});
        move(editor, {530, 300});
        const Sculptor& sculptor = test::sculptor(editor);
        const Vec3 moved = sculptor.to() - sculptor.from();
        EXPECT_GT(glm::length(moved), 0.05);
        EXPECT_NEAR(glm::length(glm::cross(moved, pick.normal)) / glm::length(moved), 0.0, 1e-6);
        editor.handle(event::KeyUp{Key{'N'}});
        editor.advance();
        EXPECT_NEAR(glm::distance(*editor.view().project(sculptor.to()), Vec2(530, 300)), 0.0, 1.0)
            << "without N the point is under the cursor again";
    }
}

TEST_F(ViewControlTest, LosingTheFocusReleasesTheKeysThatAreHeld) {
    auto editor = this->editor();
    editor.handle(event::MouseMove{kMiddle});
    editor.handle(event::KeyDown{Key{'N'}});
    editor.handle(event::KeyDown{Key::space});
    EXPECT_TRUE(editor.pointer().along_normal);
    editor.handle(event::Focus{false});
    EXPECT_FALSE(editor.pointer().along_normal);
    const Camera before = editor.camera();
    drag(editor, kLeft, kMiddle, kMiddle + Vec2(40, 30));
    EXPECT_EQ(editor.camera(), before);
}

TEST_F(ViewControlTest, SpaceMovesTheViewAlsoOverTheSurface) {
    for (const Modifiers held :
         {Modifiers{}, Modifiers{.shift = true}, Modifiers{.control = true}}) {
        auto editor = this->editor();
        const Camera before = editor.camera();
        const Vec3 point = surface_at(editor, kMiddle);
        editor.handle(event::KeyDown{Key::space});
        drag(editor, kLeft, kMiddle, kMiddle + Vec2(40, 30), held);
        editor.handle(event::KeyUp{Key::space});
        EXPECT_NE(editor.camera(), before);
        EXPECT_EQ(editor.session().undo_count(), 0u);
        expect_pixel(editor, point, held.shift ? kMiddle + Vec2(40, 30) : kMiddle);
        drag(editor, kLeft, kMiddle, kMiddle + Vec2(40, 30));
        EXPECT_EQ(editor.session().undo_count(), 1u) << "Space is released";
    }
}

TEST_F(ViewControlTest, InTheZbrushPresetReleasingAltTurnsAPanIntoAZoom) {
    auto editor = this->editor();
    editor.preferences.mouse = MousePreset::zbrush;
    const double before = editor.camera().distance();
    press(editor, kLeft, kBeside, {.alt = true});
    move(editor, kBeside + Vec2(30, -30), {.alt = true});
    EXPECT_NEAR(editor.camera().distance(), before, 1e-9) << "pans";
    move(editor, kBeside + Vec2(30, -30));
    move(editor, kBeside + Vec2(30, -330));
    release(editor, kLeft, kBeside + Vec2(30, -330));
    EXPECT_LT(editor.camera().distance(), 0.9 * before) << "zooms";
}

// --- Orbits about what was dragged.

TEST_F(ViewControlTest, AnOrbitBesideTheObjectTurnsAboutThePointThatWasDraggedLast) {
    auto editor = this->editor();
    const Vec2 to{600, 280};
    drag(editor, kLeft, {560, 330}, to);
    ASSERT_EQ(editor.session().undo_count(), 1u);
    const Vec3 dragged = surface_at(editor, to);
    drag(editor, kLeft, kBeside, kBeside + Vec2(90, -60));
    EXPECT_NEAR(glm::distance(*editor.view().project(dragged), to), 0.0, 0.5);
}

TEST_F(ViewControlTest, AnOrbitOverTheObjectTurnsAboutThePointUnderTheCursor) {
    auto editor = this->editor();
    drag(editor, kLeft, {560, 330}, {600, 280});
    const Vec2 at{720, 450};
    const Vec3 point = surface_at(editor, at);
    drag(editor, kMiddle3, at, at + Vec2(120, 40));
    expect_pixel(editor, point, at);
}

// --- The wheel, and two fingers.

TEST_F(ViewControlTest, TheWheelZoomsAndWithShiftPansAndSidewaysPans) {
    auto editor = this->editor();
    const Vec3 point = surface_at(editor, kMiddle);
    const double distance = editor.camera().distance();
    move(editor, kMiddle);
    editor.handle(event::Scroll{0.4, kMiddle, 0.1});
    expect_pixel(editor, point, kMiddle);
    EXPECT_LT(editor.camera().distance(), distance);
    move(editor, kMiddle, {.control = true});
    editor.handle(event::Scroll{-0.4, kMiddle, 0.7});
    expect_pixel(editor, point, kMiddle);
    move(editor, kMiddle, {.shift = true});
    editor.handle(event::Scroll{0.5, kMiddle, -0.25});
    Vec2 pixel = *editor.view().project(point);
    EXPECT_NEAR(pixel.x, kMiddle.x - 12.0, 0.5) << "to the left, against the view";
    EXPECT_NEAR(pixel.y, kMiddle.y + 24.0, 0.5) << "downwards, as a page does";
    move(editor, kMiddle);
    editor.handle(event::Scroll{0.1, kMiddle, 0.25});
    pixel = *editor.view().project(point);
    EXPECT_NEAR(pixel.x, kMiddle.x, 0.5);
    EXPECT_NEAR(pixel.y, kMiddle.y + 24.0, 0.5);
}

TEST_F(ViewControlTest, TheWheelNeverTakesTheEyeThroughTheSurface) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    for (const Vec2& at : {kMiddle, Vec2(560, 330), Vec2(700, 400), kBeside, Vec2(520, 420)}) {
        move(editor, at);
        for (int i = 0; i < 150; ++i) editor.handle(event::Scroll{1.0, at});
        const Vec3 eye = editor.camera().eye;
        EXPECT_FALSE(editor.workspace().session().pick({eye, eye})) << "within the sphere";
        const double distance = *editor.workspace().session().distance_to_surface(eye);
        EXPECT_GE(distance, 0.99 * kClosest * editor.workspace().diagonal());
        for (int i = 0; i < 20; ++i) editor.handle(event::Scroll{-1.0, at});
    }
}

// --- The part of the window between the panels.

TEST_F(ViewControlTest, FramesTheObjectInThePartOfTheWindowThatIsFree) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    expect_framed(editor, kFree);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        editor.view_control().set_projection(projection);
        expect_framed(editor, kFree);
        for (const Action action : {Action::view_front, Action::view_top, Action::view_left,
                                    Action::toggle_z_up, Action::toggle_z_up}) {
            editor.perform(action);
            expect_framed(editor, kFree);
        }
    }
}

TEST_F(ViewControlTest, FollowsTheFreePartUntilTheViewIsMoved) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    const ScreenBox narrow{.from = {400, 100}, .to = {900, 600}};
    editor.set_free_area(narrow, 1.0);
    expect_framed(editor, narrow);
    move(editor, kMiddle);
    editor.handle(event::Scroll{-3.0, kMiddle});
    const Camera moved = editor.camera();
    editor.set_free_area(kFree, 1.0);
    EXPECT_EQ(editor.camera(), moved);
    editor.perform(Action::frame_all);
    expect_framed(editor, kFree);
}

TEST_F(ViewControlTest, ShowsAllControlPointsOfACage) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    const Box object = editor.workspace().box();
    const Vec3 beyond = 0.5 * object.extent();
    editor.set_cage(Box{object.min - beyond, object.max + beyond}, IVec3{3});
    editor.perform(Action::frame_all);
    const Lattice& cage = *editor.session().lattice_settings().cage;
    const IVec3 last = cage.deformable - 1;
    for (int i = 0; i < 8; ++i) {
        const IVec3 corner = last * IVec3{i % 2, i / 2 % 2, i / 4};
        const Vec2 pixel = *editor.view().project(cage.rest(corner));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(kFree.from, pixel))) << pixel.x << ' ' << pixel.y;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(pixel, kFree.to))) << pixel.x << ' ' << pixel.y;
    }
}

TEST_F(ViewControlTest, ADragKeepsThePictureWhenTheFreePartChangesMeanwhile) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    press(editor, kLeft, kMiddle);
    move(editor, kMiddle + Vec2(30, 30));
    const Camera before = editor.camera();
    editor.set_free_area({.from = {0, 0}, .to = {1000, 800}}, 1.0);
    EXPECT_EQ(editor.camera(), before);
    release(editor, kLeft, kMiddle + Vec2(30, 30));
}

TEST_F(ViewControlTest, PanelsLeaveTheObjectAndTheAxesFreeInSmallWindowsAndAtTwiceTheScale) {
    struct Case {
        IVec2 size;
        float scale;
    };
    for (const Case& c : {Case{{1280, 720}, 1.0f}, Case{{800, 600}, 1.0f}, Case{{2560, 1440}, 2.0f},
                          Case{{1600, 1200}, 2.0f}}) {
        SCOPED_TRACE(std::to_string(c.size.x) + " at scale " + std::to_string(c.scale));
        auto editor = this->editor();
        Interface interface(c.scale);
        interface.set_size(c.size, c.size);
        interface.handle(editor, event::Resize{c.size});
        for (int i = 0; i < 3; ++i) interface.lay_out(editor, {});
        // No panel takes the mouse where the object is seen, nor where the axes are.
        const auto is_free = [&](const Vec2& at) {
            interface.handle(editor, event::MouseMove{at});
            return editor.pointer().is_in_viewport;
        };
        const Box seen = seen_box(editor);
        EXPECT_GT(seen.extent().x * seen.extent().y, 0.02 * c.size.x * c.size.y);
        for (const double x : {seen.min.x, 0.5 * (seen.min.x + seen.max.x), seen.max.x}) {
            for (const double y : {seen.min.y, 0.5 * (seen.min.y + seen.max.y), seen.max.y}) {
                EXPECT_TRUE(is_free({x, y})) << x << ' ' << y;
            }
        }
        const auto axes = editor.view_control().axes();
        ASSERT_TRUE(axes);
        const auto expect_free_axes = [&] {
            for (int i = 0; i < 16; ++i) {
                const double angle = 0.3927 * i;
                EXPECT_TRUE(
                    is_free(axes->centre + axes->radius * Vec2(std::cos(angle), std::sin(angle))));
            }
        };
        expect_free_axes();
        for (const int words : {4, 12, 60}) {
            std::string message;
            for (int i = 0; i < words; ++i) message += "warning ";
            editor.workspace().set_message(message);
            for (int i = 0; i < 3; ++i) interface.lay_out(editor, {});
            SCOPED_TRACE("with a message of so many words: " + std::to_string(words));
            expect_free_axes();
            const Control* const close = interface.controls().find("×");
            ASSERT_TRUE(close);
            EXPECT_GT(close->min.x, interface.free_area().min.x);
            EXPECT_LT(close->max.x, interface.free_area().max.x);
        }
    }
}

// --- Views.

TEST_F(ViewControlTest, AViewTurnsAboutWhatWasTouchedAndKeepsTheScale) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    move(editor, {500, 350});
    const Vec3 point = surface_at(editor, {500, 350});
    for (int i = 0; i < 10; ++i) editor.handle(event::Scroll{1.0, {500, 350}});
    const double distance = editor.camera().distance();
    for (const Action action : {Action::view_right, Action::view_back, Action::view_bottom}) {
        editor.perform(action);
        expect_pixel(editor, point, {500, 350});
        EXPECT_NEAR(editor.camera().distance(), distance, 1e-9);
    }
}

TEST_F(ViewControlTest, KeysOfTheKeypadGiveTheViews) {
    auto editor = this->editor();
    struct Case {
        Key key;
        bool control;
        Vec3 forward;
    };
    for (const Case& c :
         {Case{Key::keypad_1, false, {0, 0, -1}}, Case{Key::keypad_1, true, {0, 0, 1}},
          Case{Key::keypad_3, false, {-1, 0, 0}}, Case{Key::keypad_3, true, {1, 0, 0}},
          Case{Key::keypad_7, false, {0, -1, 0}}, Case{Key::keypad_7, true, {0, 1, 0}}}) {
        key(editor, c.key, {.control = c.control});
        EXPECT_NEAR(glm::distance(editor.camera().forward(), c.forward), 0.0, 2e-4);
    }
    key(editor, Key::keypad_1);
    for (int i = 0; i < 6; ++i) key(editor, Key::keypad_6);
    EXPECT_NEAR(glm::distance(editor.camera().forward(), Vec3(-1, 0, 0)), 0.0, 1e-6)
        << "six steps to the right of 15 degrees each";
    key(editor, Key::keypad_4);
    key(editor, Key::keypad_8);
    key(editor, Key::keypad_8);
    key(editor, Key::keypad_2);
    EXPECT_NEAR(glm::degrees(std::asin(-editor.camera().forward().y)), 15.0, 1e-6);
    const double distance = editor.camera().distance();
    key(editor, Key::keypad_add);
    EXPECT_LT(editor.camera().distance(), distance);
    key(editor, Key::keypad_subtract);
    key(editor, Key::keypad_5);
    EXPECT_TRUE(editor.camera().is_orthographic());
    key(editor, Key::keypad_5);
    EXPECT_FALSE(editor.camera().is_orthographic());
}

TEST_F(ViewControlTest, DragsFollowTheCursorInOrthographicPictures) {
    auto editor = this->editor();
    editor.perform(Action::toggle_orthographic);
    // The eye may be within the object, since everything is drawn.
    for (int i = 0; i < 20; ++i) editor.handle(event::Scroll{1.0, {560, 330}});
    const Vec3 before = surface_at(editor, {560, 330});
    EXPECT_GT(glm::dot(before, editor.camera().forward()), -1.001);
    EXPECT_LT(glm::dot(before, editor.camera().forward()), 0.0) << "the front side";
    press(editor, kLeft, {560, 330});
    move(editor, {600, 300});
    const Vec3 to = test::sculptor(editor).to();
    expect_pixel(editor, to, {600, 300});
    EXPECT_NEAR(glm::dot(to - before, editor.camera().forward()), 0.0, 1e-9);
    release(editor, kLeft, {600, 300});
    EXPECT_EQ(editor.session().undo_count(), 1u);
}

// --- The axes in the corner.

TEST_F(ViewControlTest, AClickOnAnAxisLooksAlongItAndASecondClickFromTheOtherSide) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        editor.view_control().set_up_axis(up);
        for (int axis = 0; axis < 3; ++axis) {
            editor.view_control().frame_all(kFitDirection);
            const auto gizmo = editor.view_control().axes();
            ASSERT_TRUE(gizmo);
            const auto end =
                std::ranges::find(gizmo->ends, AxisEnd{axis, true}, &AxesGizmo::End::end);
            drag(editor, kLeft, end->at, end->at);
            Vec3 direction{0.0};
            direction[axis] = -1.0;
            EXPECT_NEAR(glm::distance(editor.camera().forward(), direction), 0.0, 2e-4);
            const Vec2 front = editor.view_control().axes()->ends.back().at;
            drag(editor, kLeft, front, front);
            EXPECT_NEAR(glm::distance(editor.camera().forward(), -direction), 0.0, 2e-4);
        }
    }
    EXPECT_EQ(editor.session().undo_count(), 0u);
}

TEST_F(ViewControlTest, ADragOfTheAxesTurnsTheView) {
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    const auto gizmo = editor.view_control().axes();
    ASSERT_TRUE(gizmo);
    const Camera before = editor.camera();
    const Vec2 at = gizmo->ends.back().at;
    drag(editor, kLeft, at, at + Vec2(200, 0));
    EXPECT_NE(editor.camera(), before);
    EXPECT_NEAR(editor.camera().forward().y, before.forward().y, 1e-9);
    const auto level = [](const Camera& camera) {
        return glm::normalize(Vec2(camera.forward().x, camera.forward().z));
    };
    EXPECT_NEAR(std::acos(glm::dot(level(editor.camera()), level(before))),
                std::numbers::pi * 200 / 800, 1e-6)
        << "a quarter of half a turn, not a view along an axis";
}

TEST_F(ViewControlTest, TheAxesLieInTheCornerOfTheFreePartAndPointAsTheAxesDo) {
    const Camera camera{.eye = Vec3(0, 0, 5)};
    for (const double scale : {1.0, 2.0}) {
        const auto gizmo = axes_gizmo(camera, kFree, scale);
        ASSERT_TRUE(gizmo);
        EXPECT_LT(gizmo->centre.x + gizmo->radius, kFree.to.x);
        EXPECT_GT(gizmo->centre.y - gizmo->radius, kFree.from.y);
        EXPECT_GT(gizmo->centre.x + 2.0 * gizmo->radius, kFree.to.x);
        for (const AxesGizmo::End& end : gizmo->ends) {
            EXPECT_TRUE(gizmo->contains(end.at));
            EXPECT_LE(glm::distance(end.at, gizmo->centre) + gizmo->end_radius,
                      gizmo->radius + 1e-9);
        }
        EXPECT_EQ(gizmo->ends.back().end, (AxisEnd{2, true})) << "z points to the eye";
        const auto x = std::ranges::find(gizmo->ends, AxisEnd{0, true}, &AxesGizmo::End::end);
        EXPECT_GT(x->at.x, gizmo->centre.x);
        const auto y = std::ranges::find(gizmo->ends, AxisEnd{1, true}, &AxesGizmo::End::end);
        EXPECT_LT(y->at.y, gizmo->centre.y);
        EXPECT_EQ(gizmo->end_at(x->at), x->end);
    }
    EXPECT_FALSE(axes_gizmo(camera, {.from = {0, 0}, .to = {120, 700}}, 1.0)) << "too narrow";
}

// --- The axis that is up.

TEST_F(ViewControlTest, AModelWithZUpIsShownUprightAndAnActionChangesItsAxis) {
    // A tetrahedron with its tip above z = 0, and one with its tip above y = 0.
    write("z.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write("y.obj", "v -1 0 1\nv 1 0 1\nv 0 0 -1\nv 0 3 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    auto editor = this->editor();
    editor.set_free_area(kFree, 1.0);
    const auto tip_is_up = [&](const Vec3& tip) {
        return editor.view().project(tip)->y < seen_box(editor).min.y + 1.0;
    };
    editor.document().open(path("z.obj"));
    EXPECT_EQ(editor.view_control().up_axis(), UpAxis::z);
    EXPECT_TRUE(info_of(Action::toggle_z_up).is_on(editor));
    EXPECT_TRUE(tip_is_up({0, 0, 3}));
    expect_framed(editor, kFree);
    for (const Action action :
         {Action::view_front, Action::view_right, Action::view_back, Action::view_left}) {
        editor.perform(action);
        EXPECT_TRUE(tip_is_up({0, 0, 3})) << info_of(action).name;
    }
    editor.perform(Action::toggle_z_up);
    EXPECT_FALSE(tip_is_up({0, 0, 3}));
    editor.document().open(path("y.obj"));
    EXPECT_EQ(editor.view_control().up_axis(), UpAxis::y);
    EXPECT_TRUE(tip_is_up({0, 3, 0}));
    editor.document().new_shape(command::Shape::Kind::cylinder, 8);
    EXPECT_EQ(editor.view_control().up_axis(), UpAxis::y);
}

TEST_F(ViewControlTest, APictureOfTheWindowHasItsCameraAndItsBackground) {
    struct RecordingViewport : Viewport {
        command::Screenshot last;
        Done screenshot(const TriMesh&, const std::optional<Lattice>&,
                        const command::Screenshot& screenshot) override {
            last = screenshot;
            return {};
        }
    } viewport;
    auto editor = this->editor();
    editor.workspace().set_viewport(&viewport);
    const auto save_picture = [&](const std::string& name) {
        editor.perform(Action::save_picture);
        editor.document().browser()->name = path(name);
        editor.document().accept_file();
    };
    editor.perform(Action::toggle_z_up);
    editor.perform(Action::toggle_orthographic);
    editor.perform(Action::view_left);
    save_picture("picture.png");
    EXPECT_EQ(viewport.last.camera, editor.camera());
    EXPECT_TRUE(viewport.last.camera->is_orthographic());
    EXPECT_EQ(viewport.last.camera->up, Vec3(0, 0, 1));
    EXPECT_FALSE(viewport.last.show.light);
    editor.perform(Action::toggle_light_theme);
    save_picture("light.png");
    EXPECT_TRUE(viewport.last.show.light);
}

TEST_F(ViewControlTest, ALightPictureIsDrawnAsTheLightWindow) {
    auto editor = this->editor();
    editor.preferences.theme = Theme::light;
    const command::Screenshot dark{.path = "a.png"};
    command::Screenshot light = dark;
    light.show.light = true;
    const TriMesh& mesh = editor.session().mesh();
    const Background window = editor_scene(editor, 1.0f).background;
    EXPECT_EQ(make_scene(light, mesh, {}).background.top, window.top);
    EXPECT_EQ(make_scene(light, mesh, {}).background.bottom, window.bottom);
    EXPECT_EQ(make_scene(dark, mesh, {}).background.top, Background{}.top);
    EXPECT_GT(window.bottom.x, Background{}.top.x);
}

}  // namespace
}  // namespace pectin
