// The menus of the window. Their entries are those of the table of actions (actions.h).
#pragma once

#include <optional>

#include "app/actions.h"
#include "app/editor.h"

namespace pectin {

class MenuBar {
  public:
    // To be called within a main menu bar of Dear ImGui.
    void draw(Editor& editor);

    // The entry under the cursor in the last frame, also if it is disabled.
    std::optional<Action> hovered() const { return hovered_; }

  private:
    void draw_menu(Editor& editor, Menu menu);
    void draw_entries(Editor& editor, Menu menu);
    void draw_entry(Editor& editor, const ActionInfo& info);

    std::optional<Action> hovered_;
};

}  // namespace pectin
