#include "command/json_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "command/json_values.h"
#include "command/schema.h"

namespace pectin::command_json {
namespace {

// Reads values of the right type. Whether they are within their limits is for check() to say, apart
// from whole numbers, which have to fit their member.
class FieldReader {
  public:
    // prefix: the object's own name and a dot, for messages; empty for a command.
    template <typename Owner>
    static void read_all(const json& object, Owner& owner, const std::string& prefix) {
        for_each_field<Owner>([&](const auto& field) {
            const json* const value = find(object, field.name);
            const std::string where = prefix + field.name;
            if (value) {
                read(*value, field.type, where, field.add_to(owner));
            } else if (field.is_required()) {
                throw Problem(where + " is missing; it must be " +
                              right_of(field.type, field.any_value()));
            }
        });
    }

  private:
    // --- What is right, also for the types that depend on their member.
    template <typename Type, typename T>
    static std::string right_of(const Type& type, const T&) {
        return right(type);
    }
    template <glm::length_t N>
    static std::string right_of(const field::Counts& type, const glm::vec<N, int>&) {
        return right(type, static_cast<std::size_t>(N));
    }
    template <typename Element, typename T>
    static std::string right_of(const field::List<Element>& type, const std::vector<T>&) {
        return std::string("an array of ") + (type.may_be_empty ? "" : "one or more ") +
               plural_of(type.element, T{});
    }
    static std::string plural_of(const field::Point&, const Vec3&) { return "points"; }
    template <typename T>
    static std::string plural_of(const field::Object&, const T&) {
        return "objects with the fields " + names_of<T>();
    }
    template <typename T>
    static std::string right_of(const field::Object&, const T&) {
        return "an object with the fields " + names_of<T>();
    }
    template <typename T>
    static std::string right_of(const field::ObjectOr& type, const std::optional<T>&) {
        return '"' + std::string(type.word) + "\" or an object with the fields " + names_of<T>();
    }
    template <typename T>
    static std::string right_of(const field::Names&, const T&) {
        return "an array of any of " + names_of<T>();
    }

    // --- Reading.
    static void read(const json& value, const field::Number& type, const std::string& where,
                     double& to) {
        if (!value.is_number()) wrong(where, right(type), value);
        to = value.get<double>();
    }
    template <typename Integer>
    static void read(const json& value, const field::Whole& type, const std::string& where,
                     Integer& to) {
        const double x = value.is_number() ? value.get<double>() : type.least - 1.0;
        if (x != std::floor(x) || x < type.least || x > type.most) wrong(where, right(type), value);
        to = static_cast<Integer>(x);
    }
    static void read(const json& value, const field::NumberOr& type, const std::string& where,
                     Setting& to) {
        if (value.is_null()) {
            to = Setting::off();
        } else if (value == "auto") {
            to = Setting::automatic();
        } else if (value.is_number()) {
            to = Setting::of(value.get<double>());
        } else {
            wrong(where, right(type), value);
        }
    }
    static void read(const json& value, const field::Flag& type, const std::string& where,
                     bool& to) {
        if (!value.is_boolean()) wrong(where, right(type), value);
        to = value.get<bool>();
    }
    template <typename Enumeration, std::size_t N>
    static void read(const json& value, const field::Choice<N>& type, const std::string& where,
                     Enumeration& to) {
        const auto found = std::find(type.words.begin(), type.words.end(), value);
        if (found == type.words.end()) wrong(where, right(type), value);
        to = static_cast<Enumeration>(found - type.words.begin());
    }
    template <typename Enumeration, std::size_t N>
    static void read(const json& value, const field::ChoiceOrNull<N>& type,
                     const std::string& where, std::optional<Enumeration>& to) {
        to.reset();
        if (value.is_null()) return;
        const auto found = std::find(type.words.begin(), type.words.end(), value);
        if (found == type.words.end()) wrong(where, right(type), value);
        to = static_cast<Enumeration>(found - type.words.begin());
    }
    static void read(const json& value, const field::Path& type, const std::string& where,
                     std::string& to) {
        if (!value.is_string()) wrong(where, right(type) + " in quotes", value);
        to = value.get<std::string>();
    }
    static void read(const json& value, const field::Point& type, const std::string& where,
                     Vec3& to) {
        if (!value.is_array() || value.size() != 3) wrong(where, right(type), value);
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            read(value[i], field::Number{type.limits}, element(where, i), to[axis]);
        }
    }
    template <glm::length_t N>
    static void read(const json& value, const field::Counts& type, const std::string& where,
                     glm::vec<N, int>& to) {
        if (!value.is_array() || value.size() != static_cast<std::size_t>(N)) {
            wrong(where, right_of(type, to), value);
        }
        const field::Whole number{static_cast<double>(type.least), static_cast<double>(type.most)};
        for (glm::length_t axis = 0; axis < N; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            read(value[i], number, element(where, i), to[axis]);
        }
    }
    template <typename T, typename Element>
    static void read(const json& value, const field::List<Element>& type, const std::string& where,
                     std::vector<T>& to) {
        if (!value.is_array()) wrong(where, right_of(type, to), value);
        to.clear();
        for (std::size_t i = 0; i < value.size(); ++i) {
            read(value[i], type.element, element(where, i), to.emplace_back());
        }
    }
    template <typename T>
    static void read(const json& value, const field::Object& type, const std::string& where,
                     T& to) {
        if (!value.is_object()) wrong(where, right_of(type, to), value);
        for (const auto& [key, unused] : value.items()) {
            if (!has_field<T>(key)) {
                throw Problem(where + " has the unknown field " + in_quotes(key) +
                              "; the fields of a " + Schema<T>::kName + " are " + names_of<T>());
            }
        }
        read_all(value, to, where + ".");
    }
    template <typename T>
    static void read(const json& value, const field::ObjectOr& type, const std::string& where,
                     std::optional<T>& to) {
        to.reset();
        if (value == type.word) return;
        if (!value.is_object()) wrong(where, right_of(type, to), value);
        read(value, field::Object{}, where, to.emplace());
    }
    template <typename T>
    static void read(const json& value, const field::Names& type, const std::string& where, T& to) {
        if (!value.is_array()) wrong(where, right_of(type, to), value);
        for (std::size_t i = 0; i < value.size(); ++i) {
            bool is_known = false;
            for_each_field<T>([&](const auto& field) {
                if (value[i] != field.name) return;
                to.*field.member = true;
                is_known = true;
            });
            if (!is_known) wrong(element(where, i), names_of<T>("or"), value[i]);
        }
    }

    template <typename T>
    static std::string names_of(const char* last = "and") {
        std::vector<std::string> names;
        for_each_field<T>([&](const auto& field) { names.emplace_back(field.name); });
        return field::listed(names, last);
    }
    template <typename T>
    static bool has_field(const std::string& name) {
        bool has = false;
        for_each_field<T>([&](const auto& field) { has = has || name == field.name; });
        return has;
    }
    static std::string element(const std::string& where, std::size_t i) {
        return where + '[' + std::to_string(i) + ']';
    }
};

template <std::size_t I>
Command read_as(const json& object) {
    std::variant_alternative_t<I, Command> command;
    FieldReader::read_all(object, command, "");
    return command;
}

}  // namespace

Command read_fields(std::size_t index, const json& object) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
        using Reader = Command (*)(const json&);
        static constexpr Reader kReaders[] = {read_as<I>...};
        return kReaders[index](object);
    }
    (std::make_index_sequence<std::variant_size_v<Command>>());
}

}  // namespace pectin::command_json
