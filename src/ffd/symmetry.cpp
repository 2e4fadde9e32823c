#include "ffd/symmetry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace pectin {
namespace {

// How many weights are evaluated at a time, on the stack. It does not change the results.
constexpr std::size_t kSmallBatch = 8, kLargeBatch = 512;

template <std::size_t batch>
void weights_in_batches(const DragField& field, const Symmetry& symmetry, const Vec3& x,
                        std::span<DragWeight> out) {
    const Vec3 mirrored = symmetry.plane.image(x);
    std::array<DragField::ExactWeight, batch> here, there;
    for (std::size_t first = 0; first < out.size(); first += batch) {
        const std::size_t count = std::min(batch, out.size() - first);
        field.exact_weights(x, first, std::span(here).first(count));
        field.exact_weights(mirrored, first, std::span(there).first(count));
        for (std::size_t m = 0; m < count; ++m) {
            const double parity = symmetry.parity[first + m];
            const Vec3 reflected = symmetry.plane.image_of_vector(there[m].gradient);
            out[first + m] = {.w = static_cast<float>(here[m].w + parity * there[m].w),
                              .gradient = Vec3f{here[m].gradient + parity * reflected}};
        }
    }
}

}  // namespace

Mat3 MirrorPlane::image_of_jacobian(Mat3 j) const {
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        j[axis][i] = -j[axis][i];
        j[i][axis] = -j[i][axis];
    }
    return j;
}

void symmetric_weights(const DragField& field, const Symmetry& symmetry, const Vec3& x,
                       std::span<DragWeight> out) {
    assert(out.size() == field.weight_count() && symmetry.parity.size() == out.size());
    std::fill(out.begin(), out.end(), DragWeight{});
    const Vec3 mirrored = symmetry.plane.image(x);
    if (!field.lattice().influences(x) && !field.lattice().influences(mirrored)) return;
    if (out.size() <= kSmallBatch) {
        weights_in_batches<kSmallBatch>(field, symmetry, x, out);
    } else {
        weights_in_batches<kLargeBatch>(field, symmetry, x, out);
    }
}

std::vector<Box> symmetric_zones(const MirrorPlane& plane, const Lattice& lattice) {
    std::vector<Box> zones{lattice.influenced_zone()};
    const Box mirrored = plane.image(zones.front());
    if (mirrored != zones.front()) zones.push_back(mirrored);
    return zones;
}

Lattice mirror_image(const MirrorPlane& plane, const Lattice& lattice) {
    Lattice mirrored = lattice;
    const Vec3 last = lattice.rest(lattice.deformable - 1);
    mirrored.origin[plane.axis] = plane.image(last)[plane.axis];
    return mirrored;
}

LatticeField mirror_image(const MirrorPlane& plane, const LatticeField& field) {
    const Lattice& lattice = field.lattice();
    std::vector<Vec3> displacements(lattice.control_count());
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                IVec3 opposite{i, j, k};
                opposite[plane.axis] = lattice.deformable[plane.axis] - 1 - opposite[plane.axis];
                displacements[lattice.control_index(opposite)] =
                    plane.image_of_vector(field.displacements()[lattice.control_index({i, j, k})]);
            }
        }
    }
    return {mirror_image(plane, lattice), std::move(displacements)};
}

}  // namespace pectin
