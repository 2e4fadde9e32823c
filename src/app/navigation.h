// Orbiting, panning and zooming of the camera, and views from chosen directions.
//
// Orbits turn about a pivot, which keeps its pixel: the point of the surface under the cursor, else
// the point that was touched last if it is in the window, else the target of the camera. Zooming
// goes towards the point under the cursor, which keeps its pixel. None of them takes the eye
// through the surface.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "app/input_event.h"
#include "app/mouse_preset.h"
#include "geometry/camera.h"
#include "geometry/up_axis.h"

namespace pectin {

// What navigation asks about the object that it shows.
class NavigatedObject {
  public:
    virtual ~NavigatedObject() = default;
    // The first point of the surface on the ray; nothing where there is none, or if it is unknown.
    virtual std::optional<Vec3> first_hit(const Ray& ray) = 0;
    // The distance of a point from the surface; infinite if it is unknown.
    virtual double distance(const Vec3& point) = 0;
    // The diagonal of the object's box, by which distances are limited; above 0.
    virtual double diagonal() const = 0;
};

// Limits of the camera's distance from what it looks at, in diagonals of the object's box. Zooming
// keeps the eye as far from the surface as the first one, so that the near plane cuts nothing off.
inline constexpr double kClosest = 2e-4, kFarthest = 50.0;
// Orbits and pans keep this part of the closest distance, so that the view can be turned by 45
// degrees also where zooming has ended.
inline constexpr double kTurnClearance = 0.7;

// Directions from the target to the eye, of models with y up (see oriented()). From above and below
// the view is a little tilted to the front, so that the back is up in the picture seen from above.
inline constexpr Vec3 kFrontView{0.0, 0.0, 1.0}, kBackView{0.0, 0.0, -1.0};
inline constexpr Vec3 kRightView{1.0, 0.0, 0.0}, kLeftView{-1.0, 0.0, 0.0};
inline constexpr Vec3 kTopView{0.0, 1.0, 1e-4}, kBottomView{0.0, -1.0, 1e-4};

class Navigation {
  public:
    // The object must outlive the navigation. It is not asked before the first gesture.
    explicit Navigation(NavigatedObject& object) : object_(object) {}

    const Camera& camera() const { return camera_; }
    UpAxis up_axis() const { return up_axis_; }

    // --- A gesture of the mouse, from press to release. size: of the window.
    void begin(NavigationMode mode, MouseButton button, const Vec2& at, const IVec2& size);
    // The same for an orbit that does not care what is under the cursor.
    void begin_orbit(MouseButton button, const Vec2& at, const IVec2& size);
    void move_to(const Vec2& at, const IVec2& size);
    // Goes on in another mode, with what is under the cursor now.
    void change_mode(NavigationMode mode, const IVec2& size);
    void end() { gesture_.reset(); }
    bool is_active() const { return gesture_.has_value(); }
    // The button that began the gesture, and what it does.
    std::optional<MouseButton> button() const;
    std::optional<NavigationMode> mode() const;

    // --- Steps. notches: of a wheel, in fractions where it is smooth; positive zooms in.
    void zoom(double notches, const Vec2& at, const IVec2& size);
    void pan(const Vec2& pixels, const IVec2& size);
    // Turns the view about the pivot, in radians: the eye moves to the right and upwards.
    void turn(double to_right, double upwards, const IVec2& size);

    // --- Views.
    // Takes note of a point of the surface that the user has touched.
    void touch(const Vec3& point) { pivot_ = point; }
    // Moves the camera so that all points are seen in the area, from `direction` or else from its
    // present one. direction: of a model with y up. The middle of the points is the pivot then.
    void frame(std::span<const Vec3> points, const PictureArea& area,
               const std::optional<Vec3>& direction = {});
    // The same from the present direction, after the area has changed. The pivot stays.
    void frame_again(std::span<const Vec3> points, const PictureArea& area);
    // Whether the camera has not moved since frame().
    bool is_as_framed() const { return framed_ == camera_; }
    // Turns the view about the pivot. direction: of a model with y up. Where the eye would be
    // within the object it moves out of it.
    void look_from(const Vec3& direction, const IVec2& size);
    // The present direction, of a model with y up and of any length.
    Vec3 direction() const { return with_y_up(up_axis_, camera_.eye - camera_.target); }
    // Turns the view so that it shows the model from the same direction with another axis up.
    void set_up_axis(UpAxis up, const IVec2& size);
    // What is in the middle of the picture keeps its size.
    void set_projection(Projection projection, const IVec2& size);

  private:
    // A point that keeps its pixel in a zoom.
    struct Anchor {
        Vec3 point;
        bool is_on_surface;
    };
    struct Gesture {
        NavigationMode mode;
        MouseButton button;
        Vec2 last;
        Vec3 pivot;     // of an orbit
        Anchor anchor;  // of a zoom
    };
    void prepare(Gesture& gesture, const IVec2& size);
    Anchor anchor_at(const Vec2& at, const IVec2& size);
    bool may_zoom(const Camera& from, double factor, const Anchor& anchor);
    void zoom_towards(const Anchor& anchor, double factor);
    void focus(const Vec3& point);
    // A movement of the camera: where it is after a part of it, from 0 to 1.
    using Path = std::function<Camera(double part)>;
    void follow(const Path& path, double length);
    void orbit(const Vec2& angles, const Vec3& pivot);
    void pan_by(const Vec2& pixels, const IVec2& size);
    void leave_object(const Vec3& point);
    Vec3 pivot(const IVec2& size) const;

    NavigatedObject& object_;
    Camera camera_;
    UpAxis up_axis_ = UpAxis::y;
    std::optional<Vec3> pivot_;  // the point that was touched last
    Camera framed_;              // after the last frame()
    // The camera of the last view by look_from() before and after it had to leave the object.
    Camera inside_, outside_;
    std::optional<Gesture> gesture_;
};

}  // namespace pectin
