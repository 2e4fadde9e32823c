// Direct manipulation: a drag is met exactly, by the smallest displacement of the lattice.
#include "ffd/drag_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "ffd/cubic_basis.h"
#include "ffd/lattice_field.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

// A random drag of 1 to 4 handles with up to 6 pins.
struct Case {
    Lattice lattice;
    std::vector<Vec3> moves, pins, d;
    DragSolver solver;

    const DragField& field() const { return solver.field(); }
    std::vector<DragWeight> weights(const Vec3& x) const {
        std::vector<DragWeight> all(moves.size());
        field().weights(x, all);
        return all;
    }
};

Case random_case(LatticeRandom& random, const Vec3& about = Vec3{0.0}) {
    const Lattice lattice = random.lattice(about, 4, 7);
    const int moves = random.count(1, 4);
    std::vector<Vec3> points;
    random.add_points(lattice, moves + random.count(0, 6), points);
    const std::vector<Vec3> pins(points.begin() + moves, points.end());
    points.resize(static_cast<std::size_t>(moves));
    auto solver = DragSolver::create(lattice, points, pins);
    if (const auto* refusal = std::get_if<DragRefusal>(&solver)) ADD_FAILURE() << refusal->what;
    return {lattice, points, pins, random.vectors(points.size()),
            std::get<DragSolver>(std::move(solver))};
}

double norm(std::span<const Vec3> vectors) {
    double squared = 0.0;
    for (const Vec3& one : vectors) squared += glm::dot(one, one);
    return std::sqrt(squared);
}

// The basis values of all control points at x, which are a row of the constraint matrix.
std::vector<double> row_at(const Lattice& lattice, const Vec3& x) {
    std::vector<double> row;
    const Vec3 u = lattice.parameter(x);
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                row.push_back(basis(u.x - i) * basis(u.y - j) * basis(u.z - k));
            }
        }
    }
    return row;
}

DragSolver solver_of(const Lattice& lattice, const std::vector<Vec3>& moves,
                     const std::vector<Vec3>& pins = {}) {
    return std::get<DragSolver>(DragSolver::create(lattice, moves, pins));
}

const Lattice kCube{.origin = {0, 0, 0}, .cell = {1, 1, 1}, .deformable = {4, 4, 4}};

TEST(Drag, StaysWithinItsReachAndLipschitzBounds) {
    LatticeRandom random{31};
    SCOPED_TRACE("seed 31");
    double tightest = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
        const Case drag = random_case(random);
        const double reach = drag.field().reach_bound(drag.d);
        const double stretch = drag.field().lipschitz_bound(drag.d);
        for (int i = 0; i < 100; ++i) {
            const Vec3 x = random.point_in(drag.lattice, 0.0);
            const Vec3 y = x + 0.01 * drag.lattice.smallest_cell_extent() * random.vectors(1)[0];
            const auto at = [&](const Vec3& p) { return displaced(p, drag.weights(p), drag.d); };
            const double longer = glm::distance(at(x), at(y)) / glm::distance(x, y);
            // The second term allows for the rounding of w to float.
            ASSERT_LE(longer, stretch + 1e-6 * (1.0 + reach) / glm::distance(x, y));
            ASSERT_LE(glm::distance(at(x), x), reach * (1.0 + 1e-6));
            tightest = std::max(tightest, longer / stretch);
        }
    }
    EXPECT_GT(tightest, 0.3) << "the bound is never nearly reached";
}

TEST(Drag, TakesEveryPointExactlyWhereItIsDragged) {
    LatticeRandom random{11};
    SCOPED_TRACE("seed 11");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const LatticeField exact{drag.lattice, drag.solver.control_displacements(drag.d)};
        const double size = norm(drag.d);
        for (std::size_t m = 0; m < drag.moves.size(); ++m) {
            const Vec3 target = drag.moves[m] + drag.d[m];
            const Vec3 reached = displaced(drag.moves[m], drag.weights(drag.moves[m]), drag.d);
            EXPECT_LT(glm::length(reached - target), 1e-6 * glm::length(drag.d[m]));
            EXPECT_LT(glm::length(exact.displacement(drag.moves[m]) - drag.d[m]), 1e-12 * size);
        }
    }
}

TEST(Drag, HoldsEveryPin) {
    LatticeRandom random{12};
    SCOPED_TRACE("seed 12");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const LatticeField exact{drag.lattice, drag.solver.control_displacements(drag.d)};
        for (const Vec3& pin : drag.pins) {
            EXPECT_LT(glm::length(displaced(pin, drag.weights(pin), drag.d) - pin),
                      1e-12 * (norm(drag.d) + glm::length(pin)));
            EXPECT_LT(glm::length(exact.displacement(pin)), 1e-12 * norm(drag.d));
        }
    }
}

