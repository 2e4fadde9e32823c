// The window that finds an action by its name and performs it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/editor.h"

namespace pectin {

// The actions whose name or menu fits the query, the best first; without a query all of them, in
// the order of the menus.
std::vector<Action> matching_actions(const std::string& query);

class CommandPalette {
  public:
    // Draws the window while it is open. scale: of the screen.
    void draw(Editor& editor, float scale);

  private:
    bool draw_list(const Editor& editor, const std::vector<Action>& actions);
    void move_selection(std::size_t count);

    std::string query_;
    std::size_t selected_ = 0;  // in the list
    bool has_moved_ = false;    // by a key in this frame, so that the list has to scroll
};

}  // namespace pectin
