// The 4 x 4 x 4 sum at many points: its values, and that they depend on nothing but the point.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "ffd/cofactor.h"
#include "ffd/lattice_evaluator.h"
#include "ffd_random.h"
#include "ffd_vectors.h"

namespace pectin {
namespace {

template <typename T>
bool same(const T& x, const T& y) {
    return std::memcmp(&x, &y, sizeof(T)) == 0;
}

struct Result {
    std::vector<Vec3> displaced, transformed;
    std::vector<Vec3f> to_normals;
};

Result result_at(const LatticeEvaluator& evaluator, std::span<const Vec3> points,
                 std::span<const Vec3f> normals) {
    const std::size_t count = points.size();
    Result result{std::vector<Vec3>(count), std::vector<Vec3>(count), std::vector<Vec3f>(count)};
    evaluator.displace(points, result.displaced);
    evaluator.transform(points, normals, result.transformed, result.to_normals);
    return result;
}

// A random lattice, near the origin or far from it, and points in and around its zone.
struct Scene {
    explicit Scene(LatticeRandom& random)
        : lattice(
              random.lattice(random.vector(-1.0, 1.0) * (random.count(0, 1) ? 1e6 : 1.0), 1, 6)),
          field(lattice, random.vectors(lattice.control_count())) {
        const Box zone = lattice.influenced_zone();
        points = {zone.min, zone.max, zone.centre(), lattice.rest({0, 0, 0})};
        while (points.size() < 150) points.push_back(random.point_in(lattice, 0.0));
        while (points.size() < 203) points.push_back(random.point_in(lattice, -1.0));
        while (points.size() < 230) points.push_back(random.point_outside(lattice, 3.0));
        for (std::size_t p = 0; p < points.size(); ++p) {
            normals.push_back(p % 9 == 4 ? Vec3f{0.0f}
                                         : Vec3f{unit_or_zero(random.vector(-1.0, 1.0))});
        }
    }
    Lattice lattice;
    LatticeField field;
    std::vector<Vec3> points;
    std::vector<Vec3f> normals;
};

TEST(LatticeEvaluator, AgreesWithLatticeFieldUpToRounding) {
    const unsigned seed = 7200;
    SCOPED_TRACE("seed " + std::to_string(seed));
    LatticeRandom random(seed);
    for (int i = 0; i < 40; ++i) {
        const Scene scene(random);
        const Lattice& lattice = scene.lattice;
        const LatticeEvaluator evaluator(scene.field);
        const Result result = result_at(evaluator, scene.points, scene.normals);
        // The rounding error of a coordinate, in cells.
        const double farthest = glm::length(lattice.origin) + lattice.influenced_zone().diagonal();
        const double rounding = std::numeric_limits<double>::epsilon() *
                                (1.0 + farthest / lattice.smallest_cell_extent());
        for (std::size_t p = 0; p < scene.points.size(); ++p) {
            const Vec3& x = scene.points[p];
            const Vec3 exact = x + scene.field.displacement(x);
            ASSERT_LT(glm::distance(result.displaced[p], exact), 20.0 * rounding);
            const Mat3 jacobian = scene.field.jacobian(x);
            const double image = glm::length(cofactor_times(jacobian, Vec3{scene.normals[p]}));
            // Allows for sums of products of derivatives as large as 1/cell.
            const double largest = 1.0 + 3.0 / lattice.smallest_cell_extent();
            if (image < 1e-3 * largest * largest) continue;
            ASSERT_LT(glm::distance(result.to_normals[p], covariant(jacobian, scene.normals[p])),
                      2e-7 + 1e5 * rounding);
        }
    }
}

TEST(LatticeEvaluator, GivesTheSameBitsWithEveryWidthOfVector) {
    const unsigned seed = 7300;
    SCOPED_TRACE("seed " + std::to_string(seed));
    LatticeRandom random(seed);
    for (int i = 0; i < 60; ++i) {
        const Scene scene(random);
        const Result plain =
            result_at(LatticeEvaluator(scene.field, Vectors::plain), scene.points, scene.normals);
        for (const Vectors vectors : all_vectors()) {
            const Result wide =
                result_at(LatticeEvaluator(scene.field, vectors), scene.points, scene.normals);
            for (std::size_t p = 0; p < scene.points.size(); ++p) {
                ASSERT_TRUE(same(wide.displaced[p], plain.displaced[p])) << p;
                ASSERT_TRUE(same(wide.transformed[p], plain.transformed[p])) << p;
                ASSERT_TRUE(same(wide.to_normals[p], plain.to_normals[p])) << p;
            }
        }
    }
}

TEST(LatticeEvaluator, GivesAPointTheSameBitsInAnyBatch) {
    const unsigned seed = 7400;
    SCOPED_TRACE("seed " + std::to_string(seed));
    LatticeRandom random(seed);
    for (const Vectors vectors : all_vectors()) {
        const Scene scene(random);
        const LatticeEvaluator evaluator(scene.field, vectors);
        const Result all = result_at(evaluator, scene.points, scene.normals);
        for (int i = 0; i < 300; ++i) {
            const auto first = static_cast<std::size_t>(random.count(0, 229));
            const auto count = std::min<std::size_t>(scene.points.size() - first,
                                                     static_cast<std::size_t>(random.count(0, 70)));
            const Result some = result_at(evaluator, std::span(scene.points).subspan(first, count),
                                          std::span(scene.normals).subspan(first, count));
            for (std::size_t p = 0; p < count; ++p) {
                ASSERT_TRUE(same(some.displaced[p], all.displaced[first + p]));
                ASSERT_TRUE(same(some.transformed[p], all.displaced[first + p]));
                ASSERT_TRUE(same(some.to_normals[p], all.to_normals[first + p]));
            }
        }
    }
}

TEST(LatticeEvaluator, TransformsNormalsPerpendicularToTheDisplacedTangents) {
    const unsigned seed = 7500;
    SCOPED_TRACE("seed " + std::to_string(seed));
    LatticeRandom random(seed);
    constexpr double kStep = 1e-5;  // in cells
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Lattice lattice = random.lattice(Vec3{0.0}, 1, 5);
        const LatticeEvaluator evaluator(
            LatticeField(lattice, random.vectors(lattice.control_count())));
        const Vec3 x = random.point_in(lattice, 0.01);
        const double h = kStep * lattice.smallest_cell_extent();
        const Vec3 n = unit_or_zero(random.vector(-1.0, 1.0));
        const Vec3 s = unit_or_zero(glm::cross(n, random.vector(-1.0, 1.0))), t = glm::cross(n, s);
        const std::vector<Vec3> around{x - h * s, x + h * s, x - h * t, x + h * t};
        std::vector<Vec3> to(4), at(1);
        std::vector<Vec3f> to_normals(1);
        evaluator.displace(around, to);
        evaluator.transform(std::vector{x}, std::vector{Vec3f{n}}, at, to_normals);
        const Vec3 image = glm::cross(to[1] - to[0], to[3] - to[2]) / (4.0 * h * h);
        if (glm::length(image) < 0.1) continue;
        ASSERT_LT(glm::distance(Vec3{to_normals[0]}, unit_or_zero(image)), 1e-6) << i;
        ++compared;
    }
    EXPECT_GT(compared, 300);
}

TEST(LatticeEvaluator, KeepsTheBorderAndTheOutsideBitForBit) {
    const unsigned seed = 7600;
    SCOPED_TRACE("seed " + std::to_string(seed));
    LatticeRandom random(seed);
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 20; ++i) {
        Scene scene(random);
        std::vector<Vec3>& points = scene.points;
        std::erase_if(points, [&](const Vec3& x) { return scene.lattice.influences(x); });
        points.insert(points.end(), {Vec3{kInfinite}, Vec3{-kInfinite}, Vec3{1e300},
                                     Vec3{std::numeric_limits<double>::quiet_NaN()}});
        scene.normals.resize(points.size());
        for (const Vectors vectors : all_vectors()) {
            const Result result =
                result_at(LatticeEvaluator(scene.field, vectors), points, scene.normals);
            for (std::size_t p = 0; p < points.size(); ++p) {
                ASSERT_TRUE(same(result.displaced[p], points[p])) << p;
                ASSERT_TRUE(same(result.transformed[p], points[p])) << p;
                ASSERT_TRUE(same(result.to_normals[p], scene.normals[p])) << p;
            }
        }
    }
}

