#include "app/ui/detail_advanced.h"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/rows.h"
#include "command/field_types.h"

namespace pectin {
namespace {

constexpr float kLabelWidth = 4.6f;  // of the first column, in heights of the font

// What a setting can be instead of a number.
struct Mode {
    const char* name;
    Setting setting;
};
const Mode kAuto{"auto", Setting::automatic()};
const Mode kOff{"off", Setting::off()};
const Mode kNever{"never", Setting::of(0.0)};  // no angle is below 0 degrees
const std::array kAutoOnly{kAuto};
const std::array kOffOnly{kOff};
const std::array kAutoOrOff{kAuto, kOff};
const std::array kAutoNeverOrOff{kAuto, kNever, kOff};

constexpr const char* kModeHelp =
    "Auto: the number follows from the other settings and the object. Off: the rule does not "
    "apply. Set: the number in the field counts.";

// The smallest cell of the lattice that the next drag will use.
double next_cell(const Editor& editor) {
    return editor.session()
        .lattice_settings()
        .lattice(Vec3{0.0}, editor.workspace().diagonal())
        .smallest_cell_extent();
}

NumberStyle angle_style(double left, double right) {
    return {.format = "%.1f", .unit = "°", .left = left, .right = right, .is_logarithmic = true};
}

// Lengths from a thousandth to half of the object, or from the present one if that is less.
NumberStyle length_style(const Editor& editor, double least, double now) {
    const double diagonal = std::max(editor.workspace().diagonal(), 1e-300);
    return {.unit = " units",
            .left = std::min(least * diagonal, now > 0.0 ? now : least * diagonal),
            .right = std::max(0.5 * diagonal, now),
            .is_logarithmic = true};
}

double value_of(const Setting& setting, double otherwise) {
    return setting.kind == Setting::Kind::value ? setting.value : otherwise;
}

}  // namespace

bool uses_angles(const AdaptSettings& settings) {
    return settings.trigger == command::Adapt::Trigger::normals;
}

struct DetailAdvanced::Row {
    const char* label;
    const char* help;
    Setting setting;
    double automatic;  // the number in force if the setting is auto; shown also if it is off
    NumberStyle style;
    std::span<const Mode> modes;  // what it can be instead of a number
    std::function<command::Adapt(const Setting&)> change;
    bool has_automatic_number = true;  // whether `automatic` is known
    bool has_effect = true;

    // The mode in force; the end if the setting is a number.
    auto mode() const { return std::ranges::find(modes, setting, &Mode::setting); }
    // What the field shows instead of a number that counts; empty if it does.
    std::string word() const {
        if (mode() == modes.end()) return "";
        const bool shows_number = setting.is_automatic() && has_automatic_number;
        return (shows_number ? number_text(automatic, style) + "  " : "") + mode()->name;
    }
};

void DetailAdvanced::draw(Editor& editor) {
    const AdaptSettings settings = editor.session().adapt_settings();
    if (!ImGui::BeginTable("advanced", 3)) return;
    ImGui::TableSetupColumn("Limit", ImGuiTableColumnFlags_WidthFixed,
                            kLabelWidth * ImGui::GetFontSize());
    ImGui::TableSetupColumn("Value", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFrameHeight());
    ImGui::TableNextRow();
    for (const char* name : {"Limit", "Value"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", name);
    }
    draw_trigger(editor, settings);
    draw_tolerance(editor, settings);
    draw_angles(editor, settings);
    draw_lengths(editor, settings);
    draw_budgets(editor, settings);
    ImGui::EndTable();
    const bool misses_bends =
        settings.trigger != command::Adapt::Trigger::certified &&
        (settings.l_max.is_off() || value_of(settings.l_max, 0.0) > next_cell(editor));
    if (misses_bends) {
        draw_warning(
            "L max is longer than a cell of the lattice, so bends inside large triangles can be "
            "missed. Set it to auto to prevent that.");
    }
}

void DetailAdvanced::draw_row(Editor& editor, const Row& row) {
    ImGui::PushID(row.label);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.label);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const double value = value_of(row.setting, row.automatic);
    const std::string word = row.word();
    ImGui::BeginDisabled(!row.has_effect);
    if (const auto set =
            fields_.draw("##value", value, row.style, word.empty() ? nullptr : word.c_str())) {
        editor.execute(row.change(Setting::of(*set)));
    }
    tooltip(row.label, row.has_effect ? row.help : kUnusedAngleHelp);
    ImGui::TableNextColumn();
    draw_modes(editor, row);
    ImGui::EndDisabled();
    ImGui::PopID();
}

void DetailAdvanced::draw_modes(Editor& editor, const Row& row) {
    if (row.modes.empty()) return;
    const bool is_number = row.mode() == row.modes.end();
    if (ImGui::BeginCombo("##mode", "", ImGuiComboFlags_NoPreview)) {
        for (const Mode& choice : row.modes) {
            const bool is_chosen = choice.setting == row.setting;
            if (ImGui::Selectable(choice.name, is_chosen) && !is_chosen) {
                editor.execute(row.change(choice.setting));
            }
        }
        if (ImGui::Selectable("set", is_number) && !is_number) {
            editor.execute(row.change(Setting::of(row.automatic)));
        }
        ImGui::EndCombo();
    }
    tooltip((std::string(row.label) + " mode").c_str(), kModeHelp);
}

// What decides where the surface is divided.
void DetailAdvanced::draw_trigger(Editor& editor, const AdaptSettings& settings) {
    struct Choice {
        const char* name;
        command::Adapt::Trigger trigger;
        const char* help;
    };
    using Trigger = command::Adapt::Trigger;
    static constexpr std::array<Choice, 3> kChoices{
        {{"normals", Trigger::normals, "Divides where the surface bends by more than an angle."},
         {"midpoint", Trigger::midpoint,
          "Divides edges whose middle would be farther from the surface than the tolerance."},
         {"certified", Trigger::certified,
          "Divides triangles until it is proven that none is farther from the exact surface than "
          "the tolerance. It takes longer."}}};
    const Choice& now = kChoices[static_cast<std::size_t>(settings.trigger)];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Trigger");
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::BeginCombo("##trigger", now.name)) {
        for (const Choice& choice : kChoices) {
            const bool is_chosen = choice.trigger == settings.trigger;
            if (ImGui::Selectable(choice.name, is_chosen) && !is_chosen) {
                editor.execute(command::Adapt{.trigger = choice.trigger});
            }
            tooltip(choice.name, choice.help);
        }
        ImGui::EndCombo();
    }
    tooltip("Trigger", now.help);
    ImGui::TableNextColumn();
}

