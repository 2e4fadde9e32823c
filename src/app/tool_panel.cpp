#include "app/tool_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace pectin {
namespace {

constexpr float kWidth = 96.0f;
constexpr float kSliderHeight = 170.0f, kMinSliderHeight = 50.0f;
// The height of everything except the slider, in lines of buttons and of text.
constexpr float kButtonLines = 6.0f, kTextLines = 2.0f;

constexpr const char* kSymmetryHelp =
    "Drags act on both sides of a plane at once (X).\nBelow: the axis across the plane, and the "
    "plane's position.";
constexpr const char* kPinHelp =
    "While this is on, a click on the surface sets a pin. Drags leave\npinned points where they "
    "are. A click on a pin removes it.\nThe key P does the same under the cursor at any time.";
constexpr const char* kConnectedHelp =
    "Only the part of the surface that is connected to the grabbed\npoint follows, and not other "
    "parts that are near it.";
constexpr const char* kFoldFreeHelp =
    "A drag never turns space inside out: a long drag is divided\ninto steps along the cursor's "
    "path.";

// Draws a button that is highlighted while it is on. Returns whether it was pressed.
bool toggle_button(const char* label, bool is_on, float width) {
    if (is_on) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.62f, 0.42f, 0.18f, 1.0f));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(0.70f, 0.48f, 0.21f, 1.0f));
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.97f, 0.92f, 1.0f));
    }
    const bool is_pressed = ImGui::Button(label, ImVec2(width, 0.0f));
    if (is_on) ImGui::PopStyleColor(3);
    return is_pressed;
}

void help(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

void draw_symmetry(Editor& editor, float width) {
    using Plane = command::Symmetry::Plane;
    const bool is_on = editor.session().symmetry().has_value();
    if (toggle_button("Symmetry", is_on, width)) editor.set_symmetry(!is_on);
    help(kSymmetryHelp);
    MirrorChoice choice = editor.mirror_choice();
    constexpr std::array kPlanes{Plane::x, Plane::y, Plane::z};
    constexpr std::array kNames{"x", "y", "z"};
    const float gap = 0.5f * ImGui::GetStyle().ItemSpacing.x;
    const float third = (width - 2.0f * gap) / 3.0f;
    for (std::size_t i = 0; i < kPlanes.size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, gap);
        const bool is_chosen = choice.plane == kPlanes[i];
        ImGui::BeginDisabled(!is_on);
        if (toggle_button(kNames[i], is_chosen && is_on, third)) {
            choice.plane = kPlanes[i];
            editor.choose_mirror(choice);
        }
        ImGui::EndDisabled();
    }
    ImGui::BeginDisabled(!is_on);
    if (ImGui::Button(choice.through_centre ? "at middle" : "at origin", ImVec2(width, 0.0f))) {
        choice.through_centre = !choice.through_centre;
        editor.choose_mirror(choice);
    }
    help("The plane's position: at the origin, or in the middle of the\nobject as it was opened.");
    ImGui::EndDisabled();
}

void draw_pins(Editor& editor, float width) {
    std::array<char, 32> label{};
    const std::size_t count = editor.pins().points().size();
    std::snprintf(label.data(), label.size(), count > 0 ? "Pin  (%zu)###pin" : "Pin###pin", count);
    if (toggle_button(label.data(), editor.sets_pins, width)) {
        editor.sets_pins = !editor.sets_pins;
    }
    help(kPinHelp);
}

}  // namespace

void ToolPanel::draw(Editor& editor, float scale, float available) {
    const float width = kWidth * scale;
    const float others = kButtonLines * ImGui::GetFrameHeightWithSpacing() +
                         kTextLines * ImGui::GetTextLineHeightWithSpacing() +
                         4.0f * ImGui::GetStyle().ItemSpacing.y;
    draw_radius(editor, width,
                std::clamp(available - others, kMinSliderHeight * scale, kSliderHeight * scale));
    ImGui::Separator();
    draw_symmetry(editor, width);
    ImGui::Separator();
    draw_pins(editor, width);
    DragOptions& options = editor.drag_options;
    if (toggle_button("Connected", options.connected, width)) {
        options.connected = !options.connected;
    }
    help(kConnectedHelp);
    if (toggle_button("Fold-free", options.fold_free, width)) {
        options.fold_free = !options.fold_free;
    }
    help(kFoldFreeHelp);
}

void ToolPanel::draw_radius(Editor& editor, float width, float height) {
    const float left = ImGui::GetCursorPosX();
    const auto centre = [&](float text_width) {
        ImGui::SetCursorPosX(left + 0.5f * (width - text_width));
    };
    centre(ImGui::CalcTextSize("Radius").x);
    ImGui::TextUnformatted("Radius");
    float radius = edited_radius_.value_or(static_cast<float>(editor.radius()));
    const float slider = 0.25f * width;
    centre(slider);
    ImGui::VSliderFloat("##radius", ImVec2(slider, height), &radius,
                        static_cast<float>(editor.min_radius()),
                        static_cast<float>(editor.max_radius()), "",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    help("The radius of the brush. [ and ] change it in steps.\nOr hold F and move the mouse.");
    if (ImGui::IsItemActive()) edited_radius_ = radius;
    if (ImGui::IsItemDeactivatedAfterEdit()) editor.set_radius(static_cast<double>(radius));
    if (!ImGui::IsItemActive()) edited_radius_.reset();
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(radius));
    centre(ImGui::CalcTextSize(text.data()).x);
    ImGui::TextUnformatted(text.data());
}

}  // namespace pectin
