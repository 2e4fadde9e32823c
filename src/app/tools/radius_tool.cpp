// Setting of the brush's radius, in whatever unit it has: while F is held, it follows the mouse.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/tools/brush_rings.h"
#include "app/tools/tool.h"

namespace pectin {
namespace {

constexpr Key kKey{'F'};
// The radius doubles when the mouse moves by this many pixels.
constexpr double kPixelsPerDoubling = 160.0;
constexpr Colour kRing{255, 214, 64, 255};
constexpr std::array<InputReference, 3> kInputs{{
    {"Hold F and move the mouse", "Sets the radius of the brush."},
    {"Release F, or click", "Keeps the new radius."},
    {"Esc or right button, with F held", "Restores the radius."},
}};

// Releasing F, a press of the left button or a loss of the focus keeps the radius. Esc or a press
// of another button restores it.
class RadiusTool final : public Tool {
  public:
    bool key(ToolContext& context, const event::KeyDown& key) override;
    bool is_active() const override { return drag_.has_value(); }
    void move(ToolContext& context) override;
    bool press(ToolContext& context, MouseButton button) override;
    void key_up(ToolContext& context, Key key) override;
    void lose_focus(ToolContext& context) override { keep(context); }
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
    if (key.key != kKey || key.modifiers != Modifiers{} || context.has_cage()) return false;
    if (key.is_repeat || is_active()) return true;
    const double radius = context.radius_value();
    drag_ = Drag{context.pointer().at.x, radius};
    context.radius_being_set = radius;
    return true;
}

void RadiusTool::move(ToolContext& context) {
    const double doublings = (context.pointer().at.x - drag_->start_x) / kPixelsPerDoubling;
    context.radius_being_set =
        context.radius_range().clamped(drag_->start_radius * std::exp2(doublings));
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
    const double before = drag_->start_radius, radius = *context.radius_being_set;
    cancel(context);  // first, since settings are refused during a gesture
    if (radius != before) context.set_radius_value(radius);
}

void RadiusTool::cancel(ToolContext& context) noexcept {
    drag_.reset();
    context.radius_being_set.reset();
}

void RadiusTool::overlay(const ToolContext& context, Overlay& overlay) const {
    if (is_active()) add_brush_rings(overlay, context, kRing);
}

std::string_view RadiusTool::status_hint(const ToolContext&) const {
    if (!is_active()) return {};
    return "Move the mouse to set the radius. · Release F: keep it · Esc: as before";
}

}  // namespace

std::unique_ptr<Tool> make_radius_tool() { return std::make_unique<RadiusTool>(); }

}  // namespace pectin
