// How far around the grabbed point a brush moves space, and by how much: the field of a drag of one
// point with no pins, in units of the brush's radius.
#pragma once

#include <cstdint>
#include <vector>

#include "ffd/drag_field.h"
#include "geometry/falloff.h"

namespace pectin {

// What moves by less than this fraction of the drag does not count as moved: a drag across 250
// pixels moves it by less than one. The field decreases to 0 with the third power, so that this is
// well inside the zone of the lattice.
inline constexpr double kEndOfMotion = 1.0 / 256.0;

class BrushProfile {
  public:
    // span: the number of control points per axis. Cost: 14,000 weights, some milliseconds.
    BrushProfile(int span, Falloff falloff);

    int span() const { return span_; }
    Falloff falloff() const { return falloff_; }

    // The weight of a point at this offset from the grabbed point, along the lattice's axes and in
    // radii: 1 at 0, and 0 from a radius on along any axis.
    double weight(const Vec3& offset) const;
    // The least distance, in radii, from which on the weight is below `level` in this direction.
    // It differs between directions, since the lattice is a grid.
    // Preconditions: unit length; 0 < level < 1. Cost: some hundred weights at most.
    double distance_at(double level, const Vec3& direction) const;

    // Weights at the points of a grid, as fractions of 255: kSamples per axis, x fastest, from the
    // grabbed point to a radius beyond along +x, +y and +z. The other octants are mirror images.
    static constexpr int kSamples = 24;
    const std::vector<std::uint8_t>& samples() const { return samples_; }

  private:
    int span_;
    Falloff falloff_;
    DragField field_;
    std::vector<std::uint8_t> samples_;
};

}  // namespace pectin
