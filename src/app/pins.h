// Points that drags hold where they are, as they are set in the window.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/view.h"
#include "ffd/symmetry.h"
#include "session/session.h"

namespace pectin {

// With symmetry a pin's image is held and shown as well, and stands for its pin.
class Pins {
  public:
    std::span<const Vec3> points() const { return points_; }
    bool is_empty() const { return points_.empty(); }
    void clear() { points_.clear(); }

    struct Marker {
        std::size_t pin;
        Vec3 position;  // of the pin or of its image
    };
    // The marker under the cursor. surface: what the cursor meets of the object; a pin behind it is
    // not meant.
    std::optional<Marker> at(const View& view, const Vec2& cursor,
                             const std::optional<Pick>& surface,
                             const std::optional<MirrorPlane>& symmetry) const;
    // Takes the pin under the cursor away, or else sets one where the cursor meets the surface.
    // Returns whether there was either.
    bool toggle(const View& view, const Vec2& cursor, const std::optional<Pick>& surface,
                const std::optional<MirrorPlane>& symmetry);

  private:
    std::vector<Vec3> points_;
};

}  // namespace pectin
