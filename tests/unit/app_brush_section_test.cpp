// The controls of the brush in the panels. They are found by trying points from top to bottom, so
// that the test does not depend on where exactly they are.
#include <functional>
#include <memory>

#include "app/ui/interface.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

// Columns of the window in which the panels have the brush.
constexpr double kLeft = 60.0;
constexpr double kTop = 40.0, kBottom = 780.0, kStep = 5.0;

class BrushSectionTest : public EditorTest {
  protected:
    void SetUp() override {
        editor_.reset(new PreparedEditor(editor()));
        interface_.set_size(kSize, kSize);
        interface_.lay_out(*editor_, {});
    }
    void give(const InputEvent& input) { interface_.handle(*editor_, input); }
    void press(const Vec2& at) {
        give(event::MouseMove{at});
        give(event::Press{MouseButton::left, at});
    }
    void release(const Vec2& at) {
        give(event::MouseMove{at});
        give(event::Release{MouseButton::left, at});
    }
    // Clicks from top to bottom until this is so. Returns the height, or nothing.
    std::optional<double> click_until(double x, const std::function<bool()>& is_done) {
        return try_until(x, x, is_done);
    }
    // The same with a drag from one place to the other.
    std::optional<double> try_until(double from, double to, const std::function<bool()>& is_done) {
        for (double y = kTop; y < kBottom; y += kStep) {
            press({from, y});
            release({to, y});
            if (is_done()) return y;
            give(event::KeyDown{Key::escape});
            give(event::KeyUp{Key::escape});
        }
        return std::nullopt;
    }
    const LatticeSettings& settings() const { return editor_->session().lattice_settings(); }

    std::unique_ptr<PreparedEditor> editor_;
    Interface interface_{1.0f, {}};
};

TEST_F(BrushSectionTest, ItsSlidersSetRadiusControlPointsAndStrength) {
    const double radius = editor_->radius();
    EXPECT_TRUE(try_until(kLeft, kLeft + 25.0, [&] { return editor_->radius() != radius; }));
    EXPECT_TRUE(try_until(kLeft, kLeft + 25.0, [&] { return settings().span != 3; }));
    EXPECT_TRUE(try_until(kLeft, kLeft - 25.0, [&] { return editor_->drag_strength < 1.0; }));
    EXPECT_FALSE(editor_->is_setting_radius());
}

TEST_F(BrushSectionTest, WhileTheRadiusSliderIsHeldTheObjectShowsIt) {
    const double radius = editor_->radius();
    const auto y = try_until(kLeft, kLeft + 25.0, [&] { return editor_->radius() != radius; });
    ASSERT_TRUE(y);
    const double before = *settings().radius;
    press({kLeft - 10.0, *y});
    give(event::MouseMove{{kLeft - 30.0, *y}});
    interface_.lay_out(*editor_, {});
    EXPECT_TRUE(editor_->radius_preview);
    EXPECT_LT(editor_->radius(), before);
    EXPECT_EQ(*settings().radius, before) << "until the button is released";
    const double shown = editor_->radius();
    release({kLeft - 30.0, *y});
    interface_.lay_out(*editor_, {});
    EXPECT_FALSE(editor_->is_setting_radius());
    EXPECT_NEAR(*settings().radius, shown, 1e-6);
}

TEST_F(BrushSectionTest, ItsButtonsChooseTheFalloff) {
    EXPECT_TRUE(click_until(kLeft, [&] { return settings().falloff == Falloff::plateau; }));
    EXPECT_TRUE(click_until(kLeft, [&] { return settings().falloff == Falloff::sharp; }));
}

TEST_F(BrushSectionTest, ItsListChoosesTheUnitOfTheRadius) {
    // A click opens the list, and the next one, below it, chooses from it.
    bool is_found = false;
    for (double y = kTop; y < kBottom && !is_found; y += kStep) {
        for (double below = 15.0; below < 80.0 && !is_found; below += 10.0) {
            for (const double at : {y, y + below}) {
                press({kLeft, at});
                release({kLeft, at});
                interface_.lay_out(*editor_, {});
            }
            is_found = editor_->brush_size().unit == RadiusUnit::screen;
            give(event::KeyDown{Key::escape});
            give(event::KeyUp{Key::escape});
            interface_.lay_out(*editor_, {});
        }
    }
    EXPECT_TRUE(is_found);
}

TEST_F(BrushSectionTest, ItsSettingsAreDisabledWhileThereIsACage) {
    editor_->set_cage(editor_->workspace().box(), IVec3{3});
    const DragOptions options = editor_->drag_options;
    for (int i = 0; i < 3; ++i) interface_.lay_out(*editor_, {});
    EXPECT_FALSE(try_until(kLeft, kLeft + 25.0, [&] {
        return !editor_->has_cage() || editor_->drag_strength < 1.0 || settings().span != 3 ||
               settings().falloff != Falloff::sharp ||
               editor_->drag_options.connected != options.connected;
    }));
}

}  // namespace
}  // namespace pectin
