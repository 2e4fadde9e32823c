// The streaming passes give the same results as the functions for one element.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "ffd/drag_stream.h"
#include "ffd_vectors.h"

namespace pectin {
namespace {

class Numbers {
  public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double operator()() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
    Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }

  private:
    std::mt19937 engine_;
};

template <typename T>
bool same(const T& x, const T& y) {
    return std::memcmp(&x, &y, sizeof(T)) == 0;
}

struct Elements {
    explicit Elements(std::size_t count) : rest(count), normals(count), weights(count) {}
    std::vector<Vec3> rest;
    std::vector<Vec3f> normals;
    std::vector<DragWeight> weights;
};

// None of these is folded or nearly flattened by a d of up to 5 on each axis, so the vector code
// handles all of them.
Elements gentle(std::size_t count, Numbers& numbers) {
    Elements all(count);
    for (std::size_t i = 0; i < count; ++i) {
        all.rest[i] = 10.0 * numbers.vector();
        all.normals[i] = Vec3f{unit_or_zero(numbers.vector())};
        all.weights[i] = {static_cast<float>(numbers()), Vec3f{0.03 * numbers.vector()}};
        if (i % 5 == 4) all.weights[i] = {};
    }
    return all;
}

// Some of these only the scalar code can handle: a zero normal, a fold, and 1 + ∇w·d = 0 = d·n.
Elements wild(std::size_t count, const Vec3& d, Numbers& numbers) {
    Elements all = gentle(count, numbers);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 7 == 3) all.normals[i] = Vec3f{0.0f};
        if (i % 5 != 4) all.weights[i].gradient *= 33.0f;
    }
    if (count > 2 && d != Vec3{0.0}) {
        all.weights[1].gradient = Vec3f{-d / glm::dot(d, d)};
        all.normals[1] = Vec3f{unit_or_zero(glm::cross(d, Vec3{1, 2, 3}))};
    }
    return all;
}

void expect_plain_results(const Elements& all, const Vec3& d) {
    const std::size_t count = all.rest.size();
    std::vector<Vec3> to(count);
    std::vector<Vec3f> transformed(count);
    for (const Vectors vectors : all_vectors()) {
        const bool all_move = displace(all.rest, all.weights, d, to, vectors);
        transform_normals(all.normals, all.weights, d, transformed, vectors);
        for (std::size_t i = 0; i < count; ++i) {
            SCOPED_TRACE(std::to_string(i) + " of " + std::to_string(count));
            ASSERT_TRUE(same(to[i], displaced(all.rest[i], all.weights[i], d)));
            ASSERT_TRUE(same(transformed[i], covariant_normal(all.normals[i], all.weights[i], d)));
            ASSERT_TRUE(!all_move || to[i] != all.rest[i]);
        }
    }
}

// Arrays of every length up to several vectors, so that the ends of loops are tested, too.
TEST(DragStream, EqualsDisplacedAndCovariantNormalBitForBit) {
    const unsigned seed = 7100;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Numbers numbers(seed);
    for (std::size_t count = 1; count < 70; ++count) {
        const Vec3 d = count % 10 == 0 ? Vec3{0.0} : 5.0 * numbers.vector();
        expect_plain_results(gentle(count, numbers), d);
        expect_plain_results(wild(count, d, numbers), d);
    }
}

TEST(DragStream, ReportsThatAllPointsMoveWhereNoneIsNearRounding) {
    const unsigned seed = 7150;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Numbers numbers(seed);
    for (const Vectors vectors : all_vectors()) {
        for (std::size_t count = 1; count < 40; ++count) {
            std::vector<Vec3> rest(count), to(count);
            std::vector<DragWeight> weights(count, DragWeight{.w = 0.5f});
            for (Vec3& x : rest) x = 1e6 * numbers.vector();
            EXPECT_TRUE(displace(rest, weights, Vec3{0, -1e-3, 0}, to, vectors));
            // A single point that does not move is noticed, whichever it is.
            for (std::size_t still = 0; still < count; ++still) {
                weights[still].w = still % 2 == 0 ? 0.0f : 1e-9f;
                rest[still].x = 1e6;
                EXPECT_FALSE(displace(rest, weights, Vec3{-1e-3, 0, 0}, to, vectors)) << still;
                EXPECT_EQ(to[still], rest[still]);
                weights[still].w = -0.5f;
            }
            EXPECT_TRUE(displace(rest, weights, Vec3{0, -1e-3, 0}, to, vectors));
            EXPECT_FALSE(displace(rest, weights, Vec3{0.0}, to, vectors));
        }
    }
}

TEST(DragStream, MarksWhatMovedAndKeepsMarks) {
    const std::vector<Vec3> rest{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {0, 0, 0}, {1, 2, 3}};
    const std::vector<Vec3> to{{1, 2, 3}, {1, 2, 3.5}, {1, 2, 3}, {-0.0, 0, 0}, {2, 2, 3}};
    const std::vector<std::uint8_t> before{0, 0, 1, 0, 1};
    std::vector<std::uint8_t> moved(5, 9);
    mark_moved(rest, to, before, moved);
    EXPECT_EQ(moved, (std::vector<std::uint8_t>{0, 1, 1, 0, 1}));
}

}  // namespace
}  // namespace pectin