TEST(LatticeEvaluator, UsesNewDisplacementsAfterAnUpdate) {
    LatticeRandom random(7700);
    const Scene scene(random);
    const LatticeField other(scene.lattice, random.vectors(scene.lattice.control_count()));
    LatticeEvaluator evaluator(scene.field);
    evaluator.update(other);
    EXPECT_EQ(result_at(evaluator, scene.points, scene.normals).displaced,
              result_at(LatticeEvaluator(other), scene.points, scene.normals).displaced);
    EXPECT_NE(result_at(evaluator, scene.points, scene.normals).displaced,
              result_at(LatticeEvaluator(scene.field), scene.points, scene.normals).displaced);
}

// cof(J)·n is zero where a flat lattice is squeezed to a point. n is kept where nothing bends.
TEST(LatticeEvaluator, GivesZeroForNormalsWithoutAnImageAndKeepsThoseAtZeroGradient) {
    const Lattice lattice{.origin = Vec3{0.0}, .cell = Vec3{1.0}, .deformable = IVec3{8}};
    std::vector<Vec3> squeezed(lattice.control_count()), shifted(lattice.control_count());
    for (int k = 0; k < 8; ++k) {
        for (int j = 0; j < 8; ++j) {
            for (int i = 0; i < 8; ++i) squeezed[lattice.control_index({i, j, k})] = -Vec3(i, j, k);
        }
    }
    shifted.assign(lattice.control_count(), Vec3{1, -2, 4});
    const std::vector<Vec3> points{{3.5, 3.5, 3.5}, {3, 4, 3}};
    const std::vector<Vec3f> normals(2, Vec3f{0.6f, 0.0f, 0.8f});
    for (const Vectors vectors : all_vectors()) {
        const Result point =
            result_at(LatticeEvaluator(LatticeField(lattice, squeezed), vectors), points, normals);
        for (std::size_t p = 0; p < 2; ++p) EXPECT_LT(glm::length(point.transformed[p]), 1e-14);
        const Result still = result_at(
            LatticeEvaluator(LatticeField(lattice, std::vector(lattice.control_count(), Vec3{0.0})),
                             vectors),
            points, normals);
        for (std::size_t p = 0; p < 2; ++p) EXPECT_TRUE(same(still.to_normals[p], normals[p]));
        const Result aside =
            result_at(LatticeEvaluator(LatticeField(lattice, shifted), vectors), points, normals);
        for (std::size_t p = 0; p < 2; ++p) {
            EXPECT_LT(glm::distance(aside.displaced[p], points[p] + Vec3(1, -2, 4)), 1e-14);
            EXPECT_LT(glm::distance(aside.to_normals[p], normals[p]), 1e-6f);
        }
    }
}

}  // namespace
}  // namespace pectin
