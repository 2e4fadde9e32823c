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

    // The keys Left and Right lead from an open menu to the next one, unless they open, enter or
    // close a submenu. Dear ImGui moves within menus, and opens and closes submenus. Returns
    // whether the key is none of Dear ImGui's now.
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
    bool has_submenu_ = false;              // a submenu of it is open
    bool is_at_submenu_ = false;  // the entry of one is under the cursor, or the keys are there
};

}  // namespace pectin
