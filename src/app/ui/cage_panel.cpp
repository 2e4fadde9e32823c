#include "app/ui/cage_panel.h"

#include <imgui.h>

#include <algorithm>

#include "app/cage_box.h"
#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr int kMaxCount = 16;  // more control points would be too dense to see
constexpr float kLabelWidth = 66.0f;
// In diagonals of the object:
constexpr double kMinSize = 1e-4;       // least size of a cage
constexpr double kSizePerPixel = 5e-3;  // change when a number is dragged by a pixel

void row(const char* label, float scale) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(kLabelWidth * scale + ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextItemWidth(-1.0f);
}

// Three numbers that can be dragged or typed.
void numbers(const char* id, Vec3& value, double step) {
    ImGui::DragScalarN(id, ImGuiDataType_Double, &value.x, 3, static_cast<float>(step), nullptr,
                       nullptr, "%.3g");
}

}  // namespace

void CagePanel::draw(Editor& editor, float scale) {
    const auto& cage = editor.session().lattice_settings().cage;
    if (ImGui::RadioButton("Brush", !cage) && cage) {
        editor.set_radius(editor.radius());
        if (!editor.session().lattice_settings().cage) editor.display.lattice = false;
    }
    ImGui::SameLine(0.0f, 22.0f * scale);
    if (ImGui::RadioButton("Cage", cage.has_value()) && !cage) {
        if (editor.execute(command::Cage{.fit = counts_})) {
            editor.display.lattice = true;
        }
    }
    if (cage) draw_cage(editor, *cage, scale);
}

void CagePanel::draw_cage(Editor& editor, const Lattice& cage, float scale) {
    const Box box = edited_box_.value_or(cage_box(cage));
    IVec3 counts = edited_counts_.value_or(cage.counts());
    Vec3 middle = box.centre(), size = box.extent();
    const double diagonal = editor.workspace().diagonal();
    bool is_held = false, is_set = false;
    const auto record_edit = [&] {
        is_held |= ImGui::IsItemActive();
        is_set |= ImGui::IsItemDeactivatedAfterEdit();
    };
    row("Points", scale);
    ImGui::SliderInt3("##counts", &counts.x, 1, kMaxCount, "%d", ImGuiSliderFlags_AlwaysClamp);
    record_edit();
    row("Middle", scale);
    numbers("##middle", middle, kSizePerPixel * diagonal);
    record_edit();
    row("Size", scale);
    numbers("##size", size, kSizePerPixel * diagonal);
    record_edit();
    size = glm::max(size, Vec3{kMinSize * diagonal});
    const Box changed{.min = middle - 0.5 * size, .max = middle + 0.5 * size};
    if (is_set) editor.set_cage(changed, counts);
    edited_box_ = is_held ? std::optional(changed) : std::nullopt;
    edited_counts_ = is_held ? std::optional(counts) : std::nullopt;
    counts_ = counts;
    draw_cage_actions(editor);
}

void CagePanel::draw_cage_actions(Editor& editor) const {
    if (ImGui::Button("Fit to the object")) {
        editor.execute(command::Cage{.fit = counts_});
    }
    ImGui::PushID("cage");  // the section Display has the same checkbox
    action_checkbox(editor, Action::toggle_lattice);
    ImGui::PopID();
    if (!editor.display.lattice) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped(
        "Drag a control point to move it. Shift and a click select more of them, Ctrl and a drag "
        "all in a box.");
    ImGui::PopStyleColor();
}

}  // namespace pectin
