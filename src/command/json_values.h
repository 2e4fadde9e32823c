// JSON values, and messages that say what is wrong with them. This is the only file that includes
// nlohmann-json. It is not installed, so users of the package need not have it.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pectin::command_json {

using nlohmann::json;

// What is wrong with a line of a script. parse_command() turns it into a CommandError.
struct Problem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The longest text, in bytes, that an error message quotes in full.
inline constexpr std::size_t kMaxQuoted = 40;

// The text as a JSON string, shortened to kMaxQuoted bytes.
std::string in_quotes(std::string_view text);
// Describes a value of any size in a few words.
std::string describe(const json& value);
// Throws "`where` must be `right`, not `given`".
[[noreturn]] void wrong(const std::string& where, const std::string& right, const json& given);

// The field's value, or null if the object does not have the field.
const json* find(const json& object, std::string_view key);
// The same for a field that must be there.
const json& require(const json& object, std::string_view key, std::string_view right);

}  // namespace pectin::command_json
