#include "app/mouse_preset.h"

#include <algorithm>

namespace pectin {
namespace {

using enum NavigationMode;

constexpr Modifiers kShift{.shift = true}, kControl{.control = true}, kAlt{.alt = true};
constexpr Modifiers kShiftAlt{.shift = true, .alt = true};
constexpr Modifiers kControlAlt{.control = true, .alt = true};

constexpr std::array kBlender{
    MouseBinding{MouseButton::middle, kControl, zoom},
    MouseBinding{MouseButton::middle, kShift, pan},
    MouseBinding{MouseButton::middle, {}, orbit},
    MouseBinding{MouseButton::left, kControl, zoom, false},
    MouseBinding{MouseButton::left, kShift, pan, false},
    MouseBinding{MouseButton::left, {}, orbit, false},
    MouseBinding{MouseButton::right, kControl, zoom},
    MouseBinding{MouseButton::right, kShift, pan},
    MouseBinding{MouseButton::right, kAlt, pan},
    MouseBinding{MouseButton::right, {}, orbit},
};

constexpr std::array kMaya{
    MouseBinding{MouseButton::left, kControlAlt, zoom},
    MouseBinding{MouseButton::left, kShiftAlt, pan},
    MouseBinding{MouseButton::left, kAlt, orbit},
    MouseBinding{MouseButton::middle, kAlt, pan},
    MouseBinding{MouseButton::right, kAlt, zoom},
    MouseBinding{MouseButton::left, kControl, zoom, false},
    MouseBinding{MouseButton::left, kShift, pan, false},
    MouseBinding{MouseButton::left, {}, orbit, false},
    MouseBinding{MouseButton::middle, {}, pan},
    MouseBinding{MouseButton::right, {}, orbit},
};

constexpr std::array kZbrush{
    MouseBinding{MouseButton::left, kControl, zoom, false},
    MouseBinding{MouseButton::left, kAlt, pan, false},
    MouseBinding{MouseButton::left, kShift, pan, false},
    MouseBinding{MouseButton::left, {}, orbit, false},
    MouseBinding{MouseButton::right, kControl, zoom},
    MouseBinding{MouseButton::right, kAlt, pan},
    MouseBinding{MouseButton::right, {}, orbit},
    MouseBinding{MouseButton::middle, {}, pan},
};

constexpr std::array kSpace{
    MouseBinding{MouseButton::left, kControl, zoom},
    MouseBinding{MouseButton::left, kShift, pan},
    MouseBinding{MouseButton::left, {}, orbit},
};

bool fits(const MouseBinding& binding, MouseButton button, const Modifiers& held) {
    const Modifiers& needed = binding.modifiers;
    return binding.button == button && (!needed.shift || held.shift) &&
           (!needed.control || held.control) && (!needed.alt || held.alt);
}

const char* button_name(MouseButton button) {
    switch (button) {
        case MouseButton::left:
            return "left button";
        case MouseButton::middle:
            return "middle button";
        case MouseButton::right:
            return "right button";
    }
    return "";
}

}  // namespace

const char* name(MousePreset preset) {
    switch (preset) {
        case MousePreset::blender:
            return "Blender";
        case MousePreset::maya:
            return "Maya";
        case MousePreset::zbrush:
            return "ZBrush";
    }
    return "";
}

std::optional<MousePreset> mouse_preset_named(std::string_view name) {
    for (const MousePreset preset : kMousePresets) {
        if (pectin::name(preset) == name) return preset;
    }
    return std::nullopt;
}

std::span<const MouseBinding> mouse_bindings(MousePreset preset) {
    switch (preset) {
        case MousePreset::blender:
            return kBlender;
        case MousePreset::maya:
            return kMaya;
        case MousePreset::zbrush:
            return kZbrush;
    }
    return kBlender;
}

std::span<const MouseBinding> space_bindings() { return kSpace; }

const MouseBinding& binding_of(MousePreset preset, MouseButton button, const Modifiers& modifiers,
                               bool holds_space) {
    const bool uses_space = holds_space && button == MouseButton::left;
    const std::span<const MouseBinding> bindings =
        uses_space ? space_bindings() : mouse_bindings(preset);
    // The last binding of each button needs no modifier.
    return *std::ranges::find_if(
        bindings, [&](const MouseBinding& binding) { return fits(binding, button, modifiers); });
}

bool alt_drags_along_normal(MousePreset preset) { return preset != MousePreset::maya; }
bool releasing_alt_zooms(MousePreset preset) { return preset == MousePreset::zbrush; }

std::string press_label(const MouseBinding& binding) {
    const Modifiers& needed = binding.modifiers;
    return std::string(needed.control ? "Ctrl+" : "") + (needed.shift ? "Shift+" : "") +
           (needed.alt ? "Alt+" : "") + button_name(binding.button);
}

}  // namespace pectin
