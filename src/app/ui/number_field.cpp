#include "app/ui/number_field.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "app/ui/figure_text.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

constexpr float kDeadZone = 2.0f;      // a press that moves by fewer pixels changes nothing
constexpr double kFineFactor = 0.1;    // of a drag with Shift
constexpr double kNegligible = 1e-9;   // relative to the ends of the range
constexpr float kHandleWidth = 2.0f;   // of the line at the end of the filled part
constexpr float kMostRounding = 4.0f;  // of the filled part

double rounded(double value, const NumberStyle& style) {
    return std::strtod(formatted(style.format, value).c_str(), nullptr);
}

// Where the value lies between the ends, from 0 at the left to 1 at the right.
double position_of(double value, const NumberStyle& style) {
    const double low = std::min(style.left, style.right), high = std::max(style.left, style.right);
    const double inside = std::clamp(value, low, high);
    if (!style.is_logarithmic) return (inside - style.left) / (style.right - style.left);
    return std::log(inside / style.left) / std::log(style.right / style.left);
}

double value_at(double position, const NumberStyle& style) {
    const double t = std::clamp(position, 0.0, 1.0);
    if (!style.is_logarithmic) return style.left + t * (style.right - style.left);
    return style.left * std::pow(style.right / style.left, t);
}

void draw_frame(const ImRect& box, bool is_hovered, bool is_active) {
    const ImGuiCol colour = is_active    ? ImGuiCol_FrameBgActive
                            : is_hovered ? ImGuiCol_FrameBgHovered
                                         : ImGuiCol_FrameBg;
    ImGui::RenderFrame(box.Min, box.Max, ImGui::GetColorU32(colour), false,
                       ImGui::GetStyle().FrameRounding);
}

void draw_fill(const ImRect& box, double position, bool is_active) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float right = box.Min.x + static_cast<float>(position) * box.GetWidth();
    const float rounding = std::min(ImGui::GetStyle().FrameRounding, kMostRounding);
    const ImU32 fill = ImGui::GetColorU32(theme_colour(ThemeColour::fill));
    if (right - box.Min.x > 2.0f * rounding) {
        const bool is_full = position > 0.999;
        list.AddRectFilled(box.Min, ImVec2(right, box.Max.y), fill, rounding,
                           is_full ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersLeft);
    }
    const float half = 0.5f * kHandleWidth;
    const float at = std::clamp(right, box.Min.x + rounding, box.Max.x - rounding);
    list.AddRectFilled(
        ImVec2(at - half, box.Min.y), ImVec2(at + half, box.Max.y),
        ImGui::GetColorU32(is_active ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab));
}

void draw_text(const ImRect& box, const std::string& text, bool is_faint) {
    if (is_faint) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    }
    ImGui::RenderTextClipped(box.Min, box.Max, text.c_str(), nullptr, nullptr, ImVec2(0.5f, 0.5f));
    if (is_faint) ImGui::PopStyleColor();
}

}  // namespace

struct NumberField::Item {
    ImGuiID id;
    const char* label;
    ImRect box;
    const char* instead;

    // In place of a word every number is a new value.
    double value_before(double value) const {
        return instead ? std::numeric_limits<double>::quiet_NaN() : value;
    }
};

std::string number_text(double number, const NumberStyle& style) {
    // What rounding has left of 0 is not worth eight letters.
    const double largest = std::max(std::abs(style.left), std::abs(style.right));
    const double value =
        std::abs(number) < kNegligible * largest && !style.is_logarithmic ? 0.0 : number;
    std::string digits = formatted(style.format, value);
    if (style.is_grouped && value >= 0.0 && value < 1e15) {
        digits = grouped(static_cast<std::uint64_t>(std::llround(value)));
    }
    return digits + style.unit;
}

int whole_number(double value) {
    using Limits = std::numeric_limits<int>;
    return static_cast<int>(
        std::lround(std::clamp(value, double{Limits::lowest()}, double{Limits::max()})));
}

std::optional<double> NumberField::draw(const char* id, double value, const NumberStyle& style,
                                        const char* instead) {
    dragged_.reset();
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    if (window.SkipItems) return std::nullopt;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 end(at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight());
    const Item item{ImGui::GetID(id), id, ImRect(at, end), instead};
    ImGui::ItemSize(item.box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(item.box, item.id, &item.box)) return std::nullopt;
    const bool is_typing = ImGui::TempInputIsActive(item.id);
    const bool wants_to_type =
        ImGui::IsItemHovered() &&
        (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ||
         (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left)));
    return is_typing || wants_to_type ? type(item, value, style) : drag(item, value, style);
}

std::optional<double> NumberField::type(const Item& item, double value, const NumberStyle& style) {
    if (!change_ || change_->id != item.id || !change_->is_typed) {
        change_ = Change{.id = item.id,
                         .is_typed = true,
                         .before = item.value_before(value),
                         .now = rounded(value, style)};
    }
    double now = change_->now;
    if (ImGui::TempInputScalar(item.box, item.id, item.label, ImGuiDataType_Double, &now,
                               style.format)) {
        change_->now = now;
    }
    return ImGui::TempInputIsActive(item.id) ? std::nullopt : finish(style);
}

std::optional<double> NumberField::drag(const Item& item, double value, const NumberStyle& style) {
    bool is_hovered = false, is_held = false;
    ImGui::ButtonBehavior(item.box, item.id, &is_hovered, &is_held);
    if (is_hovered || is_held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const bool is_changing = change_ && change_->id == item.id;
    std::optional<double> set;
    if (is_held && (!is_changing || change_->is_typed)) {
        change_ = Change{.id = item.id,
                         .before = item.value_before(value),
                         .now = value,
                         .start = position_of(value, style)};
    }
    if (is_held) {
        const ImGuiIO& io = ImGui::GetIO();
        const float moved = io.MousePos.x - io.MouseClickedPos[ImGuiMouseButton_Left].x;
        change_->has_moved |= std::abs(moved) >= kDeadZone;
        const double by = static_cast<double>(moved / std::max(item.box.GetWidth(), 1.0f));
        const double position = change_->start + by * (io.KeyShift ? kFineFactor : 1.0);
        if (change_->has_moved) dragged_ = change_->now = rounded(value_at(position, style), style);
    } else if (is_changing) {
        set = finish(style);
    }
    const double shown = dragged_ ? *dragged_ : value;
    const bool has_word = item.instead && !dragged_;
    draw_frame(item.box, is_hovered, is_held);
    if (!has_word) draw_fill(item.box, position_of(shown, style), is_held);
    draw_text(item.box, has_word ? item.instead : number_text(shown, style), has_word);
    return set;
}

// Ends the change and returns the new value, if it is another one.
std::optional<double> NumberField::finish(const NumberStyle& style) {
    const Change ended = *change_;
    change_.reset();
    const bool is_same =
        formatted(style.format, ended.now) == formatted(style.format, ended.before);
    if (is_same || (!ended.is_typed && !ended.has_moved)) return std::nullopt;
    return ended.now;
}

}  // namespace pectin
