#include "app/ui/example_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 520.0f;
constexpr float kButtonWidth = 6.0f;  // in heights of the font
constexpr ImGuiWindowFlags kFlags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;

bool button(const char* label, const char* explanation) {
    const bool is_pressed = ImGui::Button(label, ImVec2(kButtonWidth * ImGui::GetFontSize(), 0.0f));
    tooltip(label, explanation);
    return is_pressed;
}

}  // namespace

bool begin_example_panel(const Editor& editor, float bottom, float scale) {
    if (!editor.example().is_open()) return false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(kWidth * scale, 0.9f * display.x);
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, bottom), ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, display.y));
    ImGui::Begin("example", nullptr, kFlags);
    return true;
}

void draw_example_panel(ExamplePlayer& example) {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", example.title().c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("step %zu of %zu", example.step() + 1, example.steps().size());
    ImGui::TextWrapped("%s", example.caption().c_str());
    ImGui::Spacing();
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
