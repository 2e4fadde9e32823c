#include "app/ui/detail_panel.h"

#include <string>
#include <utility>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"
#include "app/ui/rows.h"

namespace pectin {
namespace {

// The ends of the slider: angles in degrees between the normals at the ends of an edge.
constexpr double kCoarse = 90.0, kFine = 3.0;

constexpr const char* kEnabledHelp =
    "Split triangles where a drag bends the surface, and merge them again where it becomes flat.";
constexpr const char* kDetailHelp =
    "How much the surface may bend from one end of an edge to the other before the edge is split: "
    "the smaller the angle, the finer the mesh.";

// theta_min follows theta_max, unless it says that nothing is merged.
command::Adapt detail_change(const AdaptSettings& settings, double theta_max) {
    command::Adapt change{.theta_max = Setting::of(theta_max)};
    const bool merges = settings.theta_min != Setting::of(0.0);
    if (merges && !settings.theta_min.is_automatic()) change.theta_min = Setting::automatic();
    return change;
}

void draw_ends_of_slider() {
    const char* const fine = "fine";
    ImGui::SetCursorPosX(row_indent());
    ImGui::TextDisabled("coarse");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(fine).x);
    ImGui::TextDisabled("%s", fine);
}

}  // namespace

void DetailPanel::draw(Editor& editor) {
    bool enabled = editor.session().adapt_settings().enabled;
    if (ImGui::Checkbox("Refine while dragging", &enabled)) {
        editor.execute(command::Adapt{.enabled = enabled});
    }
    tooltip("Refine while dragging", kEnabledHelp);
    ImGui::BeginDisabled(!enabled);
    draw_detail(editor);
    ImGui::EndDisabled();
    action_button(editor, Action::readapt, -1.0f);
    if (ImGui::TreeNodeEx("Advanced", ImGuiTreeNodeFlags_SpanAvailWidth)) {
        tooltip("Advanced", "Settings that the detail stands for, and limits.");
        ImGui::BeginDisabled(!enabled);
        advanced_.draw(editor);
        ImGui::EndDisabled();
        ImGui::TreePop();
    } else {
        tooltip("Advanced", "Settings that the detail stands for, and limits.");
    }
}

void DetailPanel::draw_detail(Editor& editor) {
    const AdaptSettings settings = editor.session().adapt_settings();
    const bool is_off = settings.theta_max.is_off();
    const NumberStyle style{
        .format = "%.1f", .unit = "°", .left = kCoarse, .right = kFine, .is_logarithmic = true};
    begin_row("Detail");
    const double value = is_off ? kDefaultThetaMax : settings.theta_max.value;
    ImGui::BeginDisabled(!uses_angles(settings));
    const auto set = fields_.draw("##detail", value, style, is_off ? "off" : nullptr);
    ImGui::EndDisabled();
    tooltip("Detail", uses_angles(settings) ? kDetailHelp : kUnusedAngleHelp);
    if (set) editor.execute(detail_change(settings, *set));
    draw_ends_of_slider();
    if (!fields_.dragged()) return;
    preview_ = detail_change(settings, *fields_.dragged());
    const std::size_t count = editor.detail_preview.count();
    draw_note(count > 0 || editor.detail_preview.has_more()
                  ? ("would split " + counted(count, "edge", "edges") + " at once").c_str()
                  : "would split nothing at once: only what drags have moved is refined");
}

std::optional<command::Adapt> DetailPanel::take_preview() {
    return std::exchange(preview_, std::nullopt);
}

}  // namespace pectin
