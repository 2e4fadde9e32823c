// The controls that the panels have laid out in the present frame: where they are, and what their
// tooltips say. Tests and whatever points at a control find it here by its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

struct Control {
    std::string name;     // its label, or what its row is called
    Vec2 min, max;        // in window coordinates; may lie outside the visible part of a panel
    std::string tooltip;  // what is shown while the cursor is over it
    bool is_enabled = true;
};

// Belongs to the Dear ImGui context that is current when it is made, and is emptied at the
// beginning of each of its frames. The context must end before it does.
class ControlList {
  public:
    ControlList();
    ControlList(const ControlList&) = delete;
    ControlList& operator=(const ControlList&) = delete;

    const std::vector<Control>& all() const { return controls_; }
    // Null if there is none of this name.
    const Control* find(std::string_view name) const;

    // Adds the item of Dear ImGui that was laid out last, if its context has a list.
    static void add_last_item(const char* name, const char* tooltip);

  private:
    std::vector<Control> controls_;
};

}  // namespace pectin
