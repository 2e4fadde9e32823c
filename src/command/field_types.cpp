#include "command/field_types.h"

#include "geometry/decimal.h"

namespace pectin::field {
namespace {

constexpr Limits kNone{};

std::string noun(Unit unit, bool is_whole) {
    switch (unit) {
        case Unit::length:
            return "a length";
        case Unit::angle:
            return "an angle";
        case Unit::ratio:
            return "a ratio";
        case Unit::none:
            break;
    }
    return is_whole ? "a whole number" : "a number";
}

// What follows the noun, such as " above 0"; empty without limits.
std::string in_words(const Limits& limits) {
    const bool has_least = limits.least != kNone.least, has_most = limits.most != kNone.most;
    const std::string least = decimal(limits.least), most = decimal(limits.most);
    if (has_least && has_most && limits.includes_least && limits.includes_most) {
        return " from " + least + " to " + most;
    }
    std::string words;
    if (has_least) words += (limits.includes_least ? " of at least " : " above ") + least;
    if (has_least && has_most) words += " and";
    if (has_most) words += (limits.includes_most ? " of at most " : " below ") + most;
    return words;
}

}  // namespace

std::string listed(const std::vector<std::string>& words, const char* last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? ' ' + std::string(last) + ' ' : ", ";
        text += words[i];
    }
    return text;
}

std::string right(const Number& type) { return noun(type.unit, false) + in_words(type.limits); }

std::string right(const Whole& type) {
    return noun(Unit::none, true) + in_words(between(type.least, type.most));
}

std::string right(const NumberOr& type) {
    std::vector<std::string> words{noun(type.unit, type.is_whole) + in_words(type.limits)};
    if (type.may_be_auto) words.emplace_back("\"auto\"");
    if (type.may_be_null) words.emplace_back("null");
    return listed(words);
}

std::string right(const Flag&) { return "true or false"; }

std::string right(const Path& type) {
    const std::string ending = type.extension ? ", ending in " + std::string(type.extension) : "";
    return "the path of " + std::string(type.file) + ending;
}

std::string right(const Point& type) {
    const std::string limits = in_words(type.limits);
    return limits.empty() ? "a point: an array of three numbers"
                          : "an array of three numbers" + limits;
}

std::string right(const Counts& type, std::size_t count) {
    return std::string("an array of ") + (count == 2 ? "two" : "three") + " whole numbers" +
           in_words(between(type.least, type.most));
}

}  // namespace pectin::field
