// A number that is changed by dragging sideways or typed after a double click.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

namespace pectin {

// How a number is shown, and what dragging covers.
struct NumberStyle {
    const char* format = "%.3g";  // of printf, for one double and nothing else
    const char* unit = "";        // follows the number, such as "°"
    // The values at the left and the right end. The first may be the larger one. Both are above 0
    // if the scale is logarithmic.
    double left = 0.0, right = 1.0;
    bool is_logarithmic = false;
    bool is_grouped = false;  // shows thousands apart
};

// The text of the number as the field shows it.
std::string number_text(double number, const NumberStyle& style);

// The nearest whole number that an int can be.
int whole_number(double value);

// Draws the fields of a panel and remembers which one is being changed.
class NumberField {
  public:
    // Draws a field as wide as ImGui::SetNextItemWidth() says. Returns the new value when the user
    // has set it, by ending a drag or typing. A drag stays within the style's range, and a typed
    // number may be any; whoever uses it refuses what is out of its limits. The value is rounded to
    // what the field shows.
    // id: unique in its window. instead: a word to show in place of the number, which can be
    // changed all the same; null: none.
    std::optional<double> draw(const char* id, double value, const NumberStyle& style,
                               const char* instead = nullptr);

    // The value of the field that was drawn last, while it is being dragged.
    std::optional<double> dragged() const { return dragged_; }

  private:
    struct Change {
        ImGuiID id = 0;
        bool is_typed = false;
        double before = 0.0, now = 0.0;
        double start = 0.0;  // where along the field the value was when the drag began, from 0 to 1
        bool has_moved = false;
    };
    struct Item;
    std::optional<double> type(const Item& item, double value, const NumberStyle& style);
    std::optional<double> drag(const Item& item, double value, const NumberStyle& style);
    std::optional<double> finish(const NumberStyle& style);

    std::optional<Change> change_;
    std::optional<double> dragged_;
};

}  // namespace pectin
