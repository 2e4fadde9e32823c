// Random lattices and points for the tests of ffd, reproducible by their seed.
#pragma once

#include <random>
#include <vector>

#include "ffd/lattice.h"

namespace pectin {

class LatticeRandom {
  public:
    explicit LatticeRandom(unsigned seed) : generator_{seed} {}

    double between(double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(generator_);
    }
    Vec3 vector(double least, double most) {
        const double x = between(least, most), y = between(least, most);
        return {x, y, between(least, most)};
    }
    std::vector<Vec3> vectors(std::size_t number) {
        std::vector<Vec3> all(number);
        for (Vec3& one : all) one = vector(-1.0, 1.0);
        return all;
    }
    int count(int least, int most) {
        return std::uniform_int_distribution<int>{least, most}(generator_);
    }

    // A lattice with unequal cells and `least` to `most` control points per axis.
    Lattice lattice(const Vec3& about, int least, int most) {
        const Vec3 origin = about + vector(-5.0, 5.0);
        const Vec3 cell = vector(0.2, 3.0);
        const int l = count(least, most), m = count(least, most);
        return {.origin = origin, .cell = cell, .deformable = {l, m, count(least, most)}};
    }
    // A point at least `margin` cells inside the influenced zone, or with a negative margin up to
    // that far outside.
    Vec3 point_in(const Lattice& lattice, double margin) {
        const Vec3 reach = Vec3{lattice.deformable} + 3.0 - 2.0 * margin;
        return lattice.origin + (margin - 2.0 + vector(0.0, 1.0) * reach) * lattice.cell;
    }
    // A point on the border of the influenced zone, or up to `beyond` outside.
    Vec3 point_outside(const Lattice& lattice, double beyond) {
        const Box zone = lattice.influenced_zone();
        Vec3 x = point_in(lattice, 0.0);
        const int axis = count(0, 2);
        const double by = count(0, 1) == 0 ? 0.0 : between(0.0, beyond);
        x[axis] = count(0, 1) == 0 ? zone.min[axis] - by : zone.max[axis] + by;
        return x;
    }
    // Adds points that are at least a cell away from each other and from the border of the zone.
    void add_points(const Lattice& lattice, int more, std::vector<Vec3>& points) {
        const std::size_t wanted = points.size() + static_cast<std::size_t>(more);
        while (points.size() < wanted) {
            const Vec3 point = point_in(lattice, 1.2);
            bool is_apart = true;
            for (const Vec3& other : points) {
                is_apart = is_apart && glm::length((point - other) / lattice.cell) > 1.0;
            }
            if (is_apart) points.push_back(point);
        }
    }

  private:
    std::mt19937 generator_;
};

}  // namespace pectin
