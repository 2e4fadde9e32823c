// The operations that all deformations of space share.
#include "ffd/deformation.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "ffd/cofactor.h"
#include "ffd/drag_solver.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

constexpr MirrorPlane kPlane{.axis = 0, .at = 0.0};
const Vec3 kHandle{0.4, 0.1, 0.0};

DragSolver solver(const std::optional<MirrorPlane>& plane) {
    const Lattice lattice = brush_lattice(kHandle, 1.0, 3);
    return std::get<DragSolver>(
        DragSolver::create(lattice, std::array{Handle{kHandle}}, {}, plane));
}

std::vector<std::pair<std::string, Deformation>> deformations() {
    const std::array motions{HandleMotion{{0.05, 0.2, -0.1}}};
    const DragStep drag = solver(std::nullopt).step(motions);
    return {{"drag", drag},
            {"symmetric drag", solver(kPlane).step(motions)},
            {"lattice", drag.lattice_fields().front()},
            {"symmetric lattice", SymmetricLattice{drag.lattice_fields().front(), kPlane}}};
}

TEST(Deformation, HasTheJacobianOfItsImage) {
    test::Random random(31);
    const double h = 1e-3;
    for (const auto& [name, deformation] : deformations()) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 x = kHandle + 0.9 * random.direction();
            const Mat3 j = jacobian(deformation, x);
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 e{0.0};
                e[axis] = h;
                const Vec3 difference =
                    (image(deformation, x + e) - image(deformation, x - e)) / (2.0 * h);
                EXPECT_LT(glm::distance(difference, j[axis]), 1e-4) << name;
            }
        }
    }
}

TEST(Deformation, TransformsNormalsByTheCofactorsOfItsJacobian) {
    test::Random random(32);
    for (const auto& [name, deformation] : deformations()) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 x = kHandle + 0.7 * random.direction();
            const Vec3f n{random.direction()};
            const Vec3 expected = glm::normalize(cofactor_times(jacobian(deformation, x), Vec3{n}));
            const Vec3 normal{covariant_normal(deformation, x, n)};
            EXPECT_LT(glm::distance(normal, expected), 1e-5) << name;
        }
    }
}

TEST(Deformation, MovesNothingOutsideItsZonesAndWithinItsBounds) {
    test::Random random(33);
    for (const auto& [name, deformation] : deformations()) {
        const double reach = reach_bound(deformation), stretch = lipschitz_bound(deformation);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 x = kHandle + random.uniform(0.0, 2.5) * random.direction();
            const Vec3 y = x + 1e-3 * random.direction();
            bool is_inside = false;
            for (const Box& zone : zones_of(deformation)) is_inside |= zone.contains_strictly(x);
            if (!is_inside) {
                EXPECT_EQ(image(deformation, x), x) << name;
            }
            EXPECT_LE(glm::distance(image(deformation, x), x), reach * (1.0 + 1e-6)) << name;
            EXPECT_LE(glm::distance(image(deformation, x), image(deformation, y)),
                      glm::distance(x, y) * stretch * (1.0 + 1e-4))
                << name;
        }
    }
}

TEST(Deformation, EqualsTheSumOfItsMergedLattices) {
    test::Random random(34);
    for (const auto& [name, deformation] : deformations()) {
        const std::vector<LatticeField> fields = merged_lattices(deformation);
        EXPECT_EQ(fields.size(), name.starts_with("symmetric") ? 2u : 1u);
        for (int i = 0; i < 100; ++i) {
            const Vec3 x = kHandle + 0.9 * random.direction();
            Vec3 sum = x;
            for (const LatticeField& field : fields) sum += field.displacement(x);
            EXPECT_LT(glm::distance(sum, image(deformation, x)), 1e-6) << name;
        }
    }
}

TEST(Deformation, IsProvenOneToOneOnlyWhereItsJacobianStaysRegular) {
    test::Random random(35);
    for (auto& [name, deformation] : deformations()) {
        const double t = injective_limit(deformation, 100.0);
        EXPECT_GT(t, 0.0) << name;
        Deformation proven = deformation;
        for (Vec3& d : displacements_of(proven)) d *= t;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 x = kHandle + random.uniform(0.0, 1.0) * random.direction();
            EXPECT_GT(glm::determinant(jacobian(proven, x)), 0.0) << name;
        }
    }
}

}  // namespace
}  // namespace pectin
