#include "app/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "app/rounded_numbers.h"

namespace pectin {
namespace {

struct Words {
    std::string_view kind;
    const char* words;
};

// The kinds are those of ffd/drag_refusal.h and session/drag.cpp. Refusals that the window never
// asks for are not here.
constexpr std::array kWords{
    Words{"pinned", "This point is pinned. Press P over it to remove the pin."},
    Words{"outside_zone",
          "The cage does not reach this point. Move or enlarge the cage, or drag a point inside "
          "it."},
    Words{"near_border",
          "This point is too close to the border of the cage. Enlarge the cage, or drag a point "
          "further inside."},
    Words{"target_outside_zone",
          "Nothing can leave the cage without folding. Enlarge the cage, or switch Fold-free off."},
    Words{"too_many_for_lattice",
          "There are more pins than the control points can hold. Remove some pins, or use more "
          "points per axis."},
    Words{"dependent",
          "A pin is too close to the point that you drag. Remove the pin, or use more points per "
          "axis."},
    Words{"too_coarse_to_rotate",
          "There are too few control points to twist or scale here. Use more points per axis."},
    Words{"too_many_constraints", "There are too many pins for one drag. Remove some of them."},
    Words{"near_plane",
          "This point is too close to the plane of symmetry. Drag a point on the plane or further "
          "away, or switch Symmetry off."},
    Words{"off_plane",
          "This point is on the plane of symmetry and stays on it. Switch Symmetry off to move it "
          "away."},
    Words{"asymmetric_rotation",
          "On the plane of symmetry a twist is only possible about the mirrored axis. Switch "
          "Symmetry off to twist freely."},
    Words{"across_plane",
          "A drag cannot cross the plane of symmetry. Stay on one side, or switch Symmetry off."},
    Words{"onto_plane",
          "A drag cannot end on the plane of symmetry. Stay beside it, or switch Symmetry off."},
    Words{"too_many_steps",
          "The surface cannot be dragged that far without folding. Drag less far, use a larger "
          "radius, or switch Fold-free off."},
    Words{"too_far", "That is too far away from the object."},
};

// The labels of fields of commands in the panels.
struct Label {
    std::string_view field;
    const char* label;
};
constexpr std::array kLabels{
    Label{"theta_max", "θ max"},
    Label{"theta_min", "θ min"},
    Label{"l_max", "L max"},
    Label{"drag_budget", "The budget per drag"},
    Label{"span", "Points per axis"},
    Label{"fit", "Points"},
    Label{"cell", "Size"},
};
// Values that a field may have in scripts, and which the panels offer as modes.
constexpr std::array kScriptValues{", \"auto\" or null", " or \"auto\"", " or null"};

// Names a field of a command as the panels do.
std::string with_label(const Refusal& refusal) {
    std::string text = refusal.reason;
    // One of several numbers, as in "fit[1]", is that of an axis.
    const std::size_t bracket = refusal.field.find('[');
    const std::string field = refusal.field.substr(0, bracket);
    const auto* const label = std::ranges::find(kLabels, std::string_view(field), &Label::field);
    if (label != kLabels.end() && text.starts_with(refusal.field)) {
        std::string name = label->label;
        if (bracket != std::string::npos) {
            const int axis = refusal.field[bracket + 1] - '0';
            name += std::string(" ") + "XYZ"[std::clamp(axis, 0, 2)];
        }
        text.replace(0, refusal.field.size(), name);
    }
    if (refusal.field.empty()) return text;
    for (const std::string_view value : kScriptValues) {
        const std::size_t at = text.find(value);
        if (at != text.npos) text.erase(at, value.size());
    }
    return text;
}

const Words* find_words(const std::string& kind) {
    const auto* const found = std::ranges::find(kWords, std::string_view(kind), &Words::kind);
    return found == kWords.end() ? nullptr : found;
}

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }

// Whether the message goes on after the name of the file, as in "is not an OBJ model".
bool is_predicate(std::string_view message) {
    constexpr std::array kVerbs{"is ",     "has ", "holds ", "does ",
                                "cannot ", "was ", "names ", "already "};
    return std::ranges::any_of(kVerbs, [&](const char* verb) { return message.starts_with(verb); });
}

}  // namespace

std::string sentences(const std::string& remark) {
    std::string text = remark;
    if (text.empty()) return text;
    text.front() = upper(text.front());
    for (std::size_t at = 0; (at = text.find("; ", at)) != text.npos; at += 2) {
        if (at + 2 >= text.size() || !is_small_letter(text[at + 2])) continue;
        text[at] = '.';
        text[at + 2] = upper(text[at + 2]);
    }
    if (text.back() != '.' && text.back() != '?') text += '.';
    return text;
}

std::string words_of(const Refusal& refusal) {
    if (refusal.kind == kInWords) return refusal.reason;
    if (const Words* const words = find_words(refusal.kind)) return words->words;
    return sentences(rounded_numbers(with_label(refusal)));
}

std::string words_of(const FileError& error) {
    const std::string name = std::filesystem::path(error.path()).filename().string();
    const std::string& message = error.message();
    const std::string subject = printable(name.empty() ? error.path() : name);
    if (error.line() > 0) {
        return subject + " cannot be opened: line " + std::to_string(error.line()) + ": " +
               sentences("x" + message).substr(1);
    }
    if (is_predicate(message)) return subject + " " + sentences("x" + message).substr(1);
    return subject + ": " + sentences(message);
}

std::string words_of(const std::exception& error) {
    const auto* const file_error = dynamic_cast<const FileError*>(&error);
    return file_error ? words_of(*file_error) : sentences(printable(error.what()));
}

bool has_words(const std::string& kind) { return find_words(kind) != nullptr; }

}  // namespace pectin
