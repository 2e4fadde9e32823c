// Direct manipulation: drags met exactly, by the smallest displacement of the lattice.
#include "ffd/drag_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "ffd/basis.h"
#include "ffd/lattice_field.h"

namespace pectin {
namespace {

class Random {
  public:
    explicit Random(unsigned seed) : generator_{seed} {}

    double between(double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(generator_);
    }
    Vec3 vector(double least, double most) {
        const double x = between(least, most), y = between(least, most);
        return {x, y, between(least, most)};
    }
    int count(int least, int most) {
        return std::uniform_int_distribution<int>{least, most}(generator_);
    }
    Lattice lattice(const Vec3& about) {
        const Vec3 origin = about + vector(-5.0, 5.0);
        const Vec3 cell = vector(0.2, 3.0);
        const int l = count(4, 7), m = count(4, 7);
        return {.origin = origin, .cell = cell, .deformable = {l, m, count(4, 7)}};
    }
    // Within `margin` cells of the influenced zone's border.
    Vec3 point_in(const Lattice& lattice, double margin) {
        const Vec3 reach = Vec3{lattice.deformable} + 3.0 - 2.0 * margin;
        return lattice.origin + (margin - 2.0 + vector(0.0, 1.0) * reach) * lattice.cell;
    }
    // Points at least a cell from each other and from the zone's border.
    void add_points(const Lattice& lattice, int more, std::vector<Vec3>& points) {
        const std::size_t wanted = points.size() + static_cast<std::size_t>(more);
        while (points.size() < wanted) {
            const Vec3 point = point_in(lattice, 1.2);
            bool apart = true;
            for (const Vec3& other : points) {
                apart = apart && glm::length((point - other) / lattice.cell) > 1.0;
            }
            if (apart) points.push_back(point);
        }
    }
    std::vector<Vec3> vectors(std::size_t number) {
        std::vector<Vec3> all(number);
        for (Vec3& one : all) one = vector(-1.0, 1.0);
        return all;
    }

