// What mouse and keys do in the window, as data. Tools and navigation each describe their own
// inputs, and the table of actions has the shortcuts. The help window, `pectin help --keys` and the
// table in the README all show what is collected here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/mouse_preset.h"

namespace pectin {

struct InputReference {
    std::string_view input;   // what the user does, such as "Drag the surface"
    std::string_view effect;  // one sentence
};

// The inputs of one tool. The views and the span refer to constants.
struct InputGroup {
    std::string_view title{};
    std::span<const InputReference> inputs{};
    int place = 10;  // groups with smaller numbers are listed first
};

// What help lists: groups with a title, and a line for each input.
struct InputLine {
    std::string input, effect;
    std::string detail{};  // a longer explanation of an action; often empty
};
struct InputSection {
    std::string title;
    std::vector<InputLine> lines{};
};

// All inputs of the window: those of these groups in the order of their places, among them those
// that move the view, then the window's own, then the shortcuts of all actions, by menu. Groups
// without inputs are left out.
std::vector<InputSection> input_sections(std::vector<InputGroup> groups, MousePreset preset);
// The same for all tools.
std::vector<InputSection> input_sections(MousePreset preset = MousePreset::blender);

// All inputs as a table in Markdown, as the README has it, with the preset of a new window; ends
// with a line end.
std::string input_table();

}  // namespace pectin
