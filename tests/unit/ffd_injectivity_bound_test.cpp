// The limits of the injectivity proof for each box, compared with the gradient sampled densely. An
// error in the bound would allow some box too much.
// Source: J. Gain, N. Dodgson. Preventing Self-Intersection under Free-Form Deformation. IEEE
// Transactions on Visualization and Computer Graphics 7(4), 2001.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "ffd/injectivity.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

// The least eigenvalue of the symmetric part of the sum's gradient, by the trigonometric solution
// of its characteristic equation (O. K. Smith, Eigenvalues of a symmetric 3 × 3 matrix,
// Communications of the ACM 4(4), 1961).
double least_eigenvalue(const std::vector<LatticeField>& sum, const Vec3& x) {
    Mat3 gradient{0.0};
    for (const LatticeField& field : sum) gradient += field.jacobian(x) - Mat3{1.0};
    const Mat3 symmetric = 0.5 * (gradient + glm::transpose(gradient));
    const double mean = (symmetric[0][0] + symmetric[1][1] + symmetric[2][2]) / 3.0;
    const Mat3 rest = symmetric - Mat3{mean};
    double squared = 0.0;
    for (int i = 0; i < 3; ++i) squared += glm::dot(rest[i], rest[i]);
    const double radius = std::sqrt(squared / 6.0);
    if (!(radius > 0.0)) return mean;
    const double half = 0.5 * glm::determinant((1.0 / radius) * rest);
    const double angle = std::acos(std::clamp(half, -1.0, 1.0)) / 3.0;
    return mean + 2.0 * radius * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
}

// The least value over a grid of points of the box that includes its corners.
double least_sampled(const std::vector<LatticeField>& sum, const Box& box, int per_side) {
    double least = 0.0;
    for (int i = 0; i <= per_side; ++i) {
        for (int j = 0; j <= per_side; ++j) {
            for (int k = 0; k <= per_side; ++k) {
                const Vec3 fraction = Vec3(i, j, k) / static_cast<double>(per_side);
                least = std::min(least, least_eigenvalue(sum, box.min + fraction * box.extent()));
            }
        }
    }
    return least;
}

std::vector<LatticeField> random_sum(LatticeRandom& random, int fields) {
    std::vector<LatticeField> sum;
    for (int f = 0; f < fields; ++f) {
        Lattice lattice = random.lattice(Vec3{0.0}, 2, 3);
        if (f > 0) {  // like a mirror image of the first one, with other knots
            lattice = sum.front().lattice();
            lattice.origin.x += 0.3 * lattice.cell.x;
        }
        std::vector<Vec3> displacements = random.vectors(lattice.control_count());
        sum.emplace_back(lattice, std::move(displacements));
    }
    return sum;
}

TEST(SymmetricPartBound, AllowsNoBoxMoreThanItsSampledGradientDoes) {
    constexpr unsigned kSeed = 91;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    std::size_t boxes = 0, tight = 0;
    double worst = 0.0;
    for (int trial = 0; trial < 12; ++trial) {
        const std::vector<LatticeField> sum = random_sum(random, trial % 3 == 2 ? 2 : 1);
        constexpr double kFar = 1e6;  // far beyond the limit of any box that has one
        for (const auto& [box, limit] : injective_limits_of_boxes(sum, kFar)) {
            const double steepest = -least_sampled(sum, box, 6);
            if (!(steepest > 1e-3)) continue;  // the limit is too large to compare
            ++boxes;
            // 1 + limit · (least eigenvalue) ≥ kLeastStretch at every point of the box.
            const double used = limit * steepest / (1.0 - kLeastStretch);
            worst = std::max(worst, used);
            if (used > 0.99) ++tight;
            ASSERT_LE(used, 1.0 + 1e-6) << "trial " << trial;
        }
    }
    // The bound is exact if the least value is at a corner of the box, so an error would show.
    EXPECT_GT(boxes, 1000u);
    EXPECT_GT(tight, boxes / 10);
    EXPECT_GT(worst, 1.0 - 1e-6);
    std::printf("%zu boxes, %zu of them tight\n", boxes, tight);
}

TEST(SymmetricPartBound, OverAllBoxesEqualsThatOfTheWhole) {
    constexpr unsigned kSeed = 92;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    for (int trial = 0; trial < 20; ++trial) {
        const std::vector<LatticeField> sum = random_sum(random, 1 + trial % 2);
        double least = 100.0;
        for (const auto& [box, limit] : injective_limits_of_boxes(sum, 100.0)) {
            least = std::min(least, limit);
        }
        // A box that allows enough is not divided, so the whole limit may be a little lower.
        EXPECT_LE(injective_limit(sum, 100.0), least * (1.0 + 1e-9));
        EXPECT_GE(injective_limit(sum, 100.0), least * 0.9);
    }
}

}  // namespace
}  // namespace pectin