  private:
    std::mt19937 generator_;
};

// A drag of 1 to 4 points that holds up to 6 others.
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

Case random_case(Random& random, const Vec3& about = Vec3{0.0}) {
    const Lattice lattice = random.lattice(about);
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

// Basis values of all control points at x: a row of the constraint matrix.
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

std::string refusal(const Lattice& lattice, const std::vector<Vec3>& moves,
                    const std::vector<Vec3>& pins = {}) {
    const auto solver = DragSolver::create(lattice, moves, pins);
    const auto* refused = std::get_if<DragRefusal>(&solver);
    return refused ? refused->what : "";
}

DragSolver solver_of(const Lattice& lattice, const std::vector<Vec3>& moves,
                     const std::vector<Vec3>& pins = {}) {
    return std::get<DragSolver>(DragSolver::create(lattice, moves, pins));
}

const Lattice kCube{.origin = {0, 0, 0}, .cell = {1, 1, 1}, .deformable = {4, 4, 4}};

TEST(Drag, TakesEveryPointExactlyWhereItIsDragged) {
    Random random{11};
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
    Random random{12};
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
    Random random{13};
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

TEST(Drag, MovesTheLatticeAsLittleAsTheDragsAllow) {
    Random random{14};
    SCOPED_TRACE("seed 14");
    for (int trial = 0; trial < 100; ++trial) {
        const Case drag = random_case(random);
        const std::vector<Vec3> least = drag.solver.control_displacements(drag.d);
        std::vector<Vec3> points = drag.moves;
        points.insert(points.end(), drag.pins.begin(), drag.pins.end());

        // Any other solution differs by something that every constraint's row maps to zero; made
        // here by Gram–Schmidt, twice for accuracy. The smallest solution is perpendicular to it.
        std::vector<Vec3> other = random.vectors(least.size());
        std::vector<std::vector<double>> rows;
        for (const Vec3& point : points) rows.push_back(row_at(drag.lattice, point));
        for (std::size_t pass = 0, k = 0; pass < 2 * rows.size(); k = ++pass % rows.size()) {
            for (std::size_t before = 0; before <= k; ++before) {
                double squared = 0.0;
                double along = 0.0;
                for (std::size_t i = 0; i < least.size(); ++i) {
                    squared += rows[before][i] * rows[before][i];
                    along += rows[before][i] * rows[k][i];
                }
                for (std::size_t i = 0; i < least.size() && before < k; ++i) {
                    rows[k][i] -= along / squared * rows[before][i];
                }
            }
        }
        for (const std::vector<double>& row : rows) {
            double squared = 0.0;
            Vec3 along{0.0};
            for (std::size_t i = 0; i < least.size(); ++i) {
                squared += row[i] * row[i];
                along += row[i] * other[i];
            }
            for (std::size_t i = 0; i < least.size(); ++i) other[i] -= row[i] / squared * along;
        }
        const LatticeField null_space{drag.lattice, other};
        for (const Vec3& point : points) {
            ASSERT_LT(glm::length(null_space.displacement(point)), 1e-10 * norm(other));
        }
        Mat3 products{0.0};
        std::vector<Vec3> sum = least;
        for (std::size_t i = 0; i < least.size(); ++i) {
            products += glm::outerProduct(least[i], other[i]);
            sum[i] += other[i];
        }
        for (int column = 0; column < 3; ++column) {
            EXPECT_LT(glm::length(products[column]), 1e-10 * norm(least) * norm(other));
        }
        EXPECT_GT(norm(sum), norm(least));
    }
}

TEST(DragField, EqualsTheDisplacedLatticeEverywhere) {
    Random random{15};
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
    Random random{16};
    SCOPED_TRACE("seed 16");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const Box zone = drag.lattice.influenced_zone();
        Vec3 x = random.point_in(drag.lattice, 0.0);
        const int axis = trial % 3;
        const double beyond = trial % 2 == 0 ? 0.0 : random.between(0.0, 1e9);
        x[axis] = trial % 4 < 2 ? zone.min[axis] - beyond : zone.max[axis] + beyond;
        for (const DragWeight& weight : drag.weights(x)) {
            EXPECT_EQ(weight.w, 0.0f);
            EXPECT_EQ(weight.gradient, Vec3f(0.0f));
        }
        EXPECT_EQ(displaced(x, drag.weights(x), drag.d), x);
    }
}

TEST(DragField, GradientMatchesCentralDifferencesWithUnequalCells) {
    Random random{17};
    SCOPED_TRACE("seed 17");
    const Lattice lattice{.origin = {1, 2, 3}, .cell = {0.5, 1.0, 4.0}, .deformable = {3, 4, 5}};
    const DragSolver solver = solver_of(lattice, {{1.6, 3.3, 9.0}, {2.0, 5.1, 16.0}}, {{1, 2, 3}});
    // Through the control points, in double: weights themselves are rounded to float.
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

TEST(DragField, IsTheSameInABatchToTheBit) {
    Random random{18};
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

TEST(DragField, SumsMoreMovesThanItTakesAtATime) {
    Random random{19};
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
    Random random{20};
    SCOPED_TRACE("seed 20");
    for (int trial = 0; trial < 300; ++trial) {
        const Case drag = random_case(random);
        const auto weights = drag.weights(random.point_in(drag.lattice, 0.5));
        EXPECT_NEAR(jacobian_determinant(weights, drag.d),
                    glm::determinant(jacobian(weights, drag.d)), 1e-12);
    }
}

// The normal of the deformed surface is the cross product of its deformed tangents, here those of
// a tiny triangle carried through the displaced lattice itself.
TEST(FrameKernel, NormalsFollowATinyDeformedTriangle) {
    Random random{21};
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
    Random random{22};
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

TEST(FrameKernel, LeavesNormalsAloneToTheBitWhereNothingBends) {
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
}

TEST(DragSolver, RefusesADragOfNothing) {
    EXPECT_NE(refusal(kCube, {}, {{1, 1, 1}}).find("at least one point"), std::string::npos);
}

TEST(DragSolver, RefusesALatticeWithoutSpace) {
    EXPECT_NE(refusal({.cell = {1, 0, 1}}, {{0, 0, 0}}).find("greater than 0"), std::string::npos);
    EXPECT_NE(refusal({.deformable = {0, 1, 1}}, {{0, 0, 0}}).find("1 to 256"), std::string::npos);
}

TEST(DragSolver, RefusesAMoveOutsideTheZoneOrOnItsBorderAndNamesBoth) {
    for (const Vec3& point : {Vec3{-2, 1, 1}, Vec3{1, 5, 1}, Vec3{1, 1, 7.25}}) {
        const std::string what = refusal(kCube, {{1, 1, 1}, point});
        EXPECT_NE(what.find("influenced zone (-2, -2, -2) to (5, 5, 5)"), std::string::npos);
    }
    EXPECT_NE(refusal(kCube, {{1, 1, 7.25}}).find("(1, 1, 7.25)"), std::string::npos);
    EXPECT_FALSE(refusal(kCube, {Vec3{std::nan(""), 0, 0}}).empty());
}

TEST(DragSolver, RefusesAMoveTooCloseToTheBorder) {
    EXPECT_NE(refusal(kCube, {{1, 1, -1.9}}).find("too close to the border"), std::string::npos);
    EXPECT_NE(refusal(kCube, {Vec3{-2.0 + 1e-9}}).find("too close"), std::string::npos);
    EXPECT_EQ(refusal(kCube, {{1, 1, -1.5}}), "");
    // A lattice whose border is the origin: the nearest number inside it has no basis value left.
    const Lattice touching{.origin = {2, 2, 2}, .cell = {1, 1, 1}, .deformable = {2, 2, 2}};
    EXPECT_NE(refusal(touching, {{2, 2, 1e-300}}).find("too close"), std::string::npos);
}

TEST(DragSolver, NeverThrowsControlPointsFartherThanItsLimit) {
    for (double inside = 0.01; inside < 1.0; inside += 0.01) {
        const Vec3 point{-2.0 + inside, 1.3, 1.4};
        const auto solver = DragSolver::create(kCube, {&point, 1}, {});
        if (!std::holds_alternative<DragSolver>(solver)) continue;
        const std::array<Vec3, 1> d{Vec3{1, 0, 0}};
        for (const Vec3& p : std::get<DragSolver>(solver).control_displacements(d)) {
            EXPECT_LE(glm::length(p), kMaxControlGain * (1.0 + 1e-12));
        }
    }
}

TEST(DragSolver, RefusesPointsTooCloseToTellApartAndNamesThem) {
    const std::string what = refusal(kCube, {{1, 1, 1}, {3, 2, 1}}, {{1, 1, 1.000001}});
    EXPECT_NE(what.find("(1, 1, 1) and (1, 1, 1.000001)"), std::string::npos) << what;
    EXPECT_EQ(refusal(kCube, {{1, 1, 1}}, {{1, 1, 1.01}}), "");
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, {{1, 2, 3}, {1, 2, 3.000001}}), "");
}

TEST(DragSolver, MeetsItsDragAtTheClosestPointsItAccepts) {
    const Vec3 move{1, 1, 1};
    int accepted = 0;
    for (double apart = 1e-6; apart < 0.1; apart *= 1.1) {
        const Vec3 pin{1, 1, 1 + apart};
        const auto solver = DragSolver::create(kCube, {&move, 1}, {&pin, 1});
        if (!std::holds_alternative<DragSolver>(solver)) continue;
        ++accepted;
        DragWeight at_move, at_pin;
        std::get<DragSolver>(solver).field().weights(move, {&at_move, 1});
        std::get<DragSolver>(solver).field().weights(pin, {&at_pin, 1});
        EXPECT_NEAR(at_move.w, 1.0f, 1e-6f) << apart;
        EXPECT_NEAR(at_pin.w, 0.0f, 1e-6f) << apart;
    }
    EXPECT_GT(accepted, 40);
}

TEST(DragSolver, RefusesMoreConstraintsThanControlPoints) {
    const Lattice single{.deformable = {1, 1, 1}};
    const std::string what = refusal(single, {{0, 0, 0}}, {{0.5, 0, 0}});
    EXPECT_NE(what.find("2 moves and pins are more than the 1 control points"), std::string::npos);
    Random random{23};
    SCOPED_TRACE("seed 23");
    std::vector<Vec3> many;
    for (std::size_t i = 0; i <= kMaxConstraints; ++i) many.push_back(random.vector(-1, 4));
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, many).find("at most 1024"), std::string::npos);
}

TEST(DragSolver, IgnoresPinsThatAreHeldAnyway) {
    const std::vector<Vec3> outside{{9, 9, 9}, {-2, 1, 1}, {1, 1, 5}};
    const DragSolver with = solver_of(kCube, {{1, 1, 1}}, outside);
    const DragSolver without = solver_of(kCube, {{1, 1, 1}});
    const std::array<Vec3, 1> d{Vec3{1, 2, 3}};
    EXPECT_EQ(with.control_displacements(d), without.control_displacements(d));
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, {Vec3{0, INFINITY, 0}}).find("inf"), std::string::npos);
}

