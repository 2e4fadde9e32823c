// The windows of the menu Help. At most one of them is open.
#pragma once

namespace pectin {

enum class HelpPage {
    inputs,     // what mouse and keys do
    actions,    // finds an action by its name
    reference,  // the commands of scripts
    about
};

}  // namespace pectin
