#include "app/tools/drag_constraint.h"

#include <array>
#include <charconv>
#include <cstdio>

namespace pectin {
namespace {

constexpr std::size_t kMostDigits = 16;

Vec3 unit_vector(int axis) {
    Vec3 unit{0.0};
    unit[axis] = 1.0;
    return unit;
}

Vec3 without(Vec3 v, int axis) {
    v[axis] = 0.0;
    return v;
}

}  // namespace

bool DragConstraint::press(Key key, bool shift) {
    if (key == Key::backspace) {
        if (digits_.empty()) {
            is_negative_ = false;
        } else {
            digits_.pop_back();
        }
        if (!is_typing()) direction_.reset();
        return true;
    }
    const int axis = static_cast<int>(key) - 'X';
    if (axis < 0 || axis > 2) return false;
    const bool is_again = axis_ == axis && is_plane_ == shift;
    axis_ = is_again ? std::nullopt : std::optional(axis);
    is_plane_ = !is_again && shift;
    direction_.reset();
    return true;
}

bool DragConstraint::type(unsigned int character) {
    if (character == '-') {
        is_negative_ = !is_negative_;
        return true;
    }
    const bool is_point = character == '.' || character == ',';
    if (!is_point && !(character >= '0' && character <= '9')) return false;
    const bool has_point = digits_.find('.') != digits_.npos;
    if (digits_.size() < kMostDigits && !(is_point && has_point)) {
        digits_.push_back(is_point ? '.' : static_cast<char>(character));
    }
    return true;
}

std::optional<double> DragConstraint::distance() const {
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(digits_.data(), digits_.data() + digits_.size(), value);
    if (error != std::errc{}) return std::nullopt;
    return is_negative_ ? -value : value;
}

Vec3 DragConstraint::displacement(const Vec3& cursor, const Vec3& start) {
    if (!is_typing()) return cursor;
    Vec3 direction{0.0};
    if (axis_ && !is_plane_) {
        direction = unit_vector(*axis_);
    } else {
        if (!direction_) {
            const Vec3 within = is_plane_ ? without(start, *axis_) : start;
            const bool has_begun = glm::length(cursor) >= glm::length(start);
            direction_ = unit_or_zero(has_begun ? cursor : within);
            if (*direction_ == Vec3{0.0}) direction_ = unit_vector((*axis_ + 1) % 3);
        }
        direction = *direction_;
    }
    const auto typed = distance();
    return typed ? *typed * direction : cursor;
}

std::string DragConstraint::description(const Vec3& displacement) const {
    std::string text = "Distance";
    if (axis_) {
        text += is_plane_ ? " in the plane across " : " along ";
        text += static_cast<char>('X' + *axis_);
    }
    text += ": ";
    if (is_typing()) {
        text += (is_negative_ ? "−" : "") + digits_ + "|";
    } else {
        const double distance =
            axis_ && !is_plane_ ? displacement[*axis_] : glm::length(displacement);
        std::array<char, 32> number{};
        std::snprintf(number.data(), number.size(), "%.4g", distance);
        text += number.data();
    }
    return text;
}

bool is_constraint_key(const event::KeyDown& key) {
    return !key.modifiers.control && (!key.is_repeat || key.key == Key::backspace);
}

std::string hint_of(const DragConstraint& constraint, const Vec3& displacement) {
    return constraint.description(displacement) + "  (Enter accepts, Esc gives back)";
}

}  // namespace pectin
