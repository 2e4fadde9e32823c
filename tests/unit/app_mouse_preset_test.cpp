// The bindings of the mouse in each preset.
#include "app/mouse_preset.h"

#include <gtest/gtest.h>

#include <set>

namespace pectin {
namespace {

using enum MouseButton;
using enum NavigationMode;

constexpr Modifiers kNone{}, kShift{.shift = true}, kControl{.control = true}, kAlt{.alt = true};

NavigationMode mode(MousePreset preset, MouseButton button, const Modifiers& modifiers) {
    return binding_of(preset, button, modifiers).mode;
}
bool is_anywhere(MousePreset preset, const Modifiers& modifiers, bool holds_space = false) {
    return binding_of(preset, left, modifiers, holds_space).is_anywhere;
}

TEST(MousePreset, BlenderRotatesPansAndZoomsWithTheMiddleButton) {
    constexpr MousePreset kPreset = MousePreset::blender;
    EXPECT_EQ(mode(kPreset, middle, kNone), orbit);
    EXPECT_EQ(mode(kPreset, middle, kShift), pan);
    EXPECT_EQ(mode(kPreset, middle, kControl), zoom);
    EXPECT_EQ(mode(kPreset, right, kNone), orbit);
    EXPECT_EQ(mode(kPreset, right, kAlt), pan);
    EXPECT_FALSE(is_anywhere(kPreset, kAlt)) << "drags the surface along its normal";
    EXPECT_TRUE(alt_drags_along_normal(kPreset));
}

TEST(MousePreset, MayaRotatesPansAndZoomsWithAltAndTheThreeButtons) {
    constexpr MousePreset kPreset = MousePreset::maya;
    EXPECT_EQ(mode(kPreset, left, kAlt), orbit);
    EXPECT_EQ(mode(kPreset, middle, kAlt), pan);
    EXPECT_EQ(mode(kPreset, right, kAlt), zoom);
    EXPECT_TRUE(is_anywhere(kPreset, kAlt)) << "also over the surface";
    EXPECT_FALSE(is_anywhere(kPreset, kNone));
    EXPECT_FALSE(alt_drags_along_normal(kPreset));
}

TEST(MousePreset, ZbrushRotatesAndPansBesideTheObjectAndZoomsWhenAltIsReleased) {
    constexpr MousePreset kPreset = MousePreset::zbrush;
    EXPECT_EQ(mode(kPreset, left, kNone), orbit);
    EXPECT_EQ(mode(kPreset, left, kAlt), pan);
    EXPECT_EQ(mode(kPreset, right, kControl), zoom);
    EXPECT_EQ(mode(kPreset, right, kNone), orbit);
    EXPECT_FALSE(is_anywhere(kPreset, kAlt));
    EXPECT_TRUE(releasing_alt_zooms(kPreset));
    EXPECT_FALSE(releasing_alt_zooms(MousePreset::blender));
}

TEST(MousePreset, AllDoEverythingWithTheLeftButtonBesideTheObjectAndWithSpaceAnywhere) {
    for (const MousePreset preset : kMousePresets) {
        SCOPED_TRACE(name(preset));
        std::set<NavigationMode> beside;
        for (const Modifiers& modifiers : {kNone, kShift, kControl}) {
            beside.insert(mode(preset, left, modifiers));
            EXPECT_FALSE(is_anywhere(preset, modifiers)) << "the surface is dragged with it";
            EXPECT_TRUE(is_anywhere(preset, modifiers, true));
        }
        EXPECT_EQ(beside.size(), 3u);
        EXPECT_EQ(binding_of(preset, left, kNone, true).mode, orbit);
        EXPECT_EQ(binding_of(preset, left, kShift, true).mode, pan);
        EXPECT_EQ(binding_of(preset, left, kControl, true).mode, zoom);
    }
}

TEST(MousePreset, EveryPressHasABindingAndEveryBindingAPress) {
    for (const MousePreset preset : kMousePresets) {
        SCOPED_TRACE(name(preset));
        std::set<const MouseBinding*> used;
        for (const MouseButton button : {left, middle, right}) {
            for (int bits = 0; bits < 8; ++bits) {
                const Modifiers held{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
                const MouseBinding& binding = binding_of(preset, button, held);
                EXPECT_EQ(binding.button, button);
                used.insert(&binding);
            }
        }
        EXPECT_EQ(used.size(), mouse_bindings(preset).size());
    }
}

TEST(MousePreset, HasANameThatFindsIt) {
    for (const MousePreset preset : kMousePresets) {
        EXPECT_EQ(mouse_preset_named(name(preset)), preset);
    }
    EXPECT_EQ(mouse_preset_named("Houdini"), std::nullopt);
}

TEST(MousePreset, LabelsPressesAsUsersSayThem) {
    EXPECT_EQ(press_label(binding_of(MousePreset::blender, middle, kShift)), "Shift+middle button");
    EXPECT_EQ(press_label(binding_of(MousePreset::maya, left, {.control = true, .alt = true})),
              "Ctrl+Alt+left button");
    EXPECT_EQ(press_label(binding_of(MousePreset::zbrush, right, kNone)), "right button");
}

}  // namespace
}  // namespace pectin
