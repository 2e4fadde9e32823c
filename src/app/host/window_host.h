// A window of the desktop with an OpenGL context, and what is done to it: GLFW.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/input_event.h"
#include "render/gl.h"

struct GLFWcursor;
struct GLFWwindow;

namespace pectin {

class WindowHost {
  public:
    // Opens the window and makes its context current. Throws ContextError, saying what to do,
    // where there is no display or no OpenGL 3.3.
    WindowHost(const std::string& title, const IVec2& size);
    ~WindowHost();
    WindowHost(const WindowHost&) = delete;
    WindowHost& operator=(const WindowHost&) = delete;

    // Stays where it is as long as the host does.
    const Gl& gl() const { return gl_; }

    // What has been done since the last call; waits for something, as many seconds as this.
    // Valid until the next call.
    std::span<const InputEvent> take_events(double longest_wait);
    void show();  // what has been drawn
    void set_title(const std::string& title);
    void set_cursor(CursorShape shape);
    std::string clipboard_text() const;  // UTF-8; empty if the clipboard holds no text
    void set_clipboard_text(const std::string& text);

    IVec2 size() const;              // in window coordinates
    IVec2 framebuffer_size() const;  // in pixels; 0 while it is an icon
    float content_scale() const;     // of fonts and style, 1 on an ordinary screen

  private:
    struct Library {
        Library();
        ~Library();
    };
    struct Destroy {
        void operator()(GLFWwindow* window) const;
    };
    void add(InputEvent event) noexcept;
    void add_drop(std::span<const char*> paths) noexcept;
    void install_callbacks();
    void listen_to_mouse();
    void listen_to_keyboard();
    void listen_to_window();

    Library library_;
    std::unique_ptr<GLFWwindow, Destroy> window_;
    Gl gl_{};
    std::vector<InputEvent> events_, taken_;
    Vec2 cursor_{0.0};  // as the cursor callback last said
    std::string title_;
    CursorShape cursor_shape_ = CursorShape::arrow;
    std::map<CursorShape, GLFWcursor*> cursors_;  // those that have been used
};

}  // namespace pectin
