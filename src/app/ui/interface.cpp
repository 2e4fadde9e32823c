#include "app/ui/interface.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "app/ui/imgui_input.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

// Number of layouts after which a window that has just opened has its size, and its text field has
// the keyboard focus.
constexpr int kLayoutsToSettle = 3;
// Larger letters would need a texture that is larger than some drivers allow.
constexpr float kMostFontScale = 6.0f;
constexpr float kShortestLayout = 1e-6f;  // seconds; Dear ImGui requires a positive time

// Of several such events in a row, only the last one matters.
bool is_movement(const InputEvent& input) {
    return std::holds_alternative<event::MouseMove>(input) ||
           std::holds_alternative<event::Leave>(input) ||
           std::holds_alternative<event::Resize>(input);
}

CursorShape shape_of(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput:
            return CursorShape::text;
        case ImGuiMouseCursor_Hand:
            return CursorShape::hand;
        case ImGuiMouseCursor_ResizeEW:
            return CursorShape::resize_horizontally;
        case ImGuiMouseCursor_ResizeNS:
            return CursorShape::resize_vertically;
        default:
            return CursorShape::arrow;
    }
}

ImVec2 to_imgui(const Vec2& v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

}  // namespace

Interface::Interface(float screen_scale, Clipboard clipboard)
    : clipboard_(std::move(clipboard)), screen_scale_(screen_scale) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;  // so that an idle window draws nothing
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* user) {
        auto& self = *static_cast<Interface*>(user);
        if (self.clipboard_.read) self.clipboard_text_ = self.clipboard_.read();
        return self.clipboard_text_.c_str();
    };
    io.SetClipboardTextFn = [](void* user, const char* text) {
        auto& self = *static_cast<Interface*>(user);
        self.clipboard_text_ = text;
        if (self.clipboard_.write) self.clipboard_.write(self.clipboard_text_);
    };
    set_up_imgui_input();
    controls_ = std::make_unique<ControlList>();
    follow_preferences({});
}

Interface::~Interface() { ImGui::DestroyContext(); }

void Interface::set_size(const IVec2& size, const IVec2& framebuffer_size) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = to_imgui(Vec2(size));
    // A minimised window has no size, and nothing of it is drawn.
    if (size.x > 0 && size.y > 0) {
        io.DisplayFramebufferScale = to_imgui(Vec2(framebuffer_size) / Vec2(size));
    }
}

void Interface::handle(Editor& editor, const InputEvent& input) {
    const bool moves = is_movement(input);
    // The panels must know what is under the mouse now before they handle a press.
    if (!moves && has_moved_) settle(editor, 1);
    if (const auto* move = std::get_if<event::MouseMove>(&input)) cursor_ = move->at;
    if (const auto* resize = std::get_if<event::Resize>(&input)) {
        ImGui::GetIO().DisplaySize = to_imgui(Vec2(resize->size));
    }
    const auto* const key = std::get_if<event::KeyDown>(&input);
    if (!key || !panels_.take_key(key->key)) feed_imgui(input);
    editor.handle(input, panels_.claims(cursor_));
    if (moves) {
        has_moved_ = true;
    } else {
        settle(editor, kLayoutsToSettle);
    }
}

void Interface::settle(Editor& editor, int layouts) {
    for (int i = 0; i < layouts && !editor.document().wants_to_end(); ++i) {
        begin_layout(editor);
        ImGui::EndFrame();
    }
}

// Sets theme and sizes as the user wants them now. Precondition: no frame is being laid out.
void Interface::follow_preferences(const Preferences& preferences) {
    const float scale =
        std::min(screen_scale_ * static_cast<float>(preferences.scale), kMostFontScale);
    if (scale == scale_ && preferences.theme == theme_) return;
    apply_theme(preferences.theme, scale);
    if (scale != scale_) {
        load_fonts(scale);
        ++font_version_;
    }
    scale_ = scale;
    theme_ = preferences.theme;
}

// The keyboard moves within menus and lists that are open, and nowhere else: dialogs and the
// viewport have their own keys.
void Interface::enable_menu_keys(const Editor& editor) {
    const bool is_enabled =
        !ImGui::GetCurrentContext()->OpenPopupStack.empty() && !editor.has_dialog();
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    if (is_enabled) flags |= ImGuiConfigFlags_NavEnableKeyboard;
}

void Interface::begin_layout(Editor& editor) {
    follow_preferences(editor.preferences);
    enable_menu_keys(editor);
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<float> passed = now - std::exchange(last_layout_, now);
    ImGui::GetIO().DeltaTime = std::max(passed.count(), kShortestLayout);
    has_moved_ = false;
    ImGui::NewFrame();
    // What is behind a dialog would be dimmed gradually, but a window without input draws nothing.
    ImGui::GetCurrentContext()->DimBgRatio = ImGui::GetTopMostPopupModal() ? 1.0f : 0.0f;
    try {
        panels_.draw(editor, figures_, scale_);
    } catch (...) {
        // Ends the windows and groups that were begun, so that the next layout can begin.
        ImGui::ErrorCheckEndFrameRecover(nullptr);
        ImGui::EndFrame();
        throw;
    }
}

void Interface::lay_out(Editor& editor, const PictureFigures& figures) {
    figures_ = figures;
    begin_layout(editor);
    ImGui::Render();
}

const ImDrawData& Interface::draw_data() const { return *ImGui::GetDrawData(); }

CursorShape Interface::cursor_shape() const { return shape_of(ImGui::GetMouseCursor()); }

}  // namespace pectin
