// The limits that the schema gives to numbers of commands, for controls that offer a part of their
// range.
#pragma once

#include "command/schema.h"

namespace pectin {

constexpr field::Limits limits_of_type(const field::Number& type) { return type.limits; }
constexpr field::Limits limits_of_type(const field::NumberOr& type) { return type.limits; }
constexpr field::Limits limits_of_type(const field::Whole& type) {
    return field::between(type.least, type.most);
}
constexpr field::Limits limits_of_type(const field::Counts& type) {
    return field::between(type.least, type.most);
}

// The limits of a member of a command, such as limits_of(&command::Brush::span).
template <typename C, typename Member>
constexpr field::Limits limits_of(Member C::*member) {
    field::Limits limits;
    for_each_field<C>([&](const auto& field) {
        if constexpr (requires {
                          field.member == member;
                          limits_of_type(field.type);
                      }) {
            if (field.member == member) limits = limits_of_type(field.type);
        }
    });
    return limits;
}

}  // namespace pectin
