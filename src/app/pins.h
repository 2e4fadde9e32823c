// Points of the surface that drags leave where they are.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/view.h"
#include "ffd/symmetry.h"
#include "session/session.h"

namespace pectin {

// With symmetry, the image of each pin is also held and shown, and can be used in its place.
class Pins {
  public:
    std::span<const Vec3> points() const { return points_; }
    bool is_empty() const { return points_.empty(); }
    void clear() { points_.clear(); }

    struct Marker {
        std::size_t pin;
        Vec3 position;  // of the pin or its image
    };
    // Returns the marker under the cursor. surface: the point of the object under the cursor, if
    // any; pins behind it are ignored.
    std::optional<Marker> at(const View& view, const Vec2& cursor,
                             const std::optional<Pick>& surface,
                             const std::optional<MirrorPlane>& symmetry) const;
    // Removes the pin under the cursor. If there is none, sets one on the surface. Returns whether
    // either was possible.
    bool toggle(const View& view, const Vec2& cursor, const std::optional<Pick>& surface,
                const std::optional<MirrorPlane>& symmetry);

  private:
    std::vector<Vec3> points_;
};

}  // namespace pectin
