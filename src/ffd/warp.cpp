#include "ffd/warp.h"

#include <utility>

namespace pectin {
namespace {

// Lattices whose origins are this share of a cell apart are the same to who looks at them.
constexpr double kSameLattice = 1e-9;

bool are_same(const Lattice& a, const Lattice& b) {
    return a.cell == b.cell && a.deformable == b.deformable &&
           glm::length((a.origin - b.origin) / a.cell) <= kSameLattice;
}

}  // namespace

std::vector<LatticeField> DragStep::lattice_fields() const {
    std::vector<LatticeField> fields{{field.lattice(), field.control_displacements(displacements)}};
    if (symmetry) fields.push_back(image(symmetry->plane, fields.front()));
    return fields;
}

std::vector<LatticeField> lattice_fields(const Warp::Step& step) {
    const auto* drag = std::get_if<DragStep>(&step);
    if (!drag) return {std::get<LatticeField>(step)};
    std::vector<LatticeField> fields = drag->lattice_fields();
    if (fields.size() < 2 || !are_same(fields[0].lattice(), fields[1].lattice())) return fields;
    const std::span<Vec3> sum = fields[0].displacements();
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += fields[1].displacements()[i];
    fields.pop_back();
    return fields;
}

Warp::Step compact(DragStep step) {
    const bool has_many_moves = step.displacements.size() > kMostWeights;
    Warp::Step drag{std::move(step)};
    if (!has_many_moves) return drag;
    std::vector<LatticeField> fields = lattice_fields(drag);
    if (fields.size() > 1) return drag;
    return std::move(fields.front());
}

std::vector<Box> zones_of(const Warp::Step& step) {
    std::vector<Box> zones{lattice_of(step).influenced_zone()};
    const auto* drag = std::get_if<DragStep>(&step);
    if (drag && drag->symmetry) {
        const Box mirrored = drag->symmetry->plane.image(zones.front());
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
