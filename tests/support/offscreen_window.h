// The window of the program without a window system: an Editor with its Interface, which takes the
// same input as the window and draws the same pictures. Tests find controls by the text on them,
// as a user does, so that they do not depend on where panels are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor.h"
#include "app/ui/interface.h"
#include "render/canvas.h"

namespace pectin::test {

// A line of text on the screen, as it was drawn, in window coordinates.
struct ScreenText {
    std::string text;
    Vec2 min{0.0}, max{0.0};
    Vec2 centre() const { return 0.5 * (min + max); }
};

class OffscreenWindow {
  public:
    struct Options {
        IVec2 size{1280, 720};  // in window coordinates, which are pixels here
        float scale = 1.0f;     // of the screen
        // As for Editor: how long work on files blocks the window.
        std::chrono::milliseconds max_blocking_time = std::chrono::hours(1);
        int resolution = 4;  // of the sphere that the window begins with
    };
    OffscreenWindow();
    explicit OffscreenWindow(const Options& options);
    ~OffscreenWindow();

    Editor& editor() { return *editor_; }
    Interface& interface() { return *interface_; }
    const Interface& interface() const { return *interface_; }
    const IVec2& size() const { return size_; }
    float scale() const { return scale_; }
    std::string& clipboard() { return clipboard_; }

    // --- Input. Each call is followed by a frame, as if the user were slow.
    void give(const InputEvent& input);
    void move(const Vec2& at, Modifiers modifiers = {});
    void press(const Vec2& at, Modifiers modifiers = {}, MouseButton button = MouseButton::left);
    void release(const Vec2& at, Modifiers modifiers = {}, MouseButton button = MouseButton::left);
    void click(const Vec2& at, Modifiers modifiers = {});
    // Moves in steps, so that frames are drawn in between. The button stays down.
    void pull(const Vec2& from, const Vec2& to, Modifiers modifiers = {},
              MouseButton button = MouseButton::left);
    void drag(const Vec2& from, const Vec2& to, Modifiers modifiers = {},
              MouseButton button = MouseButton::left);
    void scroll(const Vec2& at, double notches);
    void key(Key key, Modifiers modifiers = {});
    void type(const std::string& text);  // ASCII
    void resize(const IVec2& size);
    // Handles what a frame of the window does between events.
    void frame();
    // Frames until panels that have just opened have their final size.
    void settle();

    // --- What is on the screen, as of the last frame.
    std::vector<ScreenText> texts() const;
    // Where this whole text is, or, if it is nowhere, one that contains it. The uppermost if there
    // are several.
    std::optional<Vec2> find(const std::string& text) const;
    // Clicks on the text. Returns whether it is there.
    bool click(const std::string& text);
    bool hover(const std::string& text);

  private:
    std::string clipboard_;
    IVec2 size_;
    float scale_;
    std::unique_ptr<Editor> editor_;
    std::unique_ptr<Interface> interface_;
};

// Draws offscreen windows. The context of `gl` must be current.
class WindowPainter {
  public:
    // window: whose fonts are uploaded. Another painter is needed for another window.
    WindowPainter(const Gl& gl, OffscreenWindow& window);
    ~WindowPainter();
    // Precondition: the window has had a frame.
    Image draw();

  private:
    struct Parts;
    OffscreenWindow& window_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace pectin::test
