// The controls of the brush in the panel on the right.
#include "unit/app_panels_fixture.h"

namespace pectin {
namespace {

class BrushSectionTest : public PanelsTest {
  protected:
    const LatticeSettings& settings() const { return editor_->session().lattice_settings(); }
    double diagonal() const { return editor_->workspace().diagonal(); }
    // Opens the list of units and chooses the one of this name.
    void choose_unit(const std::string& name) {
        click("Measured in");
        click(middle(*find(name)));
    }
};

TEST_F(BrushSectionTest, ItsNumbersSetRadiusControlPointsAndStrength) {
    const double radius = editor_->radius();
    drag_control("Radius", 25.0);
    EXPECT_GT(editor_->radius(), radius);
    type_into("Points per axis", "5");
    EXPECT_EQ(settings().span, 5);
    type_into("Strength", "40");
    EXPECT_DOUBLE_EQ(editor_->drag_strength, 0.4);
    EXPECT_FALSE(editor_->is_setting_radius());
}

TEST_F(BrushSectionTest, ATypedRadiusIsInTheUnitThatIsShown) {
    type_into("Radius", "12");
    EXPECT_NEAR(*settings().radius, 0.12 * diagonal(), 1e-9 * diagonal());
    choose_unit("Model units");
    EXPECT_EQ(editor_->brush_size().unit, RadiusUnit::model);
    type_into("Radius", "0.3");
    EXPECT_NEAR(*settings().radius, 0.3, 1e-12);
    choose_unit("On screen");
    EXPECT_EQ(editor_->brush_size().unit, RadiusUnit::screen);
    type_into("Radius", "60");
    EXPECT_NEAR(editor_->brush_size().pixels, 60.0, 1e-9);
}

TEST_F(BrushSectionTest, ATypedRadiusThatIsNoLengthIsRefused) {
    const double radius = editor_->radius();
    type_into("Radius", "-3");
    EXPECT_EQ(editor_->radius(), radius);
    EXPECT_NE(editor_->workspace().message().find("above 0"), std::string::npos)
        << editor_->workspace().message();
}

TEST_F(BrushSectionTest, WhileTheRadiusIsDraggedTheObjectShowsIt) {
    drag_control("Radius", 5.0);
    const double before = *settings().radius;
    const Vec2 at = reach("Radius");
    std::this_thread::sleep_for(std::chrono::milliseconds(320));  // no double click
    give(event::MouseMove{at});
    give(event::Press{MouseButton::left, at});
    give(event::MouseMove{at - Vec2{20.0, 0.0}});
    lay_out();
    EXPECT_TRUE(editor_->radius_preview);
    const double shown = editor_->radius();
    EXPECT_LT(shown, before);
    EXPECT_EQ(*settings().radius, before) << "until the button is released";
    give(event::Release{MouseButton::left, at - Vec2{20.0, 0.0}});
    lay_out();
    EXPECT_FALSE(editor_->is_setting_radius());
    EXPECT_NEAR(*settings().radius, shown, 1e-9 * diagonal());
}

TEST_F(BrushSectionTest, ItsButtonsChooseTheFalloff) {
    click("Plateau");
    EXPECT_EQ(settings().falloff, Falloff::plateau);
    EXPECT_EQ(settings().span, 5) << "fewer have no flat top";
    click("Sharp");
    EXPECT_EQ(settings().falloff, Falloff::sharp);
}

TEST_F(BrushSectionTest, TheTooltipSaysHowFarTheMotionIsHalf) {
    const auto tooltip = [&] { return find("Points per axis")->tooltip; };
    type_into("Points per axis", "1");
    EXPECT_NE(tooltip().find("0.361 of the radius"), std::string::npos) << tooltip();
    std::this_thread::sleep_for(std::chrono::milliseconds(320));  // no third click of a double one
    type_into("Points per axis", "16");
    EXPECT_NE(tooltip().find("0.111 of the radius"), std::string::npos) << tooltip();
}

TEST_F(BrushSectionTest, ItsSettingsAreDisabledWhileThereIsACage) {
    editor_->set_cage(editor_->workspace().box(), IVec3{3});
    for (const char* const name :
         {"Radius", "Measured in", "Plateau", "Points per axis", "Strength"}) {
        const Control* const control = find(name);
        ASSERT_TRUE(control) << name;
        EXPECT_FALSE(control->is_enabled) << name;
    }
}

}  // namespace
}  // namespace pectin
