#include "app/ui/example_panel.h"

#include <algorithm>

#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 520.0f;
constexpr float kButtonWidth = 6.0f;  // in heights of the font
constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                                    ImGuiWindowFlags_NoFocusOnAppearing;

bool button(const char* label, const char* explanation) {
    const bool is_pressed = ImGui::Button(label, ImVec2(kButtonWidth * ImGui::GetFontSize(), 0.0f));
    tooltip(label, explanation);
    return is_pressed;
}

// The height of a panel of this width in which every caption has enough space: title, caption, a
// gap and the buttons.
float height_of(const ExamplePlayer& example, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float wrap = width - 2.0f * style.WindowPadding.x;
    float caption = 0.0f;
    for (const ExampleStep& step : example.steps()) {
        caption =
            std::max(caption, ImGui::CalcTextSize(step.caption.c_str(), nullptr, false, wrap).y);
    }
    return 2.0f * style.WindowPadding.y + ImGui::GetTextLineHeight() + caption +
           3.0f * style.ItemSpacing.y + ImGui::GetFrameHeight();
}

}  // namespace

bool begin_example_panel(const Editor& editor, const ImVec2& min, const ImVec2& max, float scale) {
    if (!editor.example().is_open()) return false;
    const float width = std::min(kWidth * scale, max.x - min.x);
    const float height = std::min(height_of(editor.example(), width), max.y - min.y);
    ImGui::SetNextWindowPos(ImVec2(0.5f * (min.x + max.x), max.y), ImGuiCond_Always,
                            ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::Begin("example", nullptr, kFlags);
    return true;
}

void draw_example_panel(ExamplePlayer& example) {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", example.title().c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("step %zu of %zu", example.step() + 1, example.steps().size());
    ImGui::TextWrapped("%s", example.caption().c_str());
    ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y -
                         ImGui::GetFrameHeight());
    ImGui::BeginDisabled(example.is_at_end());
    if (button("Next", "Shows the next step, or ends the present one at once.")) example.next();
    ImGui::SameLine();
    if (button(example.plays() ? "Pause###play" : "Play###play",
               "Shows all further steps, one after the other, or waits.")) {
        example.plays() ? example.pause() : example.play();
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button("Stop", "Ends the example and leaves the object as it is. (Esc)")) example.stop();
}

}  // namespace pectin
