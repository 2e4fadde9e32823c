#include "app/ui/refine_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace pectin {
namespace {

constexpr float kMinThetaMax = 2.0f, kMaxThetaMax = 90.0f;  // degrees
constexpr float kMinThetaMin = 0.5f;                        // degrees
constexpr double kThetaMinFraction = 0.97;                  // upper limit of theta_min / theta_max
constexpr double kMinLMax = 0.002, kMaxLMax = 0.5;          // in diagonals of the object's box

constexpr const char* kThetaMaxHelp =
    "Edges whose end normals diverge by more than this angle are\n"
    "split, unless they were nearly as rough before the drag.\n"
    "Off: no edge is split because of its angle.";
constexpr const char* kThetaMinHelp =
    "Refined edges whose end normals diverge by less than this\n"
    "angle may be merged again where the surface stays as flat.\n"
    "auto: 7/9 of θ max. Off: nothing is decimated.";
constexpr const char* kReadaptHelp =
    "The settings are those of the next drag. This applies them to\n"
    "the whole object. It also splits edges that were rough before,\n"
    "where a drag has moved them.";
constexpr const char* kLMaxHelp =
    "Longer edges are split where the lattice reaches.\n"
    "auto: the smallest cell size of the lattice in use.";

// The smallest cell size of the lattice that the next drag will use.
double next_cell(const Editor& editor) {
    return editor.session()
        .lattice_settings()
        .lattice(Vec3{0.0}, editor.workspace().diagonal())
        .smallest_cell_extent();
}

// Rounds a value as its text on the slider, so that the setting is the number on screen.
double shown(float value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(value));
    return std::strtod(text.data(), nullptr);
}

double value_of(const Setting& setting, double automatic) {
    return setting.kind == Setting::Kind::value ? setting.value : automatic;
}

}  // namespace

struct RefinePanel::Row {
    const char* label;
    const char* help;
    bool is_on, is_automatic, may_be_automatic;
    double value;
    float min, max;
    const char* format;
    Setting when_on, when_off;
};

std::optional<Setting> RefinePanel::draw_row(const Row& row, std::optional<float>& edited) const {
    std::optional<Setting> set;
    ImGui::PushID(row.label);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool is_on = row.is_on;
    if (ImGui::Checkbox(row.label, &is_on)) set = is_on ? row.when_on : row.when_off;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.help);

    ImGui::TableNextColumn();
    ImGui::BeginDisabled(!row.is_on);
    float value = edited.value_or(std::clamp(static_cast<float>(row.value), row.min, row.max));
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderFloat("##value", &value, row.min, row.max, row.is_on ? row.format : "off",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemActive()) edited = value;
    if (ImGui::IsItemDeactivatedAfterEdit()) set = Setting::of(shown(edited.value_or(value)));
    if (!ImGui::IsItemActive()) edited.reset();

    ImGui::TableNextColumn();
    if (row.may_be_automatic) {
        bool is_automatic = row.is_automatic && row.is_on;
        if (ImGui::Checkbox("auto", &is_automatic)) {
            set = is_automatic ? Setting::automatic() : Setting::of(shown(value));
        }
    }
    ImGui::EndDisabled();
    ImGui::PopID();
    return set;
}

void RefinePanel::draw_readapt(Editor& editor) {
    if (ImGui::Button("Apply to the whole object", ImVec2(-1.0f, 0.0f))) {
        editor.execute(command::Readapt{});
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", kReadaptHelp);
}

void RefinePanel::draw(Editor& editor) {
    bool enabled = editor.session().adapt_settings().enabled;
    if (ImGui::Checkbox("Refine and decimate while dragging", &enabled)) {
        editor.execute(command::Adapt{.enabled = enabled});
    }
    ImGui::BeginDisabled(!enabled);
    if (ImGui::BeginTable("criteria", 3)) {
        const float em = ImGui::GetFontSize();
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 5.2f * em);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 4.2f * em);
        draw_angles(editor);
        draw_length(editor);
        ImGui::EndTable();
    }
    const Setting l_max = editor.session().adapt_settings().l_max;
    if (l_max.is_off() || value_of(l_max, 0.0) > next_cell(editor)) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.93f, 0.74f, 0.45f, 1.0f));
        ImGui::TextWrapped(
            "Edges may be longer than a lattice cell, so that bends inside large faces are missed. "
            "Set L max to auto to avoid this.");
        ImGui::PopStyleColor();
    }
    ImGui::EndDisabled();
    draw_readapt(editor);
}

void RefinePanel::draw_angles(Editor& editor) {
    const AdaptSettings settings = editor.session().adapt_settings();
    const double theta_max = value_of(settings.theta_max, kDefaultThetaMax);
    const Row max_row{.label = "θ max",
                      .help = kThetaMaxHelp,
                      .is_on = !settings.theta_max.is_off(),
                      .is_automatic = false,
                      .may_be_automatic = false,
                      .value = theta_max,
                      .min = kMinThetaMax,
                      .max = kMaxThetaMax,
                      .format = "%.1f°",
                      .when_on = Setting::of(kDefaultThetaMax),
                      .when_off = Setting::off()};
    if (const auto set = draw_row(max_row, theta_max_)) {
        command::Adapt change{.theta_max = *set};
        const bool overtaken = settings.theta_min.kind == Setting::Kind::value &&
                               !(settings.theta_min.value < value_of(*set, 180.0));
        if (overtaken) change.theta_min = Setting::automatic();
        editor.execute(change);
    }
    // No angle is below 0 degrees, so nothing is decimated.
    const Setting never = Setting::of(0.0);
    const Row min_row{.label = "θ min",
                      .help = kThetaMinHelp,
                      .is_on = settings.theta_min != never,
                      .is_automatic = settings.theta_min.is_automatic(),
                      .may_be_automatic = true,
                      .value = value_of(settings.theta_min, default_theta_min(theta_max)),
                      .min = kMinThetaMin,
                      .max = static_cast<float>(theta_max * kThetaMinFraction),
                      .format = "%.1f°",
                      .when_on = Setting::automatic(),
                      .when_off = never};
    if (const auto set = draw_row(min_row, theta_min_)) {
        editor.execute(command::Adapt{.theta_min = *set});
    }
}

void RefinePanel::draw_length(Editor& editor) {
    const Setting l_max = editor.session().adapt_settings().l_max;
    const double diagonal = editor.workspace().diagonal();
    // A length that a script has set may lie outside the usual range.
    const double length = value_of(l_max, next_cell(editor));
    const Row row{.label = "L max",
                  .help = kLMaxHelp,
                  .is_on = !l_max.is_off(),
                  .is_automatic = l_max.is_automatic(),
                  .may_be_automatic = true,
                  .value = length,
                  .min = static_cast<float>(std::min(length, kMinLMax * diagonal)),
                  .max = static_cast<float>(std::max(length, kMaxLMax * diagonal)),
                  .format = "%.3g",
                  .when_on = Setting::automatic(),
                  .when_off = Setting::off()};
    if (const auto set = draw_row(row, l_max_)) {
        editor.execute(command::Adapt{.l_max = *set});
    }
}

}  // namespace pectin
