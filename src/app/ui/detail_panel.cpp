#include "app/ui/detail_panel.h"

#include <string>
#include <utility>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"
#include "app/ui/rows.h"

namespace pectin {
namespace {

// The ends of the slider: angles in degrees between the normals at the ends of an edge, or
// tolerances as shares of the object's diagonal.
constexpr double kCoarse = 90.0, kFine = 3.0;
constexpr double kCoarseShare = 1e-2, kFineShare = 1e-5;

constexpr const char* kEnabledHelp =
    "Split triangles where a drag bends the surface, and merge them again where it becomes flat.";
constexpr const char* kDetailHelp =
    "How much the surface may bend from one end of an edge to the other before the edge is split: "
    "the smaller the angle, the finer the mesh.";
constexpr const char* kToleranceHelp =
    "How far the triangles may be from the surface that the drags mean: the smaller the distance, "
    "the finer the mesh.";

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
    begin_row("Detail");
    if (uses_angles(settings)) {
        draw_angle(editor, settings);
    } else {
        draw_tolerance(editor, settings);
    }
    if (!preview_) return;
    const std::size_t count = editor.detail_preview.count();
    draw_note(count > 0 || editor.detail_preview.has_more()
                  ? ("would split " + counted(count, "edge", "edges") + " at once").c_str()
                  : "would split nothing at once: only what drags have moved is refined");
}

void DetailPanel::draw_angle(Editor& editor, const AdaptSettings& settings) {
    const bool is_off = settings.theta_max.is_off();
    const NumberStyle style{
        .format = "%.1f", .unit = "°", .left = kCoarse, .right = kFine, .is_logarithmic = true};
    const double value = is_off ? kDefaultThetaMax : settings.theta_max.value;
    const auto set = fields_.draw("##detail", value, style, is_off ? "off" : nullptr);
    tooltip("Detail", kDetailHelp);
    if (set) editor.execute(detail_change(settings, *set));
    draw_ends_of_slider();
    if (fields_.dragged()) preview_ = detail_change(settings, *fields_.dragged());
}

void DetailPanel::draw_tolerance(Editor& editor, const AdaptSettings& settings) {
    const double diagonal = editor.workspace().diagonal();
    const NumberStyle style{.unit = " units",
                            .left = kCoarseShare * diagonal,
                            .right = kFineShare * diagonal,
                            .is_logarithmic = true};
    const double value = settings.tolerance.is_automatic() ? kDefaultToleranceFraction * diagonal
                                                           : settings.tolerance.value;
    const auto change = [](double to) { return command::Adapt{.tolerance = Setting::of(to)}; };
    const auto set = fields_.draw("##tolerance", value, style);
    tooltip("Detail", kToleranceHelp);
    if (set) editor.execute(change(*set));
    draw_ends_of_slider();
    if (fields_.dragged()) preview_ = change(*fields_.dragged());
}

std::optional<command::Adapt> DetailPanel::take_preview() {
    return std::exchange(preview_, std::nullopt);
}

}  // namespace pectin
