// Random inputs for the property tests. The same seed gives the same input on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "ffd/lattice.h"
#include "ffd/warp.h"
#include "mesh/tri_mesh.h"

namespace pectin::test {

// Distributions that, unlike those of std, are the same in every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int integer(int low, int high) {  // including both
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double p) { return uniform(0.0, 1.0) < p; }
    // A factor between low and high; its logarithm is uniformly distributed.
    double scale(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
    Vec3 direction();

  private:
    std::mt19937_64 engine_;
};

// Gives polygons their own vertices, as in files of separate facets. `share`: the fraction of
// polygons to which this applies.
void unshare_vertices(IndexedFaceSet& set, Random& random, double fraction = 1.0);

struct RandomMesh {
    TriMesh mesh;
    std::string description;
};

// A random mesh: a sphere, an open grid, a cube with creases, a cylinder, a torus or a square of
// two triangles. Many are perturbed, stretched or have thin triangles. Some have texture
// coordinates, colours, groups or lines. Some are damaged: non-manifold, or with reversed,
// duplicate or degenerate faces. Some have polygons that meet without sharing vertices.
RandomMesh random_mesh(Random& random);

// A random drag of a point of the mesh, with a brush or a lattice of unequal cells, as one step of
// a warp.
Warp random_warp(const TriMesh& mesh, Random& random);

}  // namespace pectin::test
