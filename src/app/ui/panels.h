// Menus, panels, dialogs and lines of text of the window, drawn with Dear ImGui.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor.h"
#include "app/ui/help_windows.h"
#include "app/ui/menu_bar.h"
#include "app/ui/side_panel.h"
#include "app/ui/status_line.h"

namespace pectin {

class Panels {
  public:
    // A rectangle in window coordinates.
    struct Area {
        Vec2 min{0.0}, max{0.0};
    };

    // Precondition of all members: a context of Dear ImGui is current.

    // To be called between ImGui::NewFrame and ImGui::Render. scale: of the screen and the user
    // together, 1 on an ordinary screen.
    void draw(Editor& editor, const PictureFigures& figures, float scale);

    // Which input belongs to the panels, by their positions in the last frame. at: the cursor.
    UiClaims claims(const Vec2& at) const;

    // Whether an open menu uses the key in place of Dear ImGui.
    bool take_key(Key key);

    // The part of the window that no panel covered in the last frame.
    const Area& free_area() const { return free_; }

    // The entry of a menu under the cursor in the last frame, also if it is disabled.
    std::optional<Action> hovered_action() const { return menus_.hovered(); }

    // What draws the pictures, for the window about the program.
    void set_renderer(const std::string& renderer) { help_.set_renderer(renderer); }

  private:
    // Claims the mouse over the ImGui window that is being drawn.
    void claim_window();
    void close_menu_if_wanted(const Editor& editor);
    void draw_menus(Editor& editor);
    void draw_status(const Editor& editor, const PictureFigures& figures);
    void draw_strip(Editor& editor);
    void draw_side(Editor& editor);
    void draw_selection(const Editor& editor) const;
    Area message_space(const Editor& editor) const;
    void draw_message(Editor& editor);
    void draw_hint(const Editor& editor) const;
    void draw_example(Editor& editor);
    float scaled(float pixels) const { return pixels * scale_; }

    float scale_ = 1.0f;
    Area free_;
    std::vector<Area> areas_;
    bool has_popup_ = false;       // whether a menu or a dialog is open
    bool has_menu_ = false;        // whether a menu or a list is open
    bool closes_menu_ = false;     // whether Esc was pressed there
    bool has_text_field_ = false;  // whether a text field has the keyboard focus
    MenuBar menus_;
    SidePanel side_;
    StatusLine status_;
    HelpWindows help_;
};

}  // namespace pectin
