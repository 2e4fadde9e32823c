// The axes in a corner of the viewport: six ends that can be clicked to look along an axis.
#pragma once

#include <array>
#include <optional>

#include "app/tools/screen_box.h"
#include "geometry/camera.h"

namespace pectin {

// An end of an axis of the world: 0 is x, 1 is y, 2 is z.
struct AxisEnd {
    int axis = 0;
    bool is_positive = true;

    // The direction from the origin to the end; also that from which it is seen in front.
    Vec3 direction() const;
    bool operator==(const AxisEnd&) const = default;
};

// In window coordinates.
struct AxesGizmo {
    struct End {
        AxisEnd end{};
        Vec2 at{0.0};
        double nearness = 0.0;  // from -1 at the back to 1 at the front
    };
    Vec2 centre{0.0};
    double radius = 0.0;        // of the disc that contains the ends
    double end_radius = 0.0;    // of each end
    std::array<End, 6> ends{};  // from the back to the front

    bool contains(const Vec2& at) const;
    // The foremost end there.
    std::optional<AxisEnd> end_at(const Vec2& at) const;
};

// The gizmo in the upper right corner of the area. Nothing if there is not enough space for it.
// scale: of sizes, 1 on an ordinary screen.
std::optional<AxesGizmo> axes_gizmo(const Camera& camera, const ScreenBox& area, double scale);

}  // namespace pectin
