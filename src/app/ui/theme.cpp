#include "app/ui/theme.h"

#include <array>
#include <filesystem>
#include <span>

namespace pectin {
namespace {

constexpr float kFontPixels = 16.0f;

// The first font that exists is used. Without any, Dear ImGui's own font has Latin letters only.
constexpr std::array kTextFonts{
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};
constexpr std::array kHeadingFonts{
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Semibold.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Medium.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};
// Arrows and mathematical signs, which fonts for text often lack.
constexpr std::array kSymbolFonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansMath-Regular.ttf",
};

// Pairs of first and last. Latin, Greek, Cyrillic, dashes, quotation marks, primes, superscripts,
// the minus sign and relations.
constexpr std::array<ImWchar, 17> kTextGlyphs{0x20,   0x17F,  0x370,  0x3FF,  0x400,  0x4FF,
                                              0x2010, 0x2027, 0x2032, 0x2033, 0x2070, 0x209C,
                                              0x2212, 0x2212, 0x2260, 0x2265, 0};
constexpr std::array<ImWchar, 5> kSymbolGlyphs{0x2190, 0x21FF, 0x2200, 0x22FF, 0};

// Returns the first of the fonts, or null if none exists. With `merged` its glyphs are added to the
// font before.
ImFont* add_first(std::span<const char* const> paths, float pixels, const ImWchar* glyphs,
                  bool merged = false) {
    ImFontConfig config;
    config.MergeMode = merged;
    for (const char* path : paths) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
        if (ImFont* font = fonts.AddFontFromFileTTF(path, pixels, &config, glyphs)) return font;
    }
    return nullptr;
}

ImVec4 grey(float value, float alpha = 1.0f) {
    return {value * 0.96f, value, value * 1.08f, alpha};
}
ImVec4 amber(float alpha) { return {0.86f, 0.62f, 0.34f, alpha}; }
ImVec4 ochre(float alpha) { return {0.78f, 0.47f, 0.13f, alpha}; }
ImVec4 light_grey(float value, float alpha = 1.0f) { return {value, value, value * 1.01f, alpha}; }

void set_sizes(ImGuiStyle& style) {
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {8.0f, 4.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.ItemInnerSpacing = {7.0f, 5.0f};
    style.CellPadding = {4.0f, 3.0f};
    style.ScrollbarSize = 12.0f;
    style.GrabMinSize = 12.0f;
    style.WindowRounding = 7.0f;
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
}

// The slots of Dear ImGui's table of colours that hold those of ThemeColour. The program draws no
// plots, tables with borders or drag-and-drop targets, for which they are meant.
ImGuiCol slot_of(ThemeColour colour) {
    switch (colour) {
        case ThemeColour::warning:
            return ImGuiCol_PlotLines;
        case ThemeColour::warning_border:
            return ImGuiCol_PlotLinesHovered;
        case ThemeColour::accent:
            return ImGuiCol_PlotHistogramHovered;
        case ThemeColour::on_accent:
            return ImGuiCol_NavWindowingHighlight;
        case ThemeColour::fill:
            return ImGuiCol_TableRowBgAlt;
        case ThemeColour::selection:
            return ImGuiCol_DragDropTarget;
    }
    return ImGuiCol_Text;
}

void set_dark_colours(ImVec4* colours) {
    colours[ImGuiCol_Text] = grey(0.88f);
    colours[ImGuiCol_TextDisabled] = grey(0.60f);
    colours[ImGuiCol_WindowBg] = grey(0.130f, 0.97f);
    colours[ImGuiCol_ChildBg] = grey(0.095f, 0.6f);
    colours[ImGuiCol_PopupBg] = grey(0.145f, 0.99f);
    colours[ImGuiCol_MenuBarBg] = grey(0.110f);
    colours[ImGuiCol_Border] = grey(0.29f, 0.7f);
    colours[ImGuiCol_FrameBg] = grey(0.205f);
    colours[ImGuiCol_FrameBgHovered] = grey(0.255f);
    colours[ImGuiCol_FrameBgActive] = grey(0.285f);
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = grey(0.165f, 0.98f);
    colours[ImGuiCol_TitleBgCollapsed] = grey(0.125f, 0.93f);
    colours[ImGuiCol_Button] = grey(0.245f);
    colours[ImGuiCol_ButtonHovered] = grey(0.315f);
    colours[ImGuiCol_ButtonActive] = amber(0.55f);
    colours[ImGuiCol_Header] = grey(0.185f);
    colours[ImGuiCol_HeaderHovered] = grey(0.245f);
    colours[ImGuiCol_HeaderActive] = grey(0.28f);
    colours[ImGuiCol_CheckMark] = amber(1.0f);
    colours[ImGuiCol_PlotHistogram] = amber(1.0f);  // progress bars
    colours[ImGuiCol_SliderGrab] = amber(0.6f);
    colours[ImGuiCol_SliderGrabActive] = amber(0.8f);
    colours[ImGuiCol_Separator] = grey(0.27f, 0.7f);
    colours[ImGuiCol_TextSelectedBg] = amber(0.35f);
    colours[ImGuiCol_NavHighlight] = amber(0.7f);
    colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.45f);
    colours[slot_of(ThemeColour::warning)] = ImVec4(0.93f, 0.74f, 0.45f, 1.0f);
    colours[slot_of(ThemeColour::warning_border)] = amber(0.8f);
    colours[slot_of(ThemeColour::accent)] = ImVec4(0.66f, 0.45f, 0.20f, 1.0f);
    colours[slot_of(ThemeColour::on_accent)] = ImVec4(1.0f, 0.97f, 0.92f, 1.0f);
    colours[slot_of(ThemeColour::fill)] = ImVec4(0.43f, 0.34f, 0.23f, 1.0f);
    colours[slot_of(ThemeColour::selection)] = ImVec4(1.0f, 0.75f, 0.35f, 1.0f);
}

