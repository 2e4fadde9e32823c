#include "app/ui/theme.h"

#include <imgui.h>

#include <array>
#include <filesystem>

namespace pectin {
namespace {

constexpr float kFontPixels = 16.0f;

// The first font that exists is used. Without any, Dear ImGui's own font has Latin letters only.
constexpr std::array kFonts{
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};

// Latin, Greek, Cyrillic, dashes, quotation marks and the minus sign, as pairs of first and last.
constexpr std::array<ImWchar, 11> kGlyphs{0x20,   0x17F,  0x370,  0x3FF,  0x400, 0x4FF,
                                          0x2010, 0x2027, 0x2212, 0x2212, 0};

void add_font(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* path : kFonts) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        if (io.Fonts->AddFontFromFileTTF(path, kFontPixels * scale, nullptr, kGlyphs.data()))
            return;
    }
    ImFontConfig plain;
    plain.SizePixels = 13.0f * scale;
    io.Fonts->AddFontDefault(&plain);
}

ImVec4 grey(float value, float alpha = 1.0f) {
    return {value * 0.96f, value, value * 1.08f, alpha};
}
ImVec4 amber(float alpha) { return {0.86f, 0.62f, 0.34f, alpha}; }

void set_sizes(ImGuiStyle& style) {
    style.WindowPadding = {14.0f, 12.0f};
    style.FramePadding = {9.0f, 5.0f};
    style.ItemSpacing = {9.0f, 8.0f};
    style.ItemInnerSpacing = {7.0f, 5.0f};
    style.CellPadding = {4.0f, 4.0f};
    style.ScrollbarSize = 12.0f;
    style.GrabMinSize = 12.0f;
    style.WindowRounding = 8.0f;
    style.ChildRounding = 6.0f;
    style.FrameRounding = 5.0f;
    style.PopupRounding = 6.0f;
    style.GrabRounding = 4.0f;
    style.ScrollbarRounding = 6.0f;
    style.WindowBorderSize = 1.0f;
    style.PopupBorderSize = 1.0f;
    style.FrameBorderSize = 0.0f;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_Right;
    style.SelectableTextAlign = {0.0f, 0.5f};
    style.DisabledAlpha = 0.45f;
}

void set_colours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    ImVec4* const colours = style.Colors;
    colours[ImGuiCol_Text] = grey(0.88f);
    colours[ImGuiCol_TextDisabled] = grey(0.58f);
    colours[ImGuiCol_WindowBg] = grey(0.125f, 0.93f);
    colours[ImGuiCol_ChildBg] = grey(0.095f, 0.6f);
    colours[ImGuiCol_PopupBg] = grey(0.135f, 0.98f);
    colours[ImGuiCol_MenuBarBg] = grey(0.115f, 0.97f);
    colours[ImGuiCol_Border] = grey(0.27f, 0.7f);
    colours[ImGuiCol_FrameBg] = grey(0.205f);
    colours[ImGuiCol_FrameBgHovered] = grey(0.255f);
    colours[ImGuiCol_FrameBgActive] = grey(0.285f);
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = grey(0.155f, 0.97f);
    colours[ImGuiCol_TitleBgCollapsed] = grey(0.125f, 0.93f);
    colours[ImGuiCol_Button] = grey(0.235f);
    colours[ImGuiCol_ButtonHovered] = grey(0.305f);
    colours[ImGuiCol_ButtonActive] = amber(0.55f);
    colours[ImGuiCol_Header] = grey(0.20f);
    colours[ImGuiCol_HeaderHovered] = grey(0.265f);
    colours[ImGuiCol_HeaderActive] = grey(0.30f);
    colours[ImGuiCol_CheckMark] = amber(1.0f);
    colours[ImGuiCol_PlotHistogram] = amber(1.0f);  // progress bars
    colours[ImGuiCol_SliderGrab] = amber(0.5f);
    colours[ImGuiCol_SliderGrabActive] = amber(0.7f);
    colours[ImGuiCol_Separator] = grey(0.27f, 0.7f);
    colours[ImGuiCol_TextSelectedBg] = amber(0.35f);
    colours[ImGuiCol_NavHighlight] = amber(0.7f);
    colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.45f);
}

}  // namespace

void apply_theme(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    set_sizes(style);
    set_colours(style);
    style.ScaleAllSizes(scale);
    add_font(scale);
}

}  // namespace pectin
