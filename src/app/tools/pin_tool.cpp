#include "app/tools/pin_tool.h"

#include <array>

namespace pectin {
namespace {

constexpr std::array<InputReference, 2> kInputs{{
    {"Click the surface, with Pin on", "Sets a pin there, or removes the one under the cursor."},
    {"Esc, with Pin on", "Switches Pin off."},
}};

}  // namespace

bool toggle_pin_at_cursor(ToolContext& context) {
    if (!context.pointer().is_in_viewport) return false;
    std::optional<Pick> pick = context.pick_at_cursor();
    if (pick) pick = context.snapped_to_symmetry_plane(*pick);
    const bool is_done = context.pins().toggle(context.view(), context.pointer().at, pick,
                                               context.session().symmetry());
    if (is_done) context.workspace().clear_command_message();
    return is_done;
}

bool PinTool::press(ToolContext& context, MouseButton button) {
    if (button != MouseButton::left || !context.sets_pins || !context.pick_at_cursor()) {
        return false;
    }
    toggle_pin_at_cursor(context);
    return true;
}

bool PinTool::escape(ToolContext& context) {
    if (!context.sets_pins) return false;
    context.sets_pins = false;
    return true;
}

void PinTool::overlay(const ToolContext& context, Overlay& overlay) const {
    const auto& plane = context.session().symmetry();
    for (const Vec3& pin : context.pins().points()) {
        add_pin(overlay, pin);
        if (plane && plane->offset(pin) != 0.0) add_pin(overlay, plane->image(pin), true);
    }
    if (context.sets_pins && context.hover()) add_pin(overlay, context.hover()->point, true);
}

std::string_view PinTool::status_hint(const ToolContext& context) const {
    if (!context.sets_pins || !context.hover()) return {};
    return "Click to set a pin, which drags leave where it is; click a pin to remove it. · Esc: "
           "done";
}

InputGroup PinTool::inputs() const { return {"Pins", kInputs, 3}; }

std::unique_ptr<Tool> make_pin_tool() { return std::make_unique<PinTool>(); }

}  // namespace pectin