void set_light_colours(ImVec4* colours) {
    colours[ImGuiCol_Text] = grey(0.13f);
    colours[ImGuiCol_TextDisabled] = grey(0.42f);
    colours[ImGuiCol_WindowBg] = light_grey(0.945f, 0.98f);
    colours[ImGuiCol_ChildBg] = light_grey(0.985f, 0.8f);
    colours[ImGuiCol_PopupBg] = light_grey(0.975f, 0.995f);
    colours[ImGuiCol_MenuBarBg] = light_grey(0.90f);
    colours[ImGuiCol_Border] = light_grey(0.72f, 0.8f);
    colours[ImGuiCol_FrameBg] = light_grey(0.855f);
    colours[ImGuiCol_FrameBgHovered] = light_grey(0.815f);
    colours[ImGuiCol_FrameBgActive] = light_grey(0.79f);
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = light_grey(0.90f);
    colours[ImGuiCol_TitleBgCollapsed] = light_grey(0.92f);
    colours[ImGuiCol_Button] = light_grey(0.825f);
    colours[ImGuiCol_ButtonHovered] = light_grey(0.77f);
    colours[ImGuiCol_ButtonActive] = ochre(0.55f);
    colours[ImGuiCol_Header] = light_grey(0.885f);
    colours[ImGuiCol_HeaderHovered] = light_grey(0.84f);
    colours[ImGuiCol_HeaderActive] = light_grey(0.80f);
    colours[ImGuiCol_CheckMark] = ochre(1.0f);
    colours[ImGuiCol_PlotHistogram] = ochre(1.0f);  // progress bars
    colours[ImGuiCol_SliderGrab] = ochre(0.7f);
    colours[ImGuiCol_SliderGrabActive] = ochre(0.9f);
    colours[ImGuiCol_Separator] = light_grey(0.74f, 0.8f);
    colours[ImGuiCol_ScrollbarBg] = light_grey(0.90f, 0.6f);
    colours[ImGuiCol_ScrollbarGrab] = light_grey(0.72f);
    colours[ImGuiCol_ScrollbarGrabHovered] = light_grey(0.64f);
    colours[ImGuiCol_ScrollbarGrabActive] = light_grey(0.56f);
    colours[ImGuiCol_TextSelectedBg] = ochre(0.30f);
    colours[ImGuiCol_NavHighlight] = ochre(0.8f);
    colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0.2f, 0.2f, 0.2f, 0.30f);
    colours[slot_of(ThemeColour::warning)] = ImVec4(0.62f, 0.32f, 0.02f, 1.0f);
    colours[slot_of(ThemeColour::warning_border)] = ochre(0.9f);
    colours[slot_of(ThemeColour::accent)] = ImVec4(0.82f, 0.52f, 0.17f, 1.0f);
    colours[slot_of(ThemeColour::on_accent)] = ImVec4(1.0f, 0.99f, 0.97f, 1.0f);
    colours[slot_of(ThemeColour::fill)] = ImVec4(0.93f, 0.76f, 0.53f, 1.0f);
    colours[slot_of(ThemeColour::selection)] = ImVec4(0.72f, 0.40f, 0.05f, 1.0f);
}

}  // namespace

void apply_theme(Theme theme, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    set_sizes(style);
    if (theme == Theme::light) {
        ImGui::StyleColorsLight(&style);
        style.DisabledAlpha = 0.55f;
        set_light_colours(style.Colors);
    } else {
        ImGui::StyleColorsDark(&style);
        style.DisabledAlpha = 0.42f;
        set_dark_colours(style.Colors);
    }
    style.ScaleAllSizes(scale);
}

void load_fonts(float scale) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    const float pixels = kFontPixels * scale;
    if (add_first(kTextFonts, pixels, kTextGlyphs.data())) {
        add_first(kSymbolFonts, pixels, kSymbolGlyphs.data(), true);
        add_first(kHeadingFonts, pixels, kTextGlyphs.data());
    } else {
        ImFontConfig plain;
        plain.SizePixels = 13.0f * scale;
        fonts.AddFontDefault(&plain);
    }
    fonts.Build();
}

ImFont* heading_font() { return ImGui::GetIO().Fonts->Fonts.back(); }

ImVec4 theme_colour(ThemeColour colour) { return ImGui::GetStyleColorVec4(slot_of(colour)); }

}  // namespace pectin
