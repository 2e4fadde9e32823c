#include "app/ui/controls.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace pectin {
namespace {

const ImGuiID kOwner = 0x70656374;  // marks the hook of this file in the context

Vec2 to_vec(const ImVec2& v) { return {v.x, v.y}; }

}  // namespace

ControlList::ControlList() {
    ImGuiContextHook hook;
    hook.Type = ImGuiContextHookType_NewFramePre;
    hook.Owner = kOwner;
    hook.UserData = this;
    hook.Callback = [](ImGuiContext*, ImGuiContextHook* called) {
        static_cast<ControlList*>(called->UserData)->controls_.clear();
    };
    ImGui::AddContextHook(ImGui::GetCurrentContext(), &hook);
}

const Control* ControlList::find(std::string_view name) const {
    const auto found = std::ranges::find(controls_, name, &Control::name);
    return found == controls_.end() ? nullptr : &*found;
}

void ControlList::add_last_item(const char* name, const char* tooltip) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    for (ImGuiContextHook& hook : context.Hooks) {
        if (hook.Owner != kOwner) continue;
        auto& list = *static_cast<ControlList*>(hook.UserData);
        const bool is_enabled = (context.LastItemData.InFlags & ImGuiItemFlags_Disabled) == 0;
        list.controls_.push_back({.name = name,
                                  .min = to_vec(ImGui::GetItemRectMin()),
                                  .max = to_vec(ImGui::GetItemRectMax()),
                                  .tooltip = tooltip,
                                  .is_enabled = is_enabled});
    }
}

}  // namespace pectin
