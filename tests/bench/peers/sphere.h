// The sphere of the benchmarks as flat arrays for other libraries.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/shapes.h"

namespace pectin::bench {

struct FlatMesh {
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> triangles;  // three indices each

    double mean_edge() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            sum += glm::distance(positions[triangles[i]], positions[triangles[next]]);
        }
        return sum / static_cast<double>(triangles.size());
    }
};

inline FlatMesh flat_sphere(int resolution) {
    const IndexedFaceSet shape = make_shape(ShapeKind::sphere, resolution);
    FlatMesh mesh{shape.positions, {}};
    for (const auto& corner : shape.corners) mesh.triangles.push_back(corner.position);
    return mesh;
}

}  // namespace pectin::bench
