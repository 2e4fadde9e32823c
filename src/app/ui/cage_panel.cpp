#include "app/ui/cage_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/cage_box.h"
#include "app/ui/action_widgets.h"
#include "app/ui/rows.h"
#include "command/limits.h"

namespace pectin {
namespace {

constexpr double kMostDragged = 16.0;  // points per axis; more can be typed
// In diagonals of the object:
constexpr double kLeastSize = 1e-4;  // of a cage
constexpr double kMostSize = 4.0, kMostDistance = 2.0;

constexpr std::array kAxes{"X", "Y", "Z"};

constexpr const char* kPointsHelp = "How many control points the cage has along this axis.";
constexpr const char* kMiddleHelp = "Where the middle of the cage is along this axis.";
constexpr const char* kSizeHelp = "How long the cage is along this axis.";

// A format for lengths of the object with about a thousandth of its size as the last digit.
const char* length_format(double diagonal) {
    constexpr std::array kFormats{"%.0f", "%.1f", "%.2f", "%.3f", "%.4f", "%.5f"};
    const double digits = 2.0 - std::floor(std::log10(std::max(diagonal, 1e-300)));
    const auto most = static_cast<double>(kFormats.size() - 1);
    return digits > most ? "%.3g" : kFormats[static_cast<std::size_t>(std::max(digits, 0.0))];
}

}  // namespace

void CagePanel::draw(Editor& editor) {
    const auto& cage = editor.session().lattice_settings().cage;
    draw_column_names(kAxes);
    if (!cage) {
        draw_counts(editor, {}, editor.cage_counts);
        action_button(editor, Action::use_cage, -1.0f);
        draw_note("A cage is a box of control points around the object that can be dragged.");
        return;
    }
    const Box box = cage_box(*cage);
    const IVec3 counts = cage->counts();
    draw_counts(editor, box, counts);
    draw_box(editor, box, counts);
    action_button(editor, Action::fit_cage, -1.0f);
    ImGui::PushID("cage");  // the section Display has the same checkbox
    action_checkbox(editor, Action::toggle_lattice);
    ImGui::PopID();
    if (editor.display.lattice) {
        draw_note(
            "Drag a control point to move it. Shift+click selects more of them, Ctrl+drag all in a "
            "box.");
    }
}

// Draws one of three numbers beside each other.
std::optional<double> CagePanel::draw_third(const char* name, int axis, double value,
                                            const NumberStyle& style, const char* help) {
    const auto i = static_cast<std::size_t>(axis);
    if (axis > 0) ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(third_of_row());
    const std::string label = std::string(name) + ' ' + kAxes[i];
    const auto set = fields_.draw(("##" + label).c_str(), value, style);
    tooltip(label.c_str(), help);
    return set;
}

void CagePanel::draw_counts(Editor& editor, const Box& box, const IVec3& counts) {
    constexpr field::Limits kLimits = limits_of(&command::Cage::fit);
    const NumberStyle style{
        .format = "%.0f", .left = kLimits.least, .right = std::min(kLimits.most, kMostDragged)};
    begin_row("Points");
    for (int axis = 0; axis < 3; ++axis) {
        const auto set = draw_third("Points", axis, counts[axis], style, kPointsHelp);
        if (!set) continue;
        IVec3 changed = counts;
        changed[axis] = whole_number(*set);
        editor.choose_cage_counts(box, changed);
    }
}

void CagePanel::draw_box(Editor& editor, const Box& box, const IVec3& counts) {
    const double diagonal = editor.workspace().diagonal();
    const Vec3 middle = box.centre(), size = box.extent();
    const auto resize = [&](const Vec3& to_middle, const Vec3& to_size) {
        if (!glm::all(glm::greaterThan(to_size, Vec3{0.0}))) {  // refused by the limits of a cell
            editor.execute(command::Cage{
                .origin = to_middle, .cell = to_size, .deformable = editor.cage_counts});
            return;
        }
        const Vec3 half = 0.5 * glm::max(to_size, Vec3{kLeastSize * diagonal});
        editor.set_cage({.min = to_middle - half, .max = to_middle + half}, counts);
    };
    begin_row("Middle");
    for (int axis = 0; axis < 3; ++axis) {
        const double centre = editor.workspace().box().centre()[axis];
        const NumberStyle style{.format = length_format(diagonal),
                                .left = centre - kMostDistance * diagonal,
                                .right = centre + kMostDistance * diagonal};
        Vec3 changed = middle;
        const auto set = draw_third("Middle", axis, middle[axis], style, kMiddleHelp);
        if (!set) continue;
        changed[axis] = *set;
        resize(changed, size);
    }
    begin_row("Size");
    for (int axis = 0; axis < 3; ++axis) {
        const NumberStyle style{.format = length_format(diagonal),
                                .left = kLeastSize * diagonal,
                                .right = kMostSize * diagonal,
                                .is_logarithmic = true};
        Vec3 changed = size;
        const auto set = draw_third("Size", axis, size[axis], style, kSizeHelp);
        if (!set) continue;
        changed[axis] = *set;
        resize(middle, changed);
    }
}

}  // namespace pectin
