// What the fields of commands may be: numbers within limits, choices, points, lists and so on.
//
// right() says in words what a field must be, as in "radius must be a length above 0, not -1".
// Scripts, the session and the help all use these words.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace pectin::field {

// What a number measures. Lengths are in the model's units, angles in degrees.
enum class Unit { none, length, angle, ratio };

struct Limits {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    bool includes_least = true, includes_most = true;

    // False also for NaN and infinity.
    constexpr bool contain(double x) const {
        return (includes_least ? x >= least : x > least) && (includes_most ? x <= most : x < most);
    }
};

constexpr Limits above(double least) { return {.least = least, .includes_least = false}; }
constexpr Limits at_least(double least) { return {.least = least}; }
constexpr Limits between(double least, double most) { return {.least = least, .most = most}; }
constexpr Limits at_least_and_below(double least, double most) {
    return {.least = least, .most = most, .includes_most = false};
}

struct Number {
    Limits limits{};
    Unit unit = Unit::none;
};
// Above this, doubles skip whole numbers (2^53).
inline constexpr double kMostWhole = 9007199254740992.0;
// 5, 5.0 and 5e0 are the same whole number.
struct Whole {
    double least = 1.0, most = kMostWhole;
};
// A Setting: a number, and where or_auto() and or_null() allow it also "auto" or null.
struct NumberOr {
    Limits limits{};
    Unit unit = Unit::none;
    bool is_whole = false;
    bool may_be_auto = false, may_be_null = false;

    constexpr NumberOr or_auto() const { return {limits, unit, is_whole, true, may_be_null}; }
    constexpr NumberOr or_null() const { return {limits, unit, is_whole, may_be_auto, true}; }
};
struct Flag {};
// One of these words. An enumeration whose values are in this order.
template <std::size_t N>
struct Choice {
    std::array<const char*, N> words;
};
// The same, or null for an empty optional.
template <std::size_t N>
struct ChoiceOrNull {
    std::array<const char*, N> words;
};
struct Path {
    const char* file;                 // such as "an OBJ file"
    const char* extension = nullptr;  // that the path must have, with its dot; null: any
};
// Three numbers.
struct Point {
    Limits limits{};
};
// Whole numbers, as many as the member has components: IVec3, or IVec2 for a size.
struct Counts {
    int least = 0, most = 0;
};
template <typename Element>
struct List {
    Element element{};
    bool may_be_empty = true;
};
// An object with the fields of its Schema.
struct Object {};
// The same, or this word for an empty optional.
struct ObjectOr {
    const char* word;
};
// An object whose fields are all flags, written as the array of the names of those that are true.
struct Names {};

// "a, b or c"
std::string listed(const std::vector<std::string>& words, const char* last = "or");

std::string right(const Number& type);
std::string right(const Whole& type);
std::string right(const NumberOr& type);
std::string right(const Flag& type);
std::string right(const Path& type);
std::string right(const Point& type);
std::string right(const Counts& type, std::size_t count);
template <std::size_t N>
std::string right(const Choice<N>& type) {
    return listed({type.words.begin(), type.words.end()});
}
template <std::size_t N>
std::string right(const ChoiceOrNull<N>& type) {
    std::vector<std::string> words;
    for (const char* word : type.words) words.push_back('"' + std::string(word) + '"');
    words.emplace_back("null");
    return listed(words);
}

}  // namespace pectin::field
