#include "app/ui/tool_strip.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr float kSize = 38.0f, kLeastSize = 18.0f;  // of a button
constexpr float kGap = 3.0f;                        // between buttons, also around separators

struct Entry {
    Action action;
    Icon icon;
    bool begins_group = false;
};

constexpr std::array kEntries{
    Entry{Action::use_brush, Icon::sculpt},
    Entry{Action::use_cage, Icon::cage},
    Entry{Action::toggle_pinning, Icon::pin},
    Entry{Action::toggle_symmetry, Icon::symmetry, true},
    Entry{Action::toggle_connected, Icon::connected},
    Entry{Action::toggle_fold_free, Icon::fold_free},
    Entry{Action::toggle_wireframe, Icon::wireframe, true},
    Entry{Action::toggle_levels, Icon::levels},
    Entry{Action::frame_all, Icon::frame_all},
    Entry{Action::undo, Icon::undo, true},
    Entry{Action::redo, Icon::redo},
};
constexpr auto kGroups =
    static_cast<float>(std::ranges::count(kEntries, true, &Entry::begins_group));

}  // namespace

float tool_button_size(float available, float scale) {
    const float gaps =
        kGap * scale * (static_cast<float>(kEntries.size()) - 1.0f + kGroups) + kGroups;
    const float size = (available - gaps) / static_cast<float>(kEntries.size());
    return std::clamp(size, kLeastSize, kSize * scale);
}

void draw_tool_strip(Editor& editor, float size) {
    const float gap = kGap * std::min(size / kSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    for (const Entry& entry : kEntries) {
        if (entry.begins_group) ImGui::Separator();
        icon_button(editor, entry.action, entry.icon, size);
    }
    ImGui::PopStyleVar();
}

}  // namespace pectin
