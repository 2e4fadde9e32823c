#include "app/input_reference.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "app/actions.h"
#include "app/tools/tool.h"

namespace pectin {
namespace {

// The place of the inputs that move the view, among the groups of the tools.
constexpr int kPlaceOfView = 2;

// What moves the view with every preset of the mouse.
constexpr std::array<InputReference, 4> kViewInputs{{
    {"Wheel or two fingers", "Zooms to what is under the cursor, but never through the surface."},
    {"Shift+wheel, or sideways", "Pans the view."},
    {"Click an axis at the upper right", "Looks along this axis."},
    {"Drag the axes at the upper right", "Rotates the view."},
}};

// What the window does with input itself, whatever the tools are.
constexpr std::array<InputReference, 4> kWindowInputs{{
    {"Esc", "Cancels what is going on, closes what is open, or dismisses the message."},
    {"Enter", "Accepts the dialog."},
    {"Drop a file on the window", "Opens the model."},
    {"Mouse over a control", "Explains it."},
}};

InputSection section_of(const InputGroup& group) {
    InputSection section{std::string(group.title)};
    for (const InputReference& reference : group.inputs) {
        section.lines.push_back({std::string(reference.input), std::string(reference.effect)});
    }
    return section;
}

std::string_view effect_of(NavigationMode mode) {
    switch (mode) {
        case NavigationMode::orbit:
            return "Rotates the view.";
        case NavigationMode::pan:
            return "Pans the view.";
        case NavigationMode::zoom:
            return "Zooms.";
    }
    return "";
}

InputLine line_of(const MouseBinding& binding, const std::string& held = {}) {
    std::string input = held + press_label(binding);
    input.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(input.front())));
    return {input + (binding.is_anywhere ? " and drag" : " and drag beside the object"),
            std::string(effect_of(binding.mode))};
}

InputSection view_section(MousePreset preset) {
    InputSection section{"View"};
    for (const MouseBinding& binding : mouse_bindings(preset)) {
        section.lines.push_back(line_of(binding));
    }
    for (const MouseBinding& binding : space_bindings()) {
        section.lines.push_back(line_of(binding, "Space+"));
    }
    if (releasing_alt_zooms(preset)) {
        section.lines.push_back({"Release Alt while panning", "Zooms from then on."});
    }
    for (const InputReference& reference : kViewInputs) {
        section.lines.push_back({std::string(reference.input), std::string(reference.effect)});
    }
    return section;
}

std::string all_shortcuts(const ActionInfo& info) {
    std::string labels;
    for (const Shortcut& shortcut : info.shortcuts) {
        if (shortcut.exists()) labels += (labels.empty() ? "" : " or ") + label_of(shortcut);
    }
    return labels;
}

// Appends the shortcuts of all actions, in the order of the table. Actions of a submenu stand with
// the menu that has it.
void append_shortcuts(std::vector<InputSection>& sections) {
    for (const ActionInfo& info : all_actions()) {
        const std::string keys = all_shortcuts(info);
        if (keys.empty()) continue;
        const std::string title = "Menu " + std::string(menu_title(top_menu(info.menu)));
        auto section = std::ranges::find(sections, title, &InputSection::title);
        if (section == sections.end()) section = sections.insert(section, {title});
        section->lines.push_back({keys, info.name, info.tooltip});
    }
}

// Vertical bars separate the columns of a table, so those of a text are escaped.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

}  // namespace

std::vector<InputSection> input_sections(std::vector<InputGroup> groups, MousePreset preset) {
    std::erase_if(groups, [](const InputGroup& group) { return group.inputs.empty(); });
    std::ranges::stable_sort(groups, {}, &InputGroup::place);
    std::vector<InputSection> sections;
    for (const InputGroup& group : groups) sections.push_back(section_of(group));
    const auto is_before_view = [](const InputGroup& group) { return group.place < kPlaceOfView; };
    sections.insert(sections.begin() + std::ranges::count_if(groups, is_before_view),
                    view_section(preset));
    sections.push_back(section_of({"Window", kWindowInputs}));
    append_shortcuts(sections);
    return sections;
}

std::vector<InputSection> input_sections(MousePreset preset) {
    const Tools tools = all_tools();
    std::vector<InputGroup> groups;
    for (const auto& tool : tools) groups.push_back(tool->inputs());
    return input_sections(std::move(groups), preset);
}

std::string input_table() {
    std::string table = "| input | effect |\n|---|---|\n";
    for (const InputSection& section : input_sections()) {
        table += "| **" + section.title + "** | |\n";
        for (const InputLine& line : section.lines) {
            table += "| " + cell(line.input) + " | " + cell(line.effect) + " |\n";
        }
    }
    return table;
}

}  // namespace pectin
