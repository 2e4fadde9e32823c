#include "app/ui/imgui_input.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <iterator>

namespace pectin {
namespace {

// Dear ImGui 1.87 replaced the arrays of input states by a queue of changes. Debian 12 has 1.86 and
// Debian 13 has 1.90.
#define PECTIN_IMGUI_HAS_EVENTS (IMGUI_VERSION_NUM >= 18700)

#if PECTIN_IMGUI_HAS_EVENTS
constexpr ImGuiKey kNoKey = ImGuiKey_None;
#else
constexpr ImGuiKey_ kNoKey = ImGuiKey_COUNT;
#endif
using ImKey = std::remove_const_t<decltype(kNoKey)>;

// Translates the keys that text fields, menus and dialogs use.
ImKey imgui_key(Key key) {
    struct Pair {
        Key ours;
        ImKey theirs;
    };
    static constexpr std::array kPairs{
        Pair{Key::escape, ImGuiKey_Escape},
        Pair{Key::enter, ImGuiKey_Enter},
        Pair{Key::tab, ImGuiKey_Tab},
        Pair{Key::space, ImGuiKey_Space},
        Pair{Key::backspace, ImGuiKey_Backspace},
        Pair{Key::insert, ImGuiKey_Insert},
        Pair{Key::delete_key, ImGuiKey_Delete},
        Pair{Key::left, ImGuiKey_LeftArrow},
        Pair{Key::right, ImGuiKey_RightArrow},
        Pair{Key::up, ImGuiKey_UpArrow},
        Pair{Key::down, ImGuiKey_DownArrow},
        Pair{Key::home, ImGuiKey_Home},
        Pair{Key::end, ImGuiKey_End},
        Pair{Key::page_up, ImGuiKey_PageUp},
        Pair{Key::page_down, ImGuiKey_PageDown},
        Pair{Key{'A'}, ImGuiKey_A},
        Pair{Key{'C'}, ImGuiKey_C},
        Pair{Key{'V'}, ImGuiKey_V},
        Pair{Key{'X'}, ImGuiKey_X},
        Pair{Key{'Y'}, ImGuiKey_Y},
        Pair{Key{'Z'}, ImGuiKey_Z},
    };
    const auto found = std::find_if(kPairs.begin(), kPairs.end(),
                                    [key](const Pair& pair) { return pair.ours == key; });
    return found == kPairs.end() ? kNoKey : found->theirs;
}

void set_key(Key key, bool is_down) {
    const ImKey which = imgui_key(key);
    if (which == kNoKey) return;
#if PECTIN_IMGUI_HAS_EVENTS
    ImGui::GetIO().AddKeyEvent(which, is_down);
#else
    ImGui::GetIO().KeysDown[which] = is_down;
#endif
}

void set_modifiers(const Modifiers& modifiers) {
    ImGuiIO& io = ImGui::GetIO();
#if PECTIN_IMGUI_HAS_EVENTS
    io.AddKeyEvent(ImGuiMod_Shift, modifiers.shift);
    io.AddKeyEvent(ImGuiMod_Ctrl, modifiers.control);
    io.AddKeyEvent(ImGuiMod_Alt, modifiers.alt);
#else
    io.KeyShift = modifiers.shift;
    io.KeyCtrl = modifiers.control;
    io.KeyAlt = modifiers.alt;
#endif
}

void set_mouse(float x, float y) {
#if PECTIN_IMGUI_HAS_EVENTS
    ImGui::GetIO().AddMousePosEvent(x, y);
#else
    ImGui::GetIO().MousePos = ImVec2(x, y);
#endif
}
void set_mouse(const Vec2& at) { set_mouse(static_cast<float>(at.x), static_cast<float>(at.y)); }

void set_button(MouseButton button, bool is_down) {
    const int which = button == MouseButton::left    ? ImGuiMouseButton_Left
                      : button == MouseButton::right ? ImGuiMouseButton_Right
                                                     : ImGuiMouseButton_Middle;
#if PECTIN_IMGUI_HAS_EVENTS
    ImGui::GetIO().AddMouseButtonEvent(which, is_down);
#else
    ImGui::GetIO().MouseDown[which] = is_down;
#endif
}

void scroll_wheel(double sideways, double amount) {
#if PECTIN_IMGUI_HAS_EVENTS
    ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(sideways), static_cast<float>(amount));
#else
    ImGui::GetIO().MouseWheelH += static_cast<float>(sideways);
    ImGui::GetIO().MouseWheel += static_cast<float>(amount);
#endif
}

// Whether the keys move within a menu. Enter chooses there, which for Dear ImGui is Space.
bool chooses_by_keyboard() {
    return (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0 &&
           !ImGui::GetIO().WantTextInput;
}

struct PassToImGui {
    void operator()(const event::MouseMove& move) const {
        set_modifiers(move.modifiers);
        set_mouse(move.at);
    }
    // A slider that is being dragged still follows the mouse outside the window.
    void operator()(const event::Leave&) const {
        if (!ImGui::IsAnyMouseDown()) set_mouse(-FLT_MAX, -FLT_MAX);
    }
    void operator()(const event::Press& press) const {
        set_modifiers(press.modifiers);
        set_mouse(press.at);
        set_button(press.button, true);
    }
    void operator()(const event::Release& release) const {
        set_modifiers(release.modifiers);
        set_mouse(release.at);
        set_button(release.button, false);
    }
    void operator()(const event::Scroll& scroll) const {
        set_mouse(scroll.at);
        scroll_wheel(scroll.sideways, scroll.amount);
    }
    void operator()(const event::KeyDown& down) const {
        set_modifiers(down.modifiers);
        set_key(down.key, true);
        if (down.key == Key::enter) set_key(Key::space, chooses_by_keyboard());
    }
    void operator()(const event::KeyUp& up) const {
        set_key(up.key, false);
        if (up.key == Key::enter) set_key(Key::space, false);
    }
    void operator()(const event::Character& character) const {
        ImGui::GetIO().AddInputCharacter(character.code);
    }
    void operator()(const event::Focus& focus) const { ImGui::GetIO().AddFocusEvent(focus.gained); }
    void operator()(const event::Drop&) const {}
    void operator()(const event::Resize&) const {}
    void operator()(const event::Close&) const {}
};

}  // namespace

void set_up_imgui_input() {
    ImGuiIO& io = ImGui::GetIO();
    set_mouse(-FLT_MAX, -FLT_MAX);
#if PECTIN_IMGUI_HAS_EVENTS
    // Dear ImGui would spread the changes over several frames. Interface does this already.
    io.ConfigInputTrickleEventQueue = false;
#else
    // The arrays are indexed by the keys of Dear ImGui.
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
#endif
}

void feed_imgui(const InputEvent& input) { std::visit(PassToImGui{}, input); }

}  // namespace pectin
