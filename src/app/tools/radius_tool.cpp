// Setting of the brush's radius: while F is held, the radius follows the mouse.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/tools/brush_circle.h"
#include "app/tools/tool.h"

namespace pectin {
namespace {

constexpr Key kKey{'F'};
// The radius doubles when the mouse moves by this many pixels.
constexpr double kPixelsPerDoubling = 160.0;
constexpr Colour kCircle{255, 214, 64, 255};
constexpr std::array<InputReference, 3> kInputs{{
    {"Hold F and move the mouse", "Sets the radius of the brush."},
    {"Release F, or click", "Keeps the new radius."},
    {"Esc or right button, with F held", "Restores the radius."},
}};

// Releasing F or a press of the left button keeps the radius. Esc or a press of another button
// restores it.
class RadiusTool final : public Tool {
  public:
    bool key(ToolContext& context, const event::KeyDown& key) override;
    bool is_active() const override { return drag_.has_value(); }
    void move(ToolContext& context) override;
    bool press(ToolContext& context, MouseButton button) override;
    void key_up(ToolContext& context, Key key) override;
    void cancel(ToolContext& context) noexcept override;

    void overlay(const ToolContext& context, Overlay& overlay) const override;
    std::string_view status_hint(const ToolContext& context) const override;
    ShownSettings settings() const override { return {.radius = true}; }
    InputGroup inputs() const override { return {"Brush radius", kInputs, 1}; }

  private:
    void keep(ToolContext& context);

    struct Drag {
        double start_x, start_radius;
    };
    std::optional<Drag> drag_;
};

bool RadiusTool::key(ToolContext& context, const event::KeyDown& key) {
    if (key.key != kKey || key.modifiers != Modifiers{}) return false;
    if (key.is_repeat || is_active()) return true;
    const double radius = context.workspace().radius();
    drag_ = Drag{context.pointer().at.x, radius};
    context.radius_being_set = radius;
    return true;
}

void RadiusTool::move(ToolContext& context) {
    const double doublings = (context.pointer().at.x - drag_->start_x) / kPixelsPerDoubling;
    context.radius_being_set = std::clamp(drag_->start_radius * std::exp2(doublings),
                                          context.min_radius(), context.max_radius());
}

bool RadiusTool::press(ToolContext& context, MouseButton button) {
    if (!is_active()) return false;
    if (button == MouseButton::left) {
        keep(context);
    } else {
        cancel(context);
    }
    return true;
}

void RadiusTool::key_up(ToolContext& context, Key key) {
    if (key == kKey) keep(context);
}

void RadiusTool::keep(ToolContext& context) {
    const double before = drag_->start_radius, radius = context.radius();
    cancel(context);  // first, since settings are refused during a gesture
    if (radius != before) context.set_radius(radius);
}

void RadiusTool::cancel(ToolContext& context) noexcept {
    drag_.reset();
    context.radius_being_set.reset();
}

void RadiusTool::overlay(const ToolContext& context, Overlay& overlay) const {
    if (is_active()) add_brush_circle(overlay, context, kCircle);
}

std::string_view RadiusTool::status_hint(const ToolContext&) const {
    if (!is_active()) return {};
    return "Move the mouse to set the radius, release F to keep it, or press Esc to restore it.";
}

}  // namespace

std::unique_ptr<Tool> make_radius_tool() { return std::make_unique<RadiusTool>(); }

}  // namespace pectin
