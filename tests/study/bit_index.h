// The paper's bit index of cells with altered control points. The program does not use it: a tree
// finds the faces in the zone. The study measures what it would save.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 2.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "ffd/lattice.h"

namespace pectin::study {

// One bit for each cell of the influenced zone. Cell (i, j, k) lies between the control points
// (i, j, k) and (i + 1, j + 1, k + 1).
class BitIndex {
  public:
    explicit BitIndex(const Lattice& lattice)
        : lattice_(lattice), inverse_cell_(1.0 / lattice.cell), cells_(lattice.deformable + 3) {
        bits_.resize(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                     static_cast<std::size_t>(cells_.z));
    }

    // Marks the 64 cells that a control point acts on.
    void mark(const IVec3& control) {
        for (int k = -2; k < 2; ++k) {
            for (int j = -2; j < 2; ++j) {
                for (int i = -2; i < 2; ++i) bits_[bit(control + IVec3{i, j, k})] = true;
            }
        }
    }
    // Whether x lies in a marked cell.
    bool is_altered(const Vec3& x) const {
        const Vec3 u = (x - lattice_.origin) * inverse_cell_;
        const IVec3 cell{static_cast<int>(std::floor(u.x)), static_cast<int>(std::floor(u.y)),
                         static_cast<int>(std::floor(u.z))};
        for (int axis = 0; axis < 3; ++axis) {
            if (cell[axis] < kFirst || cell[axis] >= cells_[axis] + kFirst) return false;
        }
        return bits_[bit(cell)];
    }

  private:
    static constexpr int kFirst = -2;

    std::size_t bit(const IVec3& cell) const {
        const IVec3 at = cell - kFirst;
        return static_cast<std::size_t>(at.x + cells_.x * (at.y + cells_.y * at.z));
    }

    Lattice lattice_;
    Vec3 inverse_cell_;
    IVec3 cells_;
    std::vector<bool> bits_;
};

}  // namespace pectin::study
