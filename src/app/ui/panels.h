// Menus, panels, dialogs and lines of text of the window, drawn with Dear ImGui.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/editor.h"
#include "app/ui/cage_panel.h"
#include "app/ui/help_windows.h"
#include "app/ui/menu_bar.h"
#include "app/ui/refine_panel.h"
#include "app/ui/tool_panel.h"

namespace pectin {

// Figures that only the renderer of the frames knows.
struct PictureFigures {
    std::size_t uploaded_bytes = 0, uploaded_ranges = 0;  // in the last frame with an upload
    std::size_t memory_bytes = 0;                         // used by the whole program
};

class Panels {
  public:
    // scale: of the screen, 1 on an ordinary one.
    // Precondition of all members: a context of Dear ImGui is current.
    explicit Panels(float scale) : scale_(scale) {}

    // To be called between ImGui::NewFrame and ImGui::Render.
    void draw(Editor& editor, const PictureFigures& figures);

    // Which input belongs to the panels, by their positions in the last frame. at: the cursor.
    UiClaims claims(const Vec2& at) const;

    // The entry of a menu under the cursor in the last frame, also if it is disabled.
    std::optional<Action> hovered_action() const { return menus_.hovered(); }

    // What draws the pictures, for the window about the program.
    void set_renderer(const std::string& renderer) { help_.set_renderer(renderer); }

  private:
    struct Area {
        Vec2 min, max;
    };
    // Claims the mouse over the ImGui window that is being drawn.
    void claim_window();

    void draw_menus(Editor& editor);
    void draw_tools(Editor& editor);
    void draw_settings(Editor& editor);
    void draw_display_settings(Editor& editor);
    void draw_status(const Editor& editor, const PictureFigures& figures);
    void begin_status_tooltip(const char* title) const;
    void tooltip_row(const char* what, const std::string& figure) const;
    void draw_frame_tooltip(const FrameFigures& frame, const PictureFigures& figures) const;
    void draw_memory_tooltip(const ObjectFigures& object, const PictureFigures& figures) const;
    float draw_drag_figures(const Editor& editor) const;
    void draw_status_text(const Editor& editor, float left);
    void draw_selection(const Editor& editor) const;
    void draw_message(Editor& editor);
    void draw_hint(const Editor& editor);
    void draw_example(Editor& editor);
    void draw_question(Editor& editor);
    void draw_recovery_question(DocumentController& document);
    float scaled(float pixels) const { return pixels * scale_; }

    float scale_;
    float menu_height_ = 0.0f, status_height_ = 0.0f;
    bool status_confirms_ = false;  // the status line shows the confirmation, and no box
    std::vector<Area> areas_;
    bool has_popup_ = false;       // whether a menu or a dialog is open
    bool has_text_field_ = false;  // whether a text field has the keyboard focus
    MenuBar menus_;
    ToolPanel tools_;
    RefinePanel refine_;
    CagePanel cage_;
    HelpWindows help_;
};

}  // namespace pectin