TEST(Drag, WorksAMillionUnitsFromTheOrigin) {
    LatticeRandom random{13};
    SCOPED_TRACE("seed 13");
    for (int trial = 0; trial < 100; ++trial) {
        const Case drag = random_case(random, Vec3{1e6, -1e6, 1e6});
        for (std::size_t m = 0; m < drag.moves.size(); ++m) {
            const Vec3 target = drag.moves[m] + drag.d[m];
            const Vec3 reached = displaced(drag.moves[m], drag.weights(drag.moves[m]), drag.d);
            EXPECT_LT(glm::length(reached - target), 1e-6 * glm::length(drag.d[m]));
        }
        const Box zone = drag.lattice.influenced_zone();
        EXPECT_EQ(drag.weights(zone.max)[0].w, 0.0f);
        EXPECT_EQ(drag.weights(zone.min)[0].gradient, Vec3f(0.0f));
    }
}

double dot(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// An orthogonal basis of the rows of the constraints, by Gram–Schmidt applied twice for accuracy.
std::vector<std::vector<double>> orthogonal_rows(const Lattice& lattice,
                                                 const std::vector<Vec3>& points) {
    std::vector<std::vector<double>> rows;
    for (const Vec3& point : points) {
        std::vector<double> row = row_at(lattice, point);
        for (int pass = 0; pass < 2; ++pass) {
            for (const std::vector<double>& other : rows) {
                const double fraction = dot(row, other) / dot(other, other);
                for (std::size_t i = 0; i < row.size(); ++i) row[i] -= fraction * other[i];
            }
        }
        rows.push_back(row);
    }
    return rows;
}

// The component of `controls` that is orthogonal to all rows.
std::vector<Vec3> null_part(std::vector<Vec3> controls,
                            const std::vector<std::vector<double>>& rows) {
    for (const std::vector<double>& row : rows) {
        Vec3 along{0.0};
        for (std::size_t i = 0; i < row.size(); ++i) along += row[i] * controls[i];
        along /= dot(row, row);
        for (std::size_t i = 0; i < row.size(); ++i) controls[i] -= row[i] * along;
    }
    return controls;
}

// Any two solutions differ by a vector that every constraint maps to zero. The smallest solution
// has no such component, so it lies in the space of the rows.
TEST(Drag, MovesTheLatticeAsLittleAsTheDragsAllow) {
    LatticeRandom random{14};
    SCOPED_TRACE("seed 14");
    for (int trial = 0; trial < 100; ++trial) {
        const Case drag = random_case(random);
        std::vector<Vec3> points = drag.moves;
        points.insert(points.end(), drag.pins.begin(), drag.pins.end());
        const auto rows = orthogonal_rows(drag.lattice, points);
        const std::vector<Vec3> least = drag.solver.control_displacements(drag.d);
        EXPECT_LT(norm(null_part(least, rows)), 1e-11 * norm(least));

        std::vector<Vec3> other = null_part(random.vectors(least.size()), rows);
        for (std::size_t i = 0; i < other.size(); ++i) other[i] += least[i];
        const LatticeField field{drag.lattice, other};
        for (std::size_t p = 0; p < points.size(); ++p) {
            const Vec3 asked = p < drag.d.size() ? drag.d[p] : Vec3{0.0};
            EXPECT_LT(glm::length(field.displacement(points[p]) - asked), 1e-11 * norm(other));
        }
        EXPECT_GT(norm(other), norm(least));
    }
}

TEST(DragField, EqualsTheDisplacedLatticeEverywhere) {
    LatticeRandom random{15};
    SCOPED_TRACE("seed 15");
    for (int trial = 0; trial < 100; ++trial) {
        const Case drag = random_case(random);
        const LatticeField exact{drag.lattice, drag.solver.control_displacements(drag.d)};
        for (int sample = 0; sample < 50; ++sample) {
            const Vec3 x = random.point_in(drag.lattice, -0.5);
            const auto weights = drag.weights(x);
            const double size = norm(drag.d);
            EXPECT_LT(glm::length(displaced(x, weights, drag.d) - x - exact.displacement(x)),
                      1e-6 * size);
            const Mat3 difference = jacobian(weights, drag.d) - exact.jacobian(x);
            for (int column = 0; column < 3; ++column) {
                EXPECT_LT(glm::length(difference[column]),
                          1e-6 * size / drag.lattice.smallest_cell_extent());
            }
        }
    }
}

TEST(DragField, IsExactlyZeroOnTheBorderOfTheZoneAndOutside) {
    LatticeRandom random{16};
    SCOPED_TRACE("seed 16");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const Vec3 x = random.point_outside(drag.lattice, 1e9);
        for (const DragWeight& weight : drag.weights(x)) {
            EXPECT_EQ(weight.w, 0.0f);
            EXPECT_EQ(weight.gradient, Vec3f(0.0f));
        }
        EXPECT_EQ(displaced(x, drag.weights(x), drag.d), x);
    }
}