// The detail as a length. The normals do not use it.
void DetailAdvanced::draw_tolerance(Editor& editor, const AdaptSettings& settings) {
    if (settings.trigger == command::Adapt::Trigger::normals) return;
    const double automatic = kDefaultToleranceFraction * editor.workspace().diagonal();
    draw_row(editor,
             {.label = "Tolerance",
              .help = "How far the triangles may be from the surface that the drags mean.",
              .setting = settings.tolerance,
              .automatic = automatic,
              .style = length_style(editor, 1e-5, value_of(settings.tolerance, automatic)),
              .modes = kAutoOnly,
              .change = [](const Setting& set) { return command::Adapt{.tolerance = set}; }});
}

void DetailAdvanced::draw_angles(Editor& editor, const AdaptSettings& settings) {
    const double theta_max = value_of(settings.theta_max, kDefaultThetaMax);
    draw_row(editor, {.label = "θ max",
                      .help = "Edges across which the surface bends by more than this are split.",
                      .setting = settings.theta_max,
                      .automatic = kDefaultThetaMax,
                      .style = angle_style(2.0, 90.0),
                      .modes = kOffOnly,
                      .change =
                          [&settings](const Setting& set) {
                              command::Adapt change{.theta_max = set};
                              const bool is_overtaken =
                                  settings.theta_min.kind == Setting::Kind::value &&
                                  !(settings.theta_min.value < value_of(set, 180.0));
                              if (is_overtaken) change.theta_min = Setting::automatic();
                              return change;
                          },
                      .has_effect = uses_angles(settings)});
    draw_row(editor,
             {.label = "θ min",
              .help = "Triangles that were split are merged again where the surface bends by less "
                      "than this.",
              .setting = settings.theta_min,
              .automatic = default_theta_min(theta_max),
              .style = angle_style(0.5, 0.97 * theta_max),
              .modes = kAutoNeverOrOff,
              .change = [](const Setting& set) { return command::Adapt{.theta_min = set}; },
              .has_effect = uses_angles(settings)});
    draw_row(editor,
             {.label = "Flatness",
              .help = "How far merging may move the surface, as a share of the merged edge.",
              .setting = settings.flatness,
              .automatic = default_flatness(theta_max),
              .style = {.unit = " of edge", .left = 1e-3, .right = 0.5, .is_logarithmic = true},
              .modes = kAutoOrOff,
              .change = [](const Setting& set) { return command::Adapt{.flatness = set}; }});
}

void DetailAdvanced::draw_lengths(Editor& editor, const AdaptSettings& settings) {
    const double cell = next_cell(editor);
    draw_row(editor, {.label = "L max",
                      .help = "Edges longer than this are split where a drag reaches.",
                      .setting = settings.l_max,
                      .automatic = cell,
                      .style = length_style(editor, 2e-3, value_of(settings.l_max, cell)),
                      .modes = kAutoOrOff,
                      .change = [](const Setting& set) { return command::Adapt{.l_max = set}; }});
    const double floor = kDefaultFloorFraction * editor.workspace().diagonal();
    draw_row(editor, {.label = "Floor",
                      .help = "Edges are never split into pieces shorter than this.",
                      .setting = settings.floor,
                      .automatic = floor,
                      .style = length_style(editor, 1e-5, value_of(settings.floor, floor)),
                      .modes = kAutoOnly,
                      .change = [](const Setting& set) { return command::Adapt{.floor = set}; }});
}

void DetailAdvanced::draw_budgets(Editor& editor, const AdaptSettings& settings) {
    const NumberStyle style{.format = "%.0f",
                            .unit = " triangles",
                            .left = 1e4,
                            .right = 1e8,
                            .is_logarithmic = true,
                            .is_grouped = true};
    draw_row(editor, {.label = "Budget",
                      .help = "The most triangles that the object may get.",
                      .setting = Setting::of(static_cast<double>(settings.budget)),
                      .automatic = static_cast<double>(settings.budget),
                      .style = style,
                      .modes = {},
                      .change = [](const Setting& set) {
                          const double number = std::clamp(set.value, 0.0, field::kMostWhole);
                          return command::Adapt{.budget = static_cast<std::uint64_t>(number)};
                      }});
    draw_row(editor,
             {.label = "Per drag",
              .help = "The most triangles that one drag may add.",
              .setting = settings.drag_budget,
              .automatic = static_cast<double>(default_drag_budget(0)),
              .style = style,
              .modes = kAutoOrOff,
              .change = [](const Setting& set) { return command::Adapt{.drag_budget = set}; },
              .has_automatic_number = false});
}

}  // namespace pectin
