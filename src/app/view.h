// A camera with the size of the window that it looks through.
#pragma once

#include <optional>

#include "geometry/camera.h"

namespace pectin {

struct View {
    Camera camera{};
    IVec2 size{1};

    Ray ray_through(const Vec2& at) const { return camera.ray_through(at, size); }
    std::optional<Vec2> project(const Vec3& point) const { return camera.project(point, size); }
    double pixel_length(const Vec3& point) const { return camera.pixel_length(point, size); }
    // Distance from the eye along the view direction.
    double depth(const Vec3& point) const { return camera.depth(point); }
};

}  // namespace pectin