TEST(DragSolver, HoldsPinsNearTheBorderAsWellAsAnyOther) {
    const Vec3 pin{-1.9999, -1.9999, -1.9999};
    const DragSolver solver = solver_of(kCube, {{0, 0, 0}}, {pin});
    DragWeight weight;
    solver.field().weights(pin, {&weight, 1});
    EXPECT_NEAR(weight.w, 0.0f, 1e-15f);
    solver.field().weights({0, 0, 0}, {&weight, 1});
    EXPECT_EQ(weight.w, 1.0f);
}

TEST(DragSolver, CountsPinsAtOnePlaceOnce) {
    const DragSolver twice = solver_of(kCube, {{1, 1, 1}}, {{3, 1, 1}, {3, 1, 1}});
    const DragSolver once = solver_of(kCube, {{1, 1, 1}}, {{3, 1, 1}});
    const std::array<Vec3, 1> d{Vec3{1, 2, 3}};
    EXPECT_EQ(twice.control_displacements(d), once.control_displacements(d));
}

TEST(DragSolver, CountsMovesAtOnePlaceOnceIfTheyAgree) {
    const DragSolver solver = solver_of(kCube, {{1, 1, 1}, {3, 2, 1}, {1, 1, 1}});
    const Vec3 d{0.1, 0.2, 0.3};
    EXPECT_EQ(solver.check(std::vector<Vec3>{d, {1, 0, 0}, d}), std::nullopt);
    std::array<DragWeight, 3> weights;
    solver.field().weights({1, 1, 1}, weights);
    EXPECT_EQ(weights[0].w, 1.0f);
    EXPECT_EQ(weights[2].w, 0.0f);
    EXPECT_EQ(weights[2].gradient, Vec3f(0.0f));

    const auto refused = solver.check(std::vector<Vec3>{d, d, {0.1, 0.2, 0.4}});
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->what.find("(1, 1, 1)"), std::string::npos);
    EXPECT_NE(refused->what.find("by (0.1, 0.2, 0.3) and by (0.1, 0.2, 0.4)"), std::string::npos);
}

TEST(DragSolver, RefusesToMoveAPinnedPointButLetsItRest) {
    const DragSolver solver = solver_of(kCube, {{1, 1, 1}, {3, 2, 1}}, {{1, 1, 1}});
    EXPECT_EQ(solver.check(std::vector<Vec3>{Vec3{0.0}, {1, 0, 0}}), std::nullopt);
    const auto refused = solver.check(std::vector<Vec3>{{0, 0, 1e-9}, {1, 0, 0}});
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->what.find("(1, 1, 1) is pinned"), std::string::npos);
}

TEST(DragSolver, RefusesDisplacementsThatAreNotFinite) {
    const DragSolver solver = solver_of(kCube, {{1, 1, 1}});
    for (const double bad : {INFINITY, -INFINITY, NAN}) {
        EXPECT_TRUE(solver.check(std::vector<Vec3>{{0, bad, 0}}));
    }
    EXPECT_FALSE(solver.check(std::vector<Vec3>{{0, 1e9, 0}}));
}

}  // namespace
}  // namespace pectin
