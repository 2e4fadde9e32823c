#include "command/json.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command/check.h"
#include "command/field_types.h"
#include "command/json_fields.h"
#include "command/json_text.h"
#include "command/json_values.h"
#include "command/reference.h"
#include "command/spelling.h"

namespace pectin {

namespace {

using command_json::describe;
using command_json::in_quotes;
using command_json::json;
using command_json::kMaxQuoted;
using command_json::parse_strictly;
using command_json::Problem;
using command_json::read_fields;
using command_json::require;
using command_json::wrong;

std::string names_of(std::span<const FieldReference> fields) {
    std::vector<std::string> names;
    for (const FieldReference& field : fields) names.push_back(field.name);
    return field::listed(names, "and");
}

void refuse_unknown_fields(const json& object, const CommandReference& reference) {
    for (const auto& [key, value] : object.items()) {
        const auto is_key = [&k = key](const FieldReference& field) { return k == field.name; };
        if (key == "cmd" || std::any_of(reference.fields.begin(), reference.fields.end(), is_key))
            continue;
        throw Problem(
            "unknown field " + in_quotes(key) + "; " + reference.name +
            (reference.fields.empty() ? " has no fields" : " has " + names_of(reference.fields)));
    }
}

bool is_plain_name(std::string_view text) {
    return !text.empty() && text.size() <= kMaxQuoted &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '_' || c == '-';
           });
}

// The command's index in the reference. Sets `command`, with which an error message begins, to its
// name if that is a plain word.
std::size_t command_index(const json& object, std::string& command) {
    const json& given = require(object, "cmd", "a command's name, as in {\"cmd\": \"undo\"}");
    if (!given.is_string()) wrong("cmd", "a command's name in quotes", given);
    const std::string text = given;
    const auto known = command_reference();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&text](const auto& entry) { return text == entry.name; });
    if (is_plain_name(text)) command = text;
    if (found == known.end())
        throw Problem((command == text ? "" : in_quotes(text) + " is an ") + unknown_command(text));
    return static_cast<std::size_t>(found - known.begin());
}

}  // namespace

bool is_json(std::string_view text) { return json::accept(text); }

std::variant<Command, CommandError> parse_command(std::string_view json_line) {
    std::string command = "script";
    try {
        const json object = parse_strictly(json_line);
        if (!object.is_object()) wrong("a line", "an object, {\"cmd\": ...}", object);
        const std::size_t index = command_index(object, command);
        refuse_unknown_fields(object, command_reference()[index]);
        Command read = read_fields(index, object);
        if (const Done done = check(read); !done) throw Problem(done.refusal().reason);
        return read;
    } catch (const Problem& problem) {
        return CommandError{command, problem.what()};
    }
}

Done check_header(std::string_view json_line) {
    const Refusal refusal{"the first line of a script must be {\"pectin\": 1}"};
    try {
        const json header = parse_strictly(json_line);
        if (!header.is_object() || header.size() != 1 || !header.contains("pectin")) return refusal;
        const json& version = header["pectin"];
        if (version == 1) return {};
        if (version.is_number() && version > 1)
            return Refusal{"the script is of version " + version.dump() +
                           ", but this pectin reads version 1, {\"pectin\": 1}"};
        return Refusal{refusal.reason + ", not " + describe(version) + " for a version"};
    } catch (const Problem&) {
        return refusal;
    }
}

}  // namespace pectin
