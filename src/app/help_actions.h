// The rows of the table of actions (actions.cpp) that help.
#pragma once

#include <array>
#include <cstddef>

#include "app/action_rows.h"
#include "app/actions.h"
#include "app/editor.h"

namespace pectin {

namespace help_actions {

using action_rows::always;
using action_rows::control_shift;
using action_rows::plain;

template <HelpPage kPage>
void show_help(Editor& editor) {
    editor.show_help(kPage);
}

template <Example kExample>
void begin_example(Editor& editor) {
    editor.document().begin_example(kExample);
}

// From show_inputs to the last action.
inline constexpr std::size_t kHelpActionCount =
    kActionCount - static_cast<std::size_t>(Action::show_inputs);
inline constexpr std::array<ActionInfo, kHelpActionCount> kHelpActions{{
    {.action = Action::show_inputs,
     .name = "Mouse and keys",
     .menu = Menu::help,
     .shortcuts = {plain(Key::f1)},
     .tooltip = "List everything that the mouse and the keys do.",
     .is_enabled = always,
     .perform = show_help<HelpPage::inputs>},
    {.action = Action::show_actions,
     .name = "Find an action…",
     .menu = Menu::help,
     .shortcuts = {plain(Key::f3), control_shift('P')},
     .tooltip = "Find an action by its name and do it.",
     .is_enabled = always,
     .perform = show_help<HelpPage::actions>},
    {.action = Action::example_nose,
     .name = "A nose",
     .menu = Menu::examples,
     .tooltip = "Show step by step how a face gets a nose.",
     .is_enabled = always,
     .perform = begin_example<Example::nose>},
    {.action = Action::example_elephant,
     .name = "An elephant",
     .menu = Menu::examples,
     .tooltip = "Show step by step how a ball becomes an elephant.",
     .is_enabled = always,
     .perform = begin_example<Example::elephant>},
    {.action = Action::example_cage,
     .name = "A cage",
     .menu = Menu::examples,
     .tooltip = "Show step by step how a cage deforms all of an object.",
     .is_enabled = always,
     .perform = begin_example<Example::cage>},
    {.action = Action::show_reference,
     .name = "Reference of scripts",
     .menu = Menu::help,
     .submenu_before = Menu::examples,
     .begins_group = true,
     .tooltip = "List all commands of scripts and their fields.",
     .is_enabled = always,
     .perform = show_help<HelpPage::reference>},
    {.action = Action::show_about,
     .name = "About pectin",
     .menu = Menu::help,
     .tooltip = "Show the version, the licence and what pectin is built on.",
     .is_enabled = always,
     .perform = show_help<HelpPage::about>},
}};

}  // namespace help_actions

using help_actions::kHelpActions;

}  // namespace pectin