TEST(DragField, GradientMatchesCentralDifferencesWithUnequalCells) {
    LatticeRandom random{17};
    SCOPED_TRACE("seed 17");
    const Lattice lattice{.origin = {1, 2, 3}, .cell = {0.5, 1.0, 4.0}, .deformable = {3, 4, 5}};
    const DragSolver solver = solver_of(lattice, {{1.6, 3.3, 9.0}, {2.0, 5.1, 16.0}}, {{1, 2, 3}});
    // The difference uses the control points in double, since weights are rounded to float.
    for (std::size_t m = 0; m < 2; ++m) {
        std::vector<Vec3> d(2, Vec3{0.0});
        d[m] = {1, 0, 0};
        const LatticeField exact{lattice, solver.control_displacements(d)};
        for (int sample = 0; sample < 300; ++sample) {
            const Vec3 x = random.point_in(lattice, -0.1);
            std::array<DragWeight, 2> weights;
            solver.field().weights(x, weights);
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 step{0.0};
                step[axis] = 1e-5 * lattice.cell[axis];
                const double difference =
                    (exact.displacement(x + step).x - exact.displacement(x - step).x) /
                    (2.0 * step[axis]);
                EXPECT_NEAR(static_cast<double>(weights[m].gradient[axis]), difference,
                            2e-6 / lattice.cell[axis]);
            }
        }
    }
}

TEST(DragField, GivesTheSameBitsInABatch) {
    LatticeRandom random{18};
    SCOPED_TRACE("seed 18");
    for (int trial = 0; trial < 50; ++trial) {
        const Case drag = random_case(random);
        std::vector<Vec3> points;
        for (int sample = 0; sample < 40; ++sample) {
            points.push_back(random.point_in(drag.lattice, -0.2));
        }
        std::vector<DragWeight> batch(points.size() * drag.moves.size());
        drag.field().weights(points, batch);
        for (std::size_t p = 0; p < points.size(); ++p) {
            const auto single = drag.weights(points[p]);
            EXPECT_EQ(std::memcmp(single.data(), &batch[p * single.size()],
                                  single.size() * sizeof(DragWeight)),
                      0);
        }
    }
}

TEST(DragField, SumsMoreWeightsThanOneBatch) {
    LatticeRandom random{19};
    SCOPED_TRACE("seed 19");
    const Lattice lattice{.cell = {1, 2, 3}, .deformable = {9, 9, 9}};
    std::vector<Vec3> moves;
    random.add_points(lattice, 21, moves);
    const DragSolver solver = solver_of(lattice, moves);
    std::vector<DragWeight> weights(21);
    for (std::size_t at = 0; at < moves.size(); ++at) {
        solver.field().weights(moves[at], weights);
        for (std::size_t m = 0; m < moves.size(); ++m) {
            EXPECT_NEAR(weights[m].w, m == at ? 1.0f : 0.0f, 1e-7f);
        }
    }
}

TEST(DragField, HasTwoContinuousDerivativesAcrossTheBorderOfTheZone) {
    const DragSolver solver = solver_of(kCube, {{1.2, 1.3, 1.4}});
    const double h = 0x1p-6;
    const auto w = [&](double inside) {
        DragWeight weight;
        solver.field().weights({-2.0 + inside, 1, 1}, {&weight, 1});
        return static_cast<double>(weight.w);
    };
    EXPECT_EQ(w(0.0), 0.0);
    EXPECT_LT(std::abs(w(h)) / h, h * h);
    EXPECT_LT(std::abs(w(2.0 * h) - 2.0 * w(h)) / (h * h), 2.0 * h);
}

TEST(FrameKernel, DeterminantMatchesTheJacobian) {
    LatticeRandom random{20};
    SCOPED_TRACE("seed 20");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const auto weights = drag.weights(random.point_in(drag.lattice, 0.5));
        EXPECT_NEAR(jacobian_determinant(weights, drag.d),
                    glm::determinant(jacobian(weights, drag.d)), 1e-12);
    }
}

