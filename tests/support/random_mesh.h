// Random inputs for the property tests; the same seed gives the same case on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "ffd/lattice.h"
#include "ffd/warp.h"
#include "mesh/tri_mesh.h"

namespace pectin::test {

// std distributions differ between libraries; these do not.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int integer(int low, int high) {  // both included
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double p) { return uniform(0.0, 1.0) < p; }
    // A factor between low and high, as likely an octave up as down.
    double scale(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
    Vec3 direction();

  private:
    std::mt19937_64 engine_;
};

// What `count` cases should be here: more in a long run, fewer under sanitizers.
int case_count(int count);

// The same surface whose polygons share no vertices with others, as in files of separate facets;
// `share`: of the polygons, the others still share theirs.
void unshare_vertices(IndexedFaceSet& set, Random& random, double fraction = 1.0);

struct RandomMesh {
    TriMesh mesh;
    std::string description;
};

// Coarse and fine spheres, open grids, cubes with creases, cylinders, tori, a two-triangle
// square; many of them perturbed, stretched or with thin triangles, some with texture coordinates,
// colours, groups, lines; some damaged: not manifold, with faces turned, doubled or degenerate;
// some with polygons that coincide with their neighbours' vertices without sharing them.
RandomMesh random_mesh(Random& random);

// A drag of a point of the mesh by a brush or a cage with unequal cells, as one step of a warp.
Warp random_warp(const TriMesh& mesh, Random& random);

}  // namespace pectin::test
