// The user interface without a window: lays out menus, panels and dialogs with Dear ImGui, and
// passes input to them and to the editor.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor.h"
#include "app/ui/controls.h"
#include "app/ui/panels.h"

struct ImDrawData;

namespace pectin {

// The desktop's clipboard, as UTF-8 text.
struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string&)> write;
};

// Owns the context of Dear ImGui. Only one instance may exist at a time.
class Interface {
  public:
    // screen_scale: of fonts and sizes, 1 on an ordinary screen. The user's preferences, which the
    // editor holds, come on top of it.
    explicit Interface(float screen_scale, Clipboard clipboard = {});
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    // What draws the pictures, as OpenGL describes it, for the window about the program.
    void set_renderer(const std::string& renderer) { panels_.set_renderer(renderer); }

    // The window's size in window coordinates and in pixels.
    void set_size(const IVec2& size, const IVec2& framebuffer_size);

    // Passes an event to the panels and to the editor. Between two frames any number of events can
    // be handled, and each finds menus and dialogs as the event before left them. For example, text
    // goes to the dialog that the key before it opened, and Enter accepts what was typed before it.
    // Cost: one layout of the panels for the last of several mouse movements in a row, and
    // kLayoutsToSettle layouts for every other event.
    void handle(Editor& editor, const InputEvent& input);

    // Lays out the panels and prepares their draw data.
    void lay_out(Editor& editor, const PictureFigures& figures);
    // Precondition: lay_out() was called, and handle() was not called since.
    const ImDrawData& draw_data() const;
    // Changes whenever the fonts are other ones, so that their texture has to be uploaded anew.
    int font_version() const { return font_version_; }
    CursorShape cursor_shape() const;
    // The entry of a menu under the cursor, also if it is disabled.
    std::optional<Action> hovered_action() const { return panels_.hovered_action(); }
    // The controls of the last layout.
    const ControlList& controls() const { return *controls_; }
    // The part of the window that no panel covered in the last layout.
    const Panels::Area& free_area() const { return panels_.free_area(); }

  private:
    void begin_layout(Editor& editor);
    void follow_preferences(const Preferences& preferences);
    static void enable_menu_keys(const Editor& editor);
    void settle(Editor& editor, int layouts);

    Clipboard clipboard_;
    std::string clipboard_text_;  // the last text given to Dear ImGui, which keeps a pointer to it
    Panels panels_;
    float screen_scale_;
    float scale_ = 0.0f;  // in force, of the screen and the user together
    Theme theme_ = Theme::dark;
    int font_version_ = 0;
    std::unique_ptr<ControlList> controls_;  // ends after the context
    PictureFigures figures_;
    Vec2 cursor_{-1.0};
    bool has_moved_ = false;  // whether the mouse has moved since the last layout
    std::chrono::steady_clock::time_point last_layout_ = std::chrono::steady_clock::now();
};

}  // namespace pectin
