#include "app/view_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/picture.h"
#include "app/up_axis_guess.h"
#include "geometry/box.h"

namespace pectin {
namespace {

// The part of a window without panels in which objects are framed, and the least size of the part
// between panels, in window coordinates. Where there is less, the whole window counts.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;
constexpr double kLeastFreeSize = 64.0;
// A press on the axes that moves by fewer pixels is a click.
constexpr double kClickTolerance = 3.0;
// One notch of the wheel pans by this part of the window's height.
constexpr double kPanPerNotch = 0.06;
// Two directions are the same if the cosine of their angle is larger (about 0.6 degrees).
constexpr double kSameDirection = 0.99995;

}  // namespace

// --- Input.

bool ViewControl::press_before_tools(const event::Press& press, bool holds_space) {
    began_with_alt_ = press.modifiers.alt;
    const std::optional<AxesGizmo> gizmo = axes();
    if (press.button == MouseButton::left && gizmo && gizmo->contains(press.at)) {
        axes_press_ = AxesPress{press.at, gizmo->end_at(press.at)};
        navigation_.begin_orbit(press.button, press.at, size_);
        return true;
    }
    const MouseBinding& binding = binding_of(preset(), press.button, press.modifiers, holds_space);
    if (press.button != MouseButton::left || !binding.is_anywhere) return false;
    navigation_.begin(binding.mode, press.button, press.at, size_);
    return true;
}

void ViewControl::press(const event::Press& press) {
    const MouseBinding& binding = binding_of(preset(), press.button, press.modifiers);
    navigation_.begin(binding.mode, press.button, press.at, size_);
}

void ViewControl::move(const Vec2& at, const Modifiers& modifiers) {
    if (axes_press_) {
        axes_press_->has_moved |= glm::distance(at, axes_press_->at) > kClickTolerance;
        if (!axes_press_->has_moved) return;
    }
    const bool zooms = releasing_alt_zooms(preset()) && began_with_alt_ && !modifiers.alt;
    if (zooms && navigation_.mode() == NavigationMode::pan) {
        navigation_.change_mode(NavigationMode::zoom, size_);
    }
    navigation_.move_to(at, size_);
}

void ViewControl::release(MouseButton button) {
    if (navigation_.button() != button) return;
    const std::optional<AxesPress> press = axes_press_;
    cancel();
    if (press && !press->has_moved && press->end && !workspace_.is_working()) {
        look_along(*press->end);
    }
}

void ViewControl::cancel() {
    axes_press_.reset();
    navigation_.end();
}

void ViewControl::scroll(const event::Scroll& scroll, const Modifiers& modifiers) {
    const double step = kPanPerNotch * size_.y;
    const bool is_sideways = std::abs(scroll.sideways) > std::abs(scroll.amount);
    if (modifiers.shift) {
        navigation_.pan(step * Vec2(scroll.sideways, scroll.amount), size_);
    } else if (is_sideways && !modifiers.control) {
        navigation_.pan({step * scroll.sideways, 0.0}, size_);
    } else {
        navigation_.zoom(scroll.amount, scroll.at, size_);
    }
}

bool ViewControl::has_priority(const Vec2& at, const Modifiers& modifiers, bool holds_space) const {
    if (is_active()) return true;
    const std::optional<AxesGizmo> gizmo = axes();
    if (gizmo && gizmo->contains(at)) return true;
    return binding_of(preset(), MouseButton::left, modifiers, holds_space).is_anywhere;
}

std::string_view ViewControl::hint(const Vec2& at, const Modifiers& modifiers,
                                   bool holds_space) const {
    const std::optional<AxesGizmo> gizmo = axes();
    if (!is_active() && gizmo && gizmo->contains(at)) {
        return "Click an axis to look along it, or drag to rotate the view.";
    }
    const MouseBinding& binding = binding_of(preset(), MouseButton::left, modifiers, holds_space);
    const bool is_hovering = !is_active();
    switch (navigation_.mode().value_or(binding.mode)) {
        case NavigationMode::pan:
            return "Drag to pan the view.";
        case NavigationMode::zoom:
            return "Drag up to zoom in and down to zoom out.";
        case NavigationMode::orbit:
            break;
    }
    if (is_hovering && !holds_space && modifiers == Modifiers{}) {
        return preset() == MousePreset::zbrush
                   ? "Drag the background to rotate the view, Alt+drag to pan; wheel to zoom."
                   : "Drag the background to rotate the view, Shift+drag to pan; wheel to zoom.";
    }
    return is_hovering ? "Drag to rotate the view, with Shift to pan and with Ctrl to zoom."
                       : "Drag to rotate the view.";
}

// --- The part of the window.

void ViewControl::set_free_area(const ScreenBox& area, double scale) {
    free_area_ = area;
    scale_ = scale;
}

ScreenBox ViewControl::free_area() const {
    const Vec2 size(size_);
    if (!free_area_) {
        const Vec2 half = 0.5 * Vec2(kFreeWidth, kFreeHeight) * size;
        return {0.5 * size - half, 0.5 * size + half};
    }
    const Vec2 low = glm::clamp(glm::min(free_area_->from, free_area_->to), Vec2(0.0), size);
    const Vec2 high = glm::clamp(glm::max(free_area_->from, free_area_->to), Vec2(0.0), size);
    const Vec2 extent = high - low;
    if (std::min(extent.x, extent.y) < kLeastFreeSize) return {Vec2(0.0), size};
    return {low, high};
}

PictureArea ViewControl::picture_area() const {
    const auto [low, high] = free_area();
    const Vec2 middle = 0.5 * Vec2(size_);
    const double unit = 2.0 / size_.y;
    return {.min = unit * Vec2(low.x - middle.x, middle.y - high.y),
            .max = unit * Vec2(high.x - middle.x, middle.y - low.y)};
}

void ViewControl::follow_free_area() {
    const PictureArea area = picture_area();
    const bool is_new = area.min != framed_area_.min || area.max != framed_area_.max;
    if (!is_new || is_active() || !navigation_.is_as_framed()) return;
    framed_area_ = area;
    navigation_.frame_again(points_to_frame(), area);
}

std::optional<AxesGizmo> ViewControl::axes() const {
    return free_area_ ? axes_gizmo(camera(), free_area(), scale_) : std::nullopt;
}

std::optional<AxisEnd> ViewControl::axis_at(const Vec2& at) const {
    if (axes_press_) return axes_press_->has_moved ? std::nullopt : axes_press_->end;
    const std::optional<AxesGizmo> gizmo = axes();
    return gizmo && !is_active() ? gizmo->end_at(at) : std::nullopt;
}

// --- Views.

std::vector<Vec3> ViewControl::points() const {
    std::vector<Vec3> all = referenced_positions(workspace_.session().mesh());
    if (const auto& cage = workspace_.session().lattice_settings().cage) {
        const IVec3 last = cage->deformable - 1;
        for (int i = 0; i < 8; ++i) {
            all.push_back(cage->rest(last * IVec3{i % 2, i / 2 % 2, i / 4}));
        }
    }
    return all;
}

bool ViewControl::shows(const std::vector<Vec3>& points) const {
    const ScreenBox area = free_area();
    return std::ranges::all_of(points, [&](const Vec3& point) {
        const std::optional<Vec2> pixel = camera().project(point, size_);
        return pixel && glm::all(glm::lessThanEqual(area.from, *pixel)) &&
               glm::all(glm::lessThanEqual(*pixel, area.to));
    });
}

void ViewControl::frame_all(const std::optional<Vec3>& direction) {
    framed_.clear();
    framed_area_ = picture_area();
    navigation_.frame(points(), framed_area_, direction);
}

void ViewControl::frame_with(std::span<const Vec3> others) {
    framed_.assign(others.begin(), others.end());
    framed_area_ = picture_area();
    navigation_.frame(points_to_frame(), framed_area_, kFitDirection);
}

std::vector<Vec3> ViewControl::points_to_frame() const {
    std::vector<Vec3> all = points();
    all.insert(all.end(), framed_.begin(), framed_.end());
    return all;
}

void ViewControl::look_from(const Vec3& direction) {
    if (navigation_.is_as_framed()) return frame_all(direction);
    const std::vector<Vec3> all = points();
    const bool were_visible = shows(all);
    navigation_.look_from(direction, size_);
    if (were_visible && !shows(all)) frame_all(direction);
}

void ViewControl::look_along(const AxisEnd& end) {
    Vec3 direction = with_y_up(up_axis(), end.direction());
    const Vec3 now = glm::normalize(navigation_.direction());
    if (glm::dot(now, direction) > kSameDirection) direction = -direction;
    if (direction.y != 0.0) direction = direction.y > 0.0 ? kTopView : kBottomView;
    look_from(direction);
}

void ViewControl::turn(double degrees_to_right, double degrees_upwards) {
    navigation_.turn(glm::radians(degrees_to_right), glm::radians(degrees_upwards), size_);
}

void ViewControl::zoom(double notches) {
    const auto [low, high] = free_area();
    navigation_.zoom(notches, 0.5 * (low + high), size_);
}

void ViewControl::set_projection(Projection projection) {
    const bool is_as_framed = navigation_.is_as_framed();
    navigation_.set_projection(projection, size_);
    if (is_as_framed) frame_all();
}

void ViewControl::set_up_axis(UpAxis up) {
    if (up == up_axis()) return;
    navigation_.set_up_axis(up, size_);
    frame_all();
}

void ViewControl::begin_object() {
    navigation_.set_up_axis(
        guessed_up_axis(workspace_.session().read_report().up_axis, workspace_.box()), size_);
    frame_all(kFitDirection);
}

// --- The object, as navigation asks about it.

std::optional<Vec3> ViewControl::first_hit(const Ray& ray) {
    if (workspace_.is_working()) return std::nullopt;
    const std::optional<Pick> pick = workspace_.session().pick(ray);
    return pick ? std::optional(pick->point) : std::nullopt;
}

double ViewControl::distance(const Vec3& point) {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    if (workspace_.is_working()) return kUnknown;
    return workspace_.session().distance_to_surface(point).value_or(kUnknown);
}

double ViewControl::diagonal() const {
    const double diagonal = workspace_.diagonal();
    return diagonal > 0.0 ? diagonal : 1.0;
}

}  // namespace pectin
