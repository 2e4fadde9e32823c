// The shortest edge that refinement may produce.
#pragma once

namespace pectin {

// An edge may be split only if its halves are at least as long as the floor. Lengths are deformed
// lengths in world units.
class Floor {
  public:
    explicit Floor(double shortest_half)
        : min_squared_length_(2.0 * shortest_half * (2.0 * shortest_half)) {}

    bool forbids_split(double squared_length) const { return squared_length < min_squared_length_; }

  private:
    double min_squared_length_;  // of an edge that may be split
};

}  // namespace pectin
