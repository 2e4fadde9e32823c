// Reads JSON values as numbers, points, settings and paths, and says what is wrong with the others.
//
// In all of these functions `where` names the field for error messages ("moves[0].from"), and
// `right` says what the field must be ("an angle"). They throw Problem. This is the only
// file that includes nlohmann-json. It is not installed, so users of the package need not have it.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "command/command.h"
#include "geometry/vec.h"

namespace pectin::command_json {

using nlohmann::json;

// What is wrong with a line of a script. parse_command() turns it into a CommandError.
struct Problem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline constexpr int kMaxInt = std::numeric_limits<int>::max();
inline constexpr const char* kPathIsRight = "a file's path in quotes";
inline constexpr const char* kPointIsRight = "a point: an array of three numbers";
// The longest text, in bytes, that an error message quotes in full.
inline constexpr std::size_t kMaxQuoted = 40;

// The text as a JSON string, shortened to kMaxQuoted bytes.
std::string in_quotes(std::string_view text);
// Describes a value of any size in a few words.
std::string describe(const json& value);
// Throws "`where` must be `right`, not `given`".
[[noreturn]] void wrong(const std::string& where, const std::string& right, const json& given);

// Tests that number(), point() and setting() can apply to a number.
inline bool positive(double x) { return x > 0.0; }
inline bool not_negative(double x) { return x >= 0.0; }
inline bool any(double) { return true; }

double number(const json& value, const std::string& where, const std::string& right,
              bool (*accepted)(double));
// A whole number in [least, most]; 5, 5.0 and 5e0 are the same number.
double whole(const json& value, const std::string& where, double least, double most);
int integer(const json& value, const std::string& where, int least, int most);
bool boolean(const json& value, const std::string& where);
std::string path(const json& value, const std::string& where);
Vec3 point(const json& value, const std::string& where, const char* right = kPointIsRight,
           bool (*accepted)(double) = any);
// An array of points; empty if the object has no such field.
std::vector<Vec3> points(const json& object, const char* key);
// An array of three whole numbers, each in [least, most].
IVec3 whole_numbers(const json& value, const std::string& where, int least, int most);

enum : unsigned { kAllowAuto = 1, kAllowOff = 2 };
// allowed: kAllowAuto accepts "auto", kAllowOff accepts null.
Setting setting(const json& value, const std::string& where, const std::string& right,
                bool (*accepted)(double), unsigned allowed);

// The field's value, or null if the object does not have the field.
const json* find(const json& object, std::string_view key);
// The same for a field that must be there. prefix: the object's own name and a dot, for messages.
const json& require(const json& object, std::string_view key, std::string_view right,
                    std::string_view prefix = "");
// Throws if a nested value is no object or has a field that is not among `known`.
// owner: what the object describes ("twist").
void refuse_unknown(const json& value, const std::string& where, const std::string& owner,
                    std::initializer_list<const char*> known);

}  // namespace pectin::command_json
