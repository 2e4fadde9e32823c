// The menus of the window. Their entries are those of the table of actions (actions.h).
#pragma once

#include <cstddef>
#include <optional>

#include "app/actions.h"
#include "app/editor.h"

namespace pectin {

class MenuBar {
  public:
    // To be called within a main menu bar of Dear ImGui.
    void draw(Editor& editor);

    // The keys Left and Right lead from an open menu to the next one. Dear ImGui only moves within
    // menus and into their submenus. Returns whether the key does this now.
    bool take_key(Key key);

    // The entry under the cursor in the last frame, also if it is disabled.
    std::optional<Action> hovered() const { return hovered_; }

  private:
    void draw_menu(Editor& editor, Menu menu);
    void draw_submenu(Editor& editor, Menu menu);
    void draw_entries(Editor& editor, Menu menu);
    void draw_entry(Editor& editor, const ActionInfo& info);

    std::optional<Action> hovered_;
    std::optional<std::size_t> open_;       // the menu of the bar that is open
    std::optional<std::size_t> requested_;  // the menu to open
    bool is_at_submenu_ = false;            // a submenu is open, or its entry is under the cursor
};

}  // namespace pectin
