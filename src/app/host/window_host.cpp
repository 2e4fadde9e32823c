#include "app/host/window_host.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <utility>

namespace pectin {
namespace {

constexpr std::size_t kReservedEvents = 1024;

std::string last_error() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? description : "no reason given";
}

bool is_set(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && value[0] != '\0';
}

// Without these two variables, a Wayland display may still be found in XDG_RUNTIME_DIR.
bool may_have_display() {
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("XDG_RUNTIME_DIR");
}

// GLFW 3.4 tries Wayland first, and the Wayland library prints an error where there is none.
void prefer_named_display() {
#ifdef GLFW_PLATFORM
    if (is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) {
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
    }
#endif
}

WindowHost& host_of(GLFWwindow* window) {
    return *static_cast<WindowHost*>(glfwGetWindowUserPointer(window));
}

Modifiers modifiers_of(int bits) {
    return {.shift = (bits & GLFW_MOD_SHIFT) != 0,
            .control = (bits & GLFW_MOD_CONTROL) != 0,
            .alt = (bits & GLFW_MOD_ALT) != 0};
}

// The modifiers that are held now. The event of a modifier key itself does not include it yet.
Modifiers held_modifiers(GLFWwindow* window) {
    const auto is_down = [window](int left, int right) {
        return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
    };
    return {.shift = is_down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
            .control = is_down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
            .alt = is_down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

// Returns keys that have a name, such as Escape, and no character.
Key named_key_of(int key) {
    struct Named {
        int glfw;
        Key key;
    };
    static constexpr std::array kNamed{
        Named{GLFW_KEY_ESCAPE, Key::escape},
        Named{GLFW_KEY_ENTER, Key::enter},
        Named{GLFW_KEY_KP_ENTER, Key::enter},
        Named{GLFW_KEY_TAB, Key::tab},
        Named{GLFW_KEY_SPACE, Key::space},
        Named{GLFW_KEY_BACKSPACE, Key::backspace},
        Named{GLFW_KEY_INSERT, Key::insert},
        Named{GLFW_KEY_DELETE, Key::delete_key},
        Named{GLFW_KEY_LEFT, Key::left},
        Named{GLFW_KEY_RIGHT, Key::right},
        Named{GLFW_KEY_UP, Key::up},
        Named{GLFW_KEY_DOWN, Key::down},
        Named{GLFW_KEY_HOME, Key::home},
        Named{GLFW_KEY_END, Key::end},
        Named{GLFW_KEY_PAGE_UP, Key::page_up},
        Named{GLFW_KEY_PAGE_DOWN, Key::page_down},
        Named{GLFW_KEY_KP_1, Key::keypad_1},
        Named{GLFW_KEY_KP_2, Key::keypad_2},
        Named{GLFW_KEY_KP_3, Key::keypad_3},
        Named{GLFW_KEY_KP_4, Key::keypad_4},
        Named{GLFW_KEY_KP_5, Key::keypad_5},
        Named{GLFW_KEY_KP_6, Key::keypad_6},
        Named{GLFW_KEY_KP_7, Key::keypad_7},
        Named{GLFW_KEY_KP_8, Key::keypad_8},
        Named{GLFW_KEY_KP_ADD, Key::keypad_add},
        Named{GLFW_KEY_KP_SUBTRACT, Key::keypad_subtract},
        Named{GLFW_KEY_F10, Key::f10},
        Named{GLFW_KEY_F1, Key::f1},
        Named{GLFW_KEY_F3, Key::f3},
    };
    const auto found = std::find_if(kNamed.begin(), kNamed.end(),
                                    [key](const Named& named) { return named.glfw == key; });
    return found == kNamed.end() ? Key::none : found->key;
}

// Returns the key by its label. If that is not a Latin letter, the label on a US keyboard counts.
Key key_of(int key, int scancode) {
    if (const Key named = named_key_of(key); named != Key::none) return named;
    const char* const name = glfwGetKeyName(key, scancode);
    if (name && std::strlen(name) == 1) {
        return Key{std::toupper(static_cast<unsigned char>(name[0]))};
    }
    return key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? Key{key} : Key::none;
}

int glfw_shape_of(CursorShape shape) {
    switch (shape) {
        case CursorShape::arrow:
            return GLFW_ARROW_CURSOR;
        case CursorShape::text:
            return GLFW_IBEAM_CURSOR;
        case CursorShape::hand:
            return GLFW_HAND_CURSOR;
        case CursorShape::resize_horizontally:
            return GLFW_HRESIZE_CURSOR;
        case CursorShape::resize_vertically:
            return GLFW_VRESIZE_CURSOR;
    }
    return GLFW_ARROW_CURSOR;
}

std::optional<MouseButton> button_of(int button) {
    switch (button) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return MouseButton::left;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return MouseButton::middle;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return MouseButton::right;
        default:
            return std::nullopt;
    }
}

// Limits the size to the screen, whose content scale GLFW applies to it.
IVec2 fitting(const IVec2& wanted) {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    if (!monitor) return wanted;
    IVec2 at{0}, workarea{0};
    float x = 1.0f, y = 1.0f;
    glfwGetMonitorWorkarea(monitor, &at.x, &at.y, &workarea.x, &workarea.y);
    glfwGetMonitorContentScale(monitor, &x, &y);
    if (workarea.x <= 0 || workarea.y <= 0) return wanted;
    return glm::min(wanted, IVec2(Vec2(workarea) / Vec2(std::max(x, 1.0f), std::max(y, 1.0f))));
}

GLFWwindow* make_window(const std::string& title, const IVec2& wanted) {
    const IVec2 size = fitting(wanted);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // The program draws into its own framebuffer.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "pectin");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "pectin");
    return glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
}

}  // namespace

WindowHost::Library::Library() {
    std::string why = "neither DISPLAY nor WAYLAND_DISPLAY is set";
    if (may_have_display()) {
        prefer_named_display();
        if (glfwInit() == GLFW_TRUE) return;
        why = last_error();
    }
    throw ContextError("there is no display to open a window on (" + why +
                       "); start pectin in a desktop session, or do without a window: "
                       "pectin replay SCRIPT");
}

WindowHost::Library::~Library() { glfwTerminate(); }

void WindowHost::Destroy::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

WindowHost::WindowHost(const std::string& title, const IVec2& size)
    : window_(make_window(title, size)), title_(title) {
    if (!window_) {
        throw ContextError("the window needs OpenGL 3.3, and there is none (" + last_error() +
                           "); install a newer graphics driver, or libgl1-mesa-dri, which draws "
                           "without a graphics card");
    }
    glfwMakeContextCurrent(window_.get());
    gl_ = load_gl(glfwGetProcAddress);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window_.get(), 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    events_.reserve(kReservedEvents);
    taken_.reserve(kReservedEvents);
    install_callbacks();
    add(event::Resize{this->size()});
}

WindowHost::~WindowHost() = default;

// GLFW calls this through C functions, which no exception may leave. If there is no memory for more
// events than are reserved, the newest event replaces the one before, so that a button does not
// stay pressed.
void WindowHost::add(InputEvent event) noexcept {
    try {
        events_.push_back(std::move(event));
    } catch (const std::bad_alloc&) {
        events_.back() = std::move(event);
    }
}

void WindowHost::add_drop(std::span<const char*> paths) noexcept {
    try {
        add(event::Drop{{paths.begin(), paths.end()}});
    } catch (const std::bad_alloc&) {
        // The file is not opened. The user can drop it again.
    }
}

std::span<const InputEvent> WindowHost::take_events(double longest_wait) {
    if (longest_wait > 0.0 && events_.empty()) {
        glfwWaitEventsTimeout(longest_wait);
    } else {
        glfwPollEvents();
    }
    taken_.clear();
    taken_.swap(events_);
    return taken_;
}

void WindowHost::show() { glfwSwapBuffers(window_.get()); }

void WindowHost::set_title(const std::string& title) {
    if (title != title_) glfwSetWindowTitle(window_.get(), title.c_str());
    title_ = title;
}

void WindowHost::set_cursor(CursorShape shape) {
    if (cursor_shape_ == shape) return;
    cursor_shape_ = shape;
    // Null if the desktop has no such shape; GLFW then shows the arrow. GLFW frees all cursors.
    auto [entry, is_new] = cursors_.try_emplace(shape, nullptr);
    if (is_new) entry->second = glfwCreateStandardCursor(glfw_shape_of(shape));
    glfwSetCursor(window_.get(), entry->second);
}

std::string WindowHost::clipboard_text() const {
    const char* const text = glfwGetClipboardString(window_.get());
    return text ? text : "";
}

void WindowHost::set_clipboard_text(const std::string& text) {
    glfwSetClipboardString(window_.get(), text.c_str());
}

IVec2 WindowHost::size() const {
    IVec2 size{0};
    glfwGetWindowSize(window_.get(), &size.x, &size.y);
    return size;
}

IVec2 WindowHost::framebuffer_size() const {
    IVec2 size{0};
    glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
    return size;
}

float WindowHost::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_.get(), &x, &y);
    // Window coordinates that are larger than pixels already include a part of the scale.
    const int width = size().x;
    const float ratio =
        width > 0 ? static_cast<float>(framebuffer_size().x) / static_cast<float>(width) : 1.0f;
    return std::clamp(std::max(x, y) / std::max(ratio, 1.0f), 0.5f, 4.0f);
}

