#include "ffd/warp.h"

#include <algorithm>
#include <limits>

namespace pectin {

std::vector<Box> Warp::zones() const {
    std::vector<Box> all;
    for (const Deformation& step : steps) {
        for (const Box& box : zones_of(step)) {
            if (std::find(all.begin(), all.end(), box) == all.end()) all.push_back(box);
        }
    }
    return all;
}

Box Warp::zone() const {
    Box box;
    for (const Box& zone : zones()) box.include(zone);
    return box;
}

double Warp::smallest_feature_extent() const {
    double extent = std::numeric_limits<double>::infinity();
    for (const Deformation& step : steps) {
        extent = std::min(extent, pectin::smallest_feature_extent(step));
    }
    return extent;
}

}  // namespace pectin
