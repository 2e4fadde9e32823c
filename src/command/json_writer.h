// Writes JSON with the spaces and the order of fields that scripts have, and the shortest numbers
// that read back the same.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "command/command.h"

namespace pectin::command_json {

// Writes JSON text, either on one line or with one field on each line.
class JsonWriter {
  public:
    enum class Layout { line, indented };
    explicit JsonWriter(Layout layout) : layout_(layout) {}

    void open(char bracket) {
        text_ += bracket;
        ++depth_;
        is_first_ = true;
    }
    void close(char bracket) {
        --depth_;
        if (layout_ == Layout::indented) break_line();
        text_ += bracket;
        is_first_ = false;
    }
    // Writes what separates two fields or elements. Called before each of them.
    void next() {
        if (!is_first_) text_ += layout_ == Layout::line ? ", " : ",";
        if (layout_ == Layout::indented) break_line();
        is_first_ = false;
    }
    void key(std::string_view name) {
        next();
        value(name);
        text_ += ": ";
    }
    template <class T>
    void field(std::string_view name, const T& what) {
        key(name);
        value(what);
    }
    void null() { text_ += "null"; }
    void value(bool truth) { text_ += truth ? "true" : "false"; }
    void value(std::integral auto number) { append_number(number); }
    void value(double number) {
        if (!std::isfinite(number)) {
            null();
        } else if (number == 0.0 && std::signbit(number)) {
            text_ += "-0.0";  // "-0" would be read as the whole number 0
        } else {
            append_number(number);
        }
    }
    void value(std::string_view text);
    void value(const char* text) { value(std::string_view(text)); }
    void value(const Setting& setting) {
        if (setting.is_automatic()) value("auto");
        if (setting.is_off()) null();
        if (setting.kind == Setting::Kind::value) value(setting.value);
    }
    template <glm::length_t N, class T, glm::qualifier Q>
    void value(const glm::vec<N, T, Q>& vector) {
        open('[');
        for (glm::length_t axis = 0; axis < N; ++axis) {
            next();
            value(vector[axis]);
        }
        close(']');
    }
    std::string take() { return std::move(text_); }

  private:
    void break_line() { text_ += '\n' + std::string(2 * depth_, ' '); }
    void append_number(auto number) {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
        text_.append(digits.begin(), end);
    }

    Layout layout_;
    std::string text_;
    std::size_t depth_ = 0;
    bool is_first_ = true;
};

inline void JsonWriter::value(std::string_view text) {
    constexpr std::string_view kHexDigits = "0123456789abcdef";
    text_ += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            text_ += "\\u00";
            text_ += kHexDigits[static_cast<unsigned char>(c) >> 4];
            text_ += kHexDigits[static_cast<unsigned char>(c) & 15];
        } else {
            text_ += c;
        }
    }
    text_ += '"';
}

}  // namespace pectin::command_json
