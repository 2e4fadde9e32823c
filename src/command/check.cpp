#include "command/check.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "command/json_values.h"
#include "command/schema.h"
#include "geometry/decimal.h"

namespace pectin {
namespace {

std::string in_words(const Setting& setting) {
    if (setting.is_automatic()) return "\"auto\"";
    return setting.is_off() ? "null" : decimal(setting.value);
}

// --- Rules between fields. where: the object that has them, as in "moves[0]."; empty for a
// command.

template <typename Owner>
Done check_rules(const Owner&, const std::string&) {
    return {};
}

Done check_rules(const command::Adapt& adapt, const std::string&) {
    const auto is_number = [](const std::optional<Setting>& setting) {
        return setting && setting->kind == Setting::Kind::value;
    };
    if (!is_number(adapt.theta_max) || !is_number(adapt.theta_min) ||
        adapt.theta_min->value < adapt.theta_max->value) {
        return {};
    }
    return Refusal{"theta_min must be below theta_max, but is " + in_words(*adapt.theta_min) +
                       " against " + in_words(*adapt.theta_max),
                   "theta_min"};
}

Done check_rules(const command::Cage& cage, const std::string&) {
    const std::string choice = "; give either origin, cell and deformable, or fit";
    const bool has_grid = cage.origin || cage.cell || cage.deformable || cage.margin != IVec3{0};
    if (has_grid == cage.fit.has_value()) {
        return Refusal{
            (has_grid ? "the cage has both a lattice and fit" : "the cage has no lattice") +
            choice};
    }
    if (!has_grid) return {};
    const char* const missing = !cage.origin       ? "origin"
                                : !cage.cell       ? "cell"
                                : !cage.deformable ? "deformable"
                                                   : nullptr;
    if (missing) return Refusal{std::string(missing) + " is missing" + choice, missing};
    return {};
}

Done check_rules(const Twist& twist, const std::string& where) {
    if (twist.axis != Vec3{0.0}) return {};
    return Refusal{where + "axis must have a length above 0", where + "axis"};
}

Done check_rules(const Camera& camera, const std::string& where) {
    if (camera.is_valid()) return {};
    return Refusal{where.substr(0, where.size() - 1) +
                       " must look from eye to another point, target, with up at an angle to that",
                   where.substr(0, where.size() - 1)};
}

Done check_rules(const command::Shape& shape, const std::string&) {
    const auto kind = static_cast<std::size_t>(shape.kind);
    const field::Whole right{kind == 0 ? 0.0 : 1.0, static_cast<double>(kMostResolutions[kind])};
    if (shape.resolution >= right.least && shape.resolution <= right.most) return {};
    return Refusal{"resolution must be " + field::right(right) + " for this shape, not " +
                       std::to_string(shape.resolution),
                   "resolution"};
}

// --- One field.

// Whether the path ends so, in capitals or not.
bool has_extension(std::string_view path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    return std::ranges::equal(path.substr(path.size() - extension.size()), extension, {},
                              [](unsigned char c) { return std::tolower(c); });
}

class FieldChecker {
  public:
    template <typename Owner>
    static Done check_all(const Owner& owner, const std::string& prefix) {
        Done result;
        for_each_field<Owner>([&](const auto& field) {
            const auto* const value = field.value_in(owner);
            if (result && value) result = check(*value, field.type, prefix + field.name);
        });
        return result ? check_rules(owner, prefix) : result;
    }

  private:
    static Done refuse(const std::string& where, const std::string& right,
                       const std::string& given) {
        return Refusal{where + " must be " + right + ", not " + given, where};
    }

    static Done check(double x, const field::Number& type, const std::string& where) {
        return type.limits.contain(x) ? Done{} : refuse(where, right(type), decimal(x));
    }
    template <typename Number>
    static Done check(Number x, const field::Whole& type, const std::string& where) {
        const bool is_right =
            static_cast<double>(x) >= type.least && static_cast<double>(x) <= type.most;
        return is_right ? Done{} : refuse(where, right(type), std::to_string(x));
    }
    static Done check(const Setting& setting, const field::NumberOr& type,
                      const std::string& where) {
        const bool is_right = setting.is_automatic() ? type.may_be_auto
                              : setting.is_off()     ? type.may_be_null
                                                     : is_number(setting.value, type);
        return is_right ? Done{} : refuse(where, right(type), in_words(setting));
    }
    static bool is_number(double x, const field::NumberOr& type) {
        return type.limits.contain(x) && (!type.is_whole || x == std::floor(x));
    }
    static Done check(bool, const field::Flag&, const std::string&) { return {}; }
    template <typename Enumeration, std::size_t N>
    static Done check(Enumeration value, const field::Choice<N>& type, const std::string& where) {
        return static_cast<std::size_t>(value) < N
                   ? Done{}
                   : refuse(where, right(type), std::to_string(static_cast<int>(value)));
    }
    template <typename Enumeration, std::size_t N>
    static Done check(const std::optional<Enumeration>& value, const field::ChoiceOrNull<N>& type,
                      const std::string& where) {
        return !value || static_cast<std::size_t>(*value) < N
                   ? Done{}
                   : refuse(where, right(type), std::to_string(static_cast<int>(*value)));
    }
    static Done check(const std::string& path, const field::Path& type, const std::string& where) {
        if (path.empty()) return refuse(where, right(type), "an empty string");
        if (path.find('\0') != path.npos) {
            return Refusal{where + " must be a path without a NUL character", where};
        }
        if (type.extension && !has_extension(path, type.extension)) {
            return Refusal{where + " must end in " + type.extension + ", as " +
                               command_json::in_quotes("picture" + std::string(type.extension)) +
                               " does",
                           where};
        }
        return {};
    }
    static Done check(const Vec3& point, const field::Point& type, const std::string& where) {
        const field::Number number{type.limits};
        for (int axis = 0; axis < 3; ++axis) {
            if (Done done = check(point[axis], number, element(where, axis)); !done) return done;
        }
        return {};
    }
    template <glm::length_t N>
    static Done check(const glm::vec<N, int>& counts, const field::Counts& type,
                      const std::string& where) {
        const field::Whole number{static_cast<double>(type.least), static_cast<double>(type.most)};
        for (glm::length_t axis = 0; axis < N; ++axis) {
            if (Done done = check(counts[axis], number, element(where, axis)); !done) return done;
        }
        return {};
    }
    template <typename T, typename Element>
    static Done check(const std::vector<T>& values, const field::List<Element>& type,
                      const std::string& where) {
        if (values.empty() && !type.may_be_empty) {
            return refuse(where, "an array of one or more elements", "an empty array");
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (Done done = check(values[i], type.element, element(where, i)); !done) return done;
        }
        return {};
    }
    template <typename T>
    static Done check(const T& object, const field::Object&, const std::string& where) {
        return check_all(object, where + ".");
    }
    template <typename T>
    static Done check(const std::optional<T>& object, const field::ObjectOr&,
                      const std::string& where) {
        return object ? check_all(*object, where + ".") : Done{};
    }
    template <typename T>
    static Done check(const T&, const field::Names&, const std::string&) {
        return {};
    }

    static std::string element(const std::string& where, auto i) {
        return where + '[' + std::to_string(i) + ']';
    }
};

}  // namespace

Done check(const Command& command) {
    return std::visit([](const auto& c) { return FieldChecker::check_all(c, ""); }, command);
}

}  // namespace pectin
