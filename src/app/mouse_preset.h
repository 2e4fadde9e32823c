// Which mouse buttons and modifiers move the view, after the habits of several programs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/input_event.h"

namespace pectin {

enum class NavigationMode : std::uint8_t { orbit, pan, zoom };

enum class MousePreset : std::uint8_t { blender, maya, zbrush };
inline constexpr std::array kMousePresets{MousePreset::blender, MousePreset::maya,
                                          MousePreset::zbrush};

// The name as menus show it, such as "Blender", and the preset that has it.
const char* name(MousePreset preset);
std::optional<MousePreset> mouse_preset_named(std::string_view name);

// A press that moves the view until its release.
struct MouseBinding {
    MouseButton button = MouseButton::left;
    Modifiers modifiers{};  // which have to be held
    NavigationMode mode = NavigationMode::orbit;
    // Whether it also works where a tool would take the press, such as over the surface.
    bool is_anywhere = true;

    bool operator==(const MouseBinding&) const = default;
};

// The first that fits a press is in force. Every press fits one of them.
std::span<const MouseBinding> mouse_bindings(MousePreset preset);
// While Space is held, these come first, in every preset.
std::span<const MouseBinding> space_bindings();

// The binding of a press.
const MouseBinding& binding_of(MousePreset preset, MouseButton button, const Modifiers& modifiers,
                               bool holds_space = false);

// Whether Alt makes drags of the surface go along its normal. Where it does not, it moves the view.
// Holding N does it in every preset.
bool alt_drags_along_normal(MousePreset preset);
// Whether a gesture that was begun with Alt zooms from the moment when Alt is released.
bool releasing_alt_zooms(MousePreset preset);

// The press in words, such as "Shift+middle button".
std::string press_label(const MouseBinding& binding);

}  // namespace pectin
