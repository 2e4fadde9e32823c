// The orientation of three points, compared with integer arithmetic.
#include "geometry/orientation.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "support/random_mesh.h"

namespace pectin {
namespace {

int sign(std::int64_t n) { return (n > 0) - (n < 0); }

TEST(Orientation, EqualsIntegerArithmeticForNearlyCollinearPoints) {
    test::Random random(11);
    int on_line = 0;
    for (int i = 0; i < 200'000; ++i) {
        // Three points in one direction, each at most one step of the grid off the line. The
        // products are below 2^62.
        const int most = 1 << 14;
        const std::int64_t u = random.integer(-most, most), v = random.integer(-most, most);
        std::int64_t x[3], y[3];
        for (int k = 0; k < 3; ++k) {
            const std::int64_t along = random.integer(-most, most);
            x[k] = along * u + random.integer(-1, 1);
            y[k] = along * v + random.integer(-1, 1);
        }
        const std::int64_t exact = (x[0] - x[2]) * (y[1] - y[2]) - (y[0] - y[2]) * (x[1] - x[2]);
        const auto at = [&](int k) {
            return Vec2{static_cast<double>(x[k]), static_cast<double>(y[k])} * 0x1p-30;
        };
        ASSERT_EQ(orientation(at(0), at(1), at(2)), sign(exact)) << "case " << i;
        on_line += exact == 0 ? 1 : 0;
    }
    EXPECT_GT(on_line, 100);
}

TEST(Orientation, DistinguishesNeighbouringDoubles) {
    // The points are half a unit in the last place above or below the diagonal, where
    // floating-point arithmetic mostly gives 0.
    const Vec2 a{12.0, 12.0}, b{24.0, 24.0};
    for (int i = -8; i <= 8; ++i) {
        for (int j = -8; j <= 8; ++j) {
            const Vec2 c{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
            EXPECT_EQ(orientation(c, a, b), (c.y > c.x) - (c.y < c.x)) << i << ' ' << j;
            EXPECT_EQ(orientation(a, b, c), orientation(c, a, b));
            EXPECT_EQ(orientation(b, a, c), -orientation(a, b, c));
        }
    }
}

}  // namespace
}  // namespace pectin