// The normal of a deformed surface is the cross product of its deformed tangents. Here these are
// the sides of a tiny triangle that the displaced lattice deforms.
TEST(FrameKernel, NormalsFollowATinyDeformedTriangle) {
    LatticeRandom random{21};
    SCOPED_TRACE("seed 21");
    int compared = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const LatticeField exact{drag.lattice, drag.solver.control_displacements(drag.d)};
        const Vec3 x = random.point_in(drag.lattice, 0.1);
        const Vec3 s = glm::normalize(random.vector(-1, 1));
        const Vec3 t = glm::normalize(random.vector(-1, 1));
        const double h = 1e-5;
        const auto carried = [&](const Vec3& along) {
            return 2.0 * h * along + exact.displacement(x + h * along) -
                   exact.displacement(x - h * along);
        };
        const Vec3 expected = glm::cross(carried(s), carried(t)) / (4.0 * h * h);
        if (glm::length(glm::cross(s, t)) < 0.3 || glm::length(expected) < 0.1) continue;
        const Vec3f n{glm::normalize(glm::cross(s, t))};
        const Vec3 normal{covariant_normal(n, drag.weights(x), drag.d)};
        EXPECT_LT(glm::length(normal - glm::normalize(expected)), 2e-5);
        EXPECT_LT(glm::length(normal - Vec3{covariant(exact.jacobian(x), n)}), 2e-5);
        ++compared;
    }
    EXPECT_GT(compared, 150);
}

TEST(FrameKernel, SeveralDragsAgreeWithOneWhereTheOthersAreZero) {
    LatticeRandom random{22};
    SCOPED_TRACE("seed 22");
    for (int trial = 0; trial < 200; ++trial) {
        const DragWeight one{static_cast<float>(random.between(0, 1)), Vec3f{random.vector(-1, 1)}};
        const std::array<DragWeight, 2> weights{one, DragWeight{0.3f, {0.1f, 0.2f, 0.3f}}};
        const std::array<Vec3, 2> d{random.vector(-0.5, 0.5), Vec3{0.0}};
        const Vec3 x = random.vector(-1, 1);
        const Vec3f n{glm::normalize(random.vector(-1, 1))};
        EXPECT_LT(glm::length(displaced(x, weights, d) - displaced(x, one, d[0])), 1e-15);
        EXPECT_LT(glm::length(covariant_normal(n, weights, d) - covariant_normal(n, one, d[0])),
                  1e-6f);
        EXPECT_NEAR(jacobian_determinant(weights, d), jacobian_determinant(one, d[0]), 1e-14);
    }
}

TEST(FrameKernel, KeepsNormalsBitForBitWhereTheGradientIsZero) {
    const Vec3f unnormalised{0.3f, -0.0f, 7.0f};
    const auto same = [&](const Vec3f& n) { return std::memcmp(&n, &unnormalised, 12) == 0; };
    const DragWeight flat{1.0f, Vec3f{0.0f}};
    const DragWeight bent{0.5f, {-1.0f, -2.0f, 3.0f}};
    const std::array<DragWeight, 2> flats{flat, flat}, bents{bent, bent};
    const std::array<Vec3, 2> drags{Vec3{1, 2, 3}, Vec3{4, 5, 6}}, none{};
    EXPECT_TRUE(same(covariant_normal(unnormalised, flat, drags[0])));
    EXPECT_TRUE(same(covariant_normal(unnormalised, bent, Vec3{0.0})));
    EXPECT_TRUE(same(covariant_normal(unnormalised, flats, drags)));
    EXPECT_TRUE(same(covariant_normal(unnormalised, bents, none)));
    EXPECT_EQ(displaced({0.1, 0.2, 0.3}, bents, none), Vec3(0.1, 0.2, 0.3));
}

TEST(FrameKernel, GivesZeroForANormalWithoutADirection) {
    const DragWeight weight{0.5f, {1.0f, 0.0f, 0.0f}};
    EXPECT_EQ(covariant_normal(Vec3f{0.0f}, weight, Vec3{1, 2, 3}), Vec3f(0.0f));
    EXPECT_EQ(covariant_normal({0, 1, 0}, weight, Vec3{-1, 0, 0}), Vec3f(0.0f));
    EXPECT_EQ(covariant_normal({0, 1, 0}, weight, Vec3{1e300, 1e300, 0}), Vec3f(0.0f));
    const DragWeight steep{0.5f, Vec3f{100.0f}};  // 1 + ∇w·d overflows
    EXPECT_EQ(covariant_normal({0.001f, 0.7f, 0.7f}, steep, Vec3{1e308, 0, 0}), Vec3f(0.0f));
}

}  // namespace
}  // namespace pectin