void WindowHost::install_callbacks() {
    glfwSetWindowUserPointer(window_.get(), this);
    listen_to_mouse();
    listen_to_keyboard();
    listen_to_window();
}

void WindowHost::listen_to_mouse() {
    GLFWwindow* const window = window_.get();
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        WindowHost& host = host_of(w);
        host.cursor_ = {x, y};
        host.add(event::MouseMove{host.cursor_, held_modifiers(w)});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (!entered) host_of(w).add(event::Leave{});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        WindowHost& host = host_of(w);
        const auto which = button_of(button);
        if (!which) return;
        if (action == GLFW_PRESS) {
            host.add(event::Press{*which, host.cursor_, modifiers_of(mods)});
        } else {
            host.add(event::Release{*which, host.cursor_, modifiers_of(mods)});
        }
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        WindowHost& host = host_of(w);
        host.add(event::Scroll{y, host.cursor_, x});
    });
}

void WindowHost::listen_to_keyboard() {
    GLFWwindow* const window = window_.get();
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        WindowHost& host = host_of(w);
        const Key which = key_of(key, scancode);
        if (is_modifier(key)) {
            host.add(event::MouseMove{host.cursor_, held_modifiers(w)});
        } else if (action == GLFW_RELEASE) {
            host.add(event::KeyUp{which});
        } else {
            host.add(event::KeyDown{which, modifiers_of(mods), action == GLFW_REPEAT});
        }
    });
    glfwSetCharCallback(
        window, [](GLFWwindow* w, unsigned int code) { host_of(w).add(event::Character{code}); });
}

void WindowHost::listen_to_window() {
    GLFWwindow* const window = window_.get();
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        host_of(w).add_drop({paths, static_cast<std::size_t>(count)});
    });
    glfwSetWindowSizeCallback(window, [](GLFWwindow* w, int width, int height) {
        host_of(w).add(event::Resize{{width, height}});
    });
    // The window was uncovered or restored, or its scale has changed. It must be drawn again.
    glfwSetWindowRefreshCallback(
        window, [](GLFWwindow* w) { host_of(w).add(event::Resize{host_of(w).size()}); });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow* w, int, int) { host_of(w).add(event::Resize{host_of(w).size()}); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        host_of(w).add(event::Focus{focused == GLFW_TRUE});
    });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides
        host_of(w).add(event::Close{});
    });
}

}  // namespace pectin
