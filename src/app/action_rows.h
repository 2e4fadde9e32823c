// What the rows of the table of actions (actions.cpp) share: short names for shortcuts.
#pragma once

#include "app/actions.h"

namespace pectin::action_rows {

constexpr Shortcut plain(char letter) { return {.key = Key{letter}}; }
constexpr Shortcut plain(Key key) { return {.key = key}; }
constexpr Shortcut shift(char letter) { return {.key = Key{letter}, .modifiers = {.shift = true}}; }
constexpr Shortcut control(char letter) {
    return {.key = Key{letter}, .modifiers = {.control = true}};
}
constexpr Shortcut control(Key key) { return {.key = key, .modifiers = {.control = true}}; }
constexpr Shortcut control_shift(char letter) {
    return {.key = Key{letter}, .modifiers = {.shift = true, .control = true}};
}
constexpr Shortcut typed(char character) { return {.character = character}; }

constexpr bool always(const Editor&) { return true; }

}  // namespace pectin::action_rows
