#include "ffd/drag_step.h"

#include "ffd/injectivity.h"

namespace pectin {
namespace {

// Lattices whose origins differ by at most this fraction of a cell count as the same lattice.
constexpr double kSameLattice = 1e-9;

bool are_same(const Lattice& a, const Lattice& b) {
    return a.cell == b.cell && a.deformable == b.deformable &&
           glm::length((a.origin - b.origin) / a.cell) <= kSameLattice;
}

double side_count(const DragStep& drag) { return drag.symmetry ? 2.0 : 1.0; }

}  // namespace

std::vector<LatticeField> DragStep::lattice_fields() const {
    std::vector<LatticeField> fields{{field.lattice(), field.control_displacements(displacements)}};
    if (symmetry) fields.push_back(mirror_image(symmetry->plane, fields.front()));
    return fields;
}

std::vector<LatticeField> merged_lattices(const DragStep& drag) {
    std::vector<LatticeField> fields = drag.lattice_fields();
    if (fields.size() < 2 || !are_same(fields[0].lattice(), fields[1].lattice())) return fields;
    const std::span<Vec3> sum = fields[0].displacements();
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += fields[1].displacements()[i];
    fields.pop_back();
    return fields;
}

std::vector<Box> zones_of(const DragStep& drag) {
    const Lattice& lattice = drag.field.lattice();
    if (drag.symmetry) return symmetric_zones(drag.symmetry->plane, lattice);
    return {lattice.influenced_zone()};
}

double reach_bound(const DragStep& drag) {
    return side_count(drag) * drag.field.reach_bound(drag.displacements);
}

double lipschitz_bound(const DragStep& drag) {
    return 1.0 + side_count(drag) * (drag.field.lipschitz_bound(drag.displacements) - 1.0);
}

double injective_limit(const DragStep& drag, double most) {
    return injective_limit(drag.lattice_fields(), most);
}

}  // namespace pectin
