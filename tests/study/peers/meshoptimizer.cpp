#include <meshoptimizer.h>

#include <limits>

#include "study/peers/peers.h"
#include "study/scene.h"

namespace pectin::study {

DecimatedTriangles decimate_by_meshoptimizer(const IndexedTriangles& input, std::size_t triangles) {
    std::vector<Vec3f> positions;
    for (const Vec3& p : input.positions) positions.emplace_back(p);
    DecimatedTriangles result{.corners = std::vector<std::uint32_t>(input.corners.size())};
    std::size_t count = 0;
    result.seconds = seconds([&] {
        count = meshopt_simplify(result.corners.data(), input.corners.data(), input.corners.size(),
                                 &positions.data()->x, positions.size(), sizeof(Vec3f),
                                 3 * triangles, std::numeric_limits<float>::max());
    });
    result.corners.resize(count);
    return result;
}

}  // namespace pectin::study
