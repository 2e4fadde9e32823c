// The streaming passes give what the plain functions give.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "ffd/drag_stream.h"

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

// Of every length up to some vectors' worth, so that what a loop does at its end is seen, too.
TEST(DragStream, IsDisplacedAndCovariantNormalToTheBit) {
    const unsigned seed = 7100;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Numbers numbers(seed);
    for (std::size_t count = 1; count < 70; ++count) {
        std::vector<Vec3> rest(count), to(count);
        std::vector<Vec3f> normals(count), turned(count);
        std::vector<DragWeight> weights(count);
        const Vec3 d = count % 10 == 0 ? Vec3{0.0} : 5.0 * numbers.vector();
        for (std::size_t i = 0; i < count; ++i) {
            rest[i] = 10.0 * numbers.vector();
            normals[i] = i % 7 == 3 ? Vec3f{0.0f} : Vec3f{unit_or_zero(numbers.vector())};
            if (i % 5 == 4) continue;  // no weight at all
            weights[i] = {static_cast<float>(numbers()), Vec3f{numbers.vector()}};
        }
        // A fold whose image vanishes: 1 + ∇w·d = 0 and d·n = 0.
        if (count > 2 && d != Vec3{0.0}) {
            weights[1].gradient = Vec3f{-d / glm::dot(d, d)};
            normals[1] = Vec3f{unit_or_zero(glm::cross(d, Vec3{1, 2, 3}))};
        }
        const bool all_move = displace(rest, weights, d, to);
        turn(normals, weights, d, turned);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_TRUE(same(to[i], displaced(rest[i], weights[i], d))) << i << " of " << count;
            ASSERT_TRUE(same(turned[i], covariant_normal(normals[i], weights[i], d)))
                << i << " of " << count;
            ASSERT_TRUE(!all_move || to[i] != rest[i]) << i << " of " << count;
        }
    }
}

TEST(DragStream, KnowsThatAllMoveWhereNoneIsNearRounding) {
    const unsigned seed = 7150;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Numbers numbers(seed);
    for (std::size_t count = 1; count < 20; ++count) {
        std::vector<Vec3> rest(count), to(count);
        std::vector<DragWeight> weights(count, DragWeight{.w = 0.5f});
        for (Vec3& x : rest) x = 1e6 * numbers.vector();
        EXPECT_TRUE(displace(rest, weights, Vec3{0, -1e-3, 0}, to));
        // Any one that stays is noticed, whichever of them it is.
        for (std::size_t still = 0; still < count; ++still) {
            weights[still].w = still % 2 == 0 ? 0.0f : 1e-9f;
            rest[still].x = 1e6;
            EXPECT_FALSE(displace(rest, weights, Vec3{-1e-3, 0, 0}, to)) << still;
            EXPECT_EQ(to[still], rest[still]);
            weights[still].w = -0.5f;
        }
        EXPECT_TRUE(displace(rest, weights, Vec3{0, -1e-3, 0}, to));
        EXPECT_FALSE(displace(rest, weights, Vec3{0.0}, to));
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
