#include "ffd/warp.h"

namespace pectin {

std::vector<LatticeField> DragStep::lattice_fields() const {
    std::vector<LatticeField> fields{{field.lattice(), field.control_displacements(displacements)}};
    if (symmetry) fields.push_back(image(symmetry->plane, fields.front()));
    return fields;
}

std::vector<Box> zones_of(const Warp::Step& step) {
    std::vector<Box> zones{lattice_of(step).influenced_zone()};
    const auto* drag = std::get_if<DragStep>(&step);
    if (drag && drag->symmetry) {
        const Box mirrored = image(drag->symmetry->plane, lattice_of(step)).influenced_zone();
        if (mirrored != zones.front()) zones.push_back(mirrored);
    }
    return zones;
}

std::vector<Box> Warp::zones() const {
    std::vector<Box> all;
    for (const Step& step : steps) {
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

double Warp::smallest_cell_extent() const {
    double extent = std::numeric_limits<double>::infinity();
    for (const Step& step : steps) {
        extent = std::min(extent, lattice_of(step).smallest_cell_extent());
    }
    return extent;
}

}  // namespace pectin
