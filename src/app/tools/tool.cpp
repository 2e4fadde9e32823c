#include "app/tools/tool.h"

namespace pectin {

ShownSettings& ShownSettings::operator|=(const ShownSettings& other) {
    radius |= other.radius;
    mirror |= other.mirror;
    connected |= other.connected;
    fold_free |= other.fold_free;
    pins |= other.pins;
    cage |= other.cage;
    return *this;
}

bool Tool::hover(const ToolContext&, bool) { return false; }
bool Tool::press(ToolContext&, MouseButton) { return false; }
bool Tool::key(ToolContext&, const event::KeyDown&) { return false; }
bool Tool::scroll(ToolContext&, double) { return false; }
bool Tool::escape(ToolContext&) { return false; }

void Tool::character(ToolContext&, unsigned int) {}
void Tool::move(ToolContext&) {}
void Tool::release(ToolContext&, MouseButton) {}
void Tool::key_up(ToolContext&, Key) {}
void Tool::lose_focus(ToolContext&) {}
void Tool::advance(ToolContext&) {}
void Tool::finish(ToolContext&, Workspace::Outcome) {}
void Tool::cancel(ToolContext&) noexcept {}

void Tool::overlay(const ToolContext&, Overlay&) const {}
std::string_view Tool::status_hint(const ToolContext&) const { return {}; }

}  // namespace pectin
