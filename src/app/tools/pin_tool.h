// Setting and removing of pins by clicks, while that is switched on.
#pragma once

#include "app/tools/tool.h"

namespace pectin {

class PinTool final : public Tool {
  public:
    bool press(ToolContext& context, MouseButton button) override;
    bool escape(ToolContext& context) override;
    void overlay(const ToolContext& context, Overlay& overlay) const override;
    std::string_view status_hint(const ToolContext& context) const override;
    ShownSettings settings() const override { return {.mirror = true, .pins = true}; }
    InputGroup inputs() const override;
};

// Removes the pin under the cursor. If there is none, sets one on the surface there. Does nothing
// and returns false beside the object or if the cursor is not in the viewport.
bool toggle_pin_at_cursor(ToolContext& context);

}  // namespace pectin
