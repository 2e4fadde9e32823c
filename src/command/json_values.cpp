#include "command/json_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

double number(const json& value, const std::string& where, const std::string& right,
              bool (*accepted)(double)) {
    if (!value.is_number() || !accepted(value.get<double>())) wrong(where, right, value);
    return value.get<double>();
}

double whole(const json& value, const std::string& where, double least, double most) {
    const double x = value.is_number() ? value.get<double>() : least - 1.0;
    if (x == std::floor(x) && x >= least && x <= most) return x;
    wrong(where,
          "a whole number from " + json(static_cast<std::int64_t>(least)).dump() + " to " +
              json(static_cast<std::int64_t>(most)).dump(),
          value);
}

int integer(const json& value, const std::string& where, int least, int most) {
    return static_cast<int>(whole(value, where, least, most));
}

bool boolean(const json& value, const std::string& where) {
    if (!value.is_boolean()) wrong(where, "true or false", value);
    return value.get<bool>();
}

std::string path(const json& value, const std::string& where) {
    if (!value.is_string() || value.get_ref<const std::string&>().empty())
        wrong(where, kPathIsRight, value);
    const std::string text = value;
    if (text.find('\0') != text.npos)
        throw Problem(where + " must be a path without a NUL character");
    return text;
}

Vec3 point(const json& value, const std::string& where, const char* right,
           bool (*accepted)(double)) {
    if (!value.is_array() || value.size() != 3) wrong(where, right, value);
    Vec3 result(0.0);
    for (int axis = 0; axis < 3; ++axis)
        result[axis] =
            number(value[static_cast<std::size_t>(axis)], where + "[" + std::to_string(axis) + "]",
                   accepted == positive ? "a number above 0" : "a number", accepted);
    return result;
}

IVec3 whole_numbers(const json& value, const std::string& where, int least, int most) {
    if (!value.is_array() || value.size() != 3)
        wrong(where, "an array of three whole numbers", value);
    IVec3 result(0);
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = integer(value[static_cast<std::size_t>(axis)],
                               where + "[" + std::to_string(axis) + "]", least, most);
    return result;
}

Setting setting(const json& value, const std::string& where, const std::string& right,
                bool (*accepted)(double), unsigned allowed) {
    if ((allowed & kAllowOff) && value.is_null()) return Setting::off();
    if ((allowed & kAllowAuto) && value == "auto") return Setting::automatic();
    return Setting::of(number(value, where, right, accepted));
}

const json* find(const json& object, std::string_view key) {
    const auto found = object.find(std::string(key));
    return found == object.end() ? nullptr : &*found;
}

const json& require(const json& object, std::string_view key, std::string_view right,
                    std::string_view prefix) {
    if (const json* value = find(object, key)) return *value;
    std::string missing(prefix);
    missing.append(key).append(" is missing; it must be ").append(right);
    throw Problem(missing);
}

void refuse_unknown(const json& value, const std::string& where, const std::string& owner,
                    std::initializer_list<const char*> known) {
    std::string listing;
    for (const char* name : known) listing += (listing.empty() ? "" : ", ") + std::string(name);
    if (!value.is_object()) wrong(where, "an object with the fields " + listing, value);
    for (const auto& [key, unused] : value.items()) {
        const auto is_key = [&k = key](const char* name) { return k == name; };
        if (std::none_of(known.begin(), known.end(), is_key))
            throw Problem(where + " has the unknown field " + in_quotes(key) +
                          "; the fields of a " + owner + " are " + listing);
    }
}

std::vector<Vec3> points(const json& object, const char* key) {
    std::vector<Vec3> result;
    const json* array = find(object, key);
    if (!array) return result;
    if (!array->is_array()) wrong(key, "an array of points", *array);
    for (std::size_t i = 0; i < array->size(); ++i)
        result.push_back(point((*array)[i], std::string(key) + "[" + std::to_string(i) + "]"));
    return result;
}

}  // namespace pectin::command_json
