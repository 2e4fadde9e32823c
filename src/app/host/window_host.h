// A window on the desktop with an OpenGL context, made with GLFW.
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
    // Opens the window and makes its context current. Throws ContextError, which says what to do,
    // if there is no display or no OpenGL 3.3.
    WindowHost(const std::string& title, const IVec2& size);
    ~WindowHost();
    WindowHost(const WindowHost&) = delete;
    WindowHost& operator=(const WindowHost&) = delete;

    // The reference stays valid as long as the host exists.
    const Gl& gl() const { return gl_; }

    // Returns the events since the last call. If there are none, waits for one, for at most
    // longest_wait seconds. The result is valid until the next call.
    std::span<const InputEvent> take_events(double longest_wait);
    void show();  // shows what has been drawn
    void set_title(const std::string& title);
    void set_cursor(CursorShape shape);
    std::string clipboard_text() const;  // UTF-8; empty if the clipboard holds no text
    void set_clipboard_text(const std::string& text);

    IVec2 size() const;              // in window coordinates
    IVec2 framebuffer_size() const;  // in pixels; 0 while the window is minimised
    float content_scale() const;     // scale of fonts and sizes, 1 on an ordinary screen

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
    Vec2 cursor_{0.0};  // its last position
    std::string title_;
    CursorShape cursor_shape_ = CursorShape::arrow;
    std::map<CursorShape, GLFWcursor*> cursors_;  // those that have been used
};

}  // namespace pectin
