#include "command/json_values.h"

namespace pectin::command_json {

std::string in_quotes(std::string_view text) {
    std::string shown(text.substr(0, kMaxQuoted));
    if (text.size() > kMaxQuoted) shown += "...";
    // dump() escapes control characters, which would break the message's line, and replaces a
    // UTF-8 character that substr() has cut.
    return json(shown).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string describe(const json& value) {
    if (value == "") return "an empty string";
    if (value.is_string())
        return "a string (" + in_quotes(value.get_ref<const std::string&>()) + ")";
    if (value.is_array() && value.empty()) return "an empty array";
    if (value.is_array()) return "an array of length " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    return value.dump();
}

void wrong(const std::string& where, const std::string& right, const json& given) {
    throw Problem(where + " must be " + right + ", not " + describe(given));
}

const json* find(const json& object, std::string_view key) {
    const auto found = object.find(std::string(key));
    return found == object.end() ? nullptr : &*found;
}

const json& require(const json& object, std::string_view key, std::string_view right) {
    if (const json* value = find(object, key)) return *value;
    std::string missing(key);
    missing.append(" is missing; it must be ").append(right);
    throw Problem(missing);
}

}  // namespace pectin::command_json
