// Tests that the diagonal of a quad depends only on its geometry, and that mirrored quads get
// mirrored diagonals.
#include "mesh/quad_diagonal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/triangulate.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;
using Quad = std::array<Vec3, 4>;

// The corners that the chosen diagonal joins.
std::pair<Vec3, Vec3> diagonal_of(const Quad& q, const Vec3& centre = Vec3{0.0}) {
    const std::size_t from = choose_diagonal(q, centre).joins_1_and_3 ? 1 : 0;
    return {q[from], q[from + 2]};
}

// Calls triangulate(), as the program does.
std::pair<Vec3, Vec3> inner_edge_of(const Quad& q) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(q, triangles);
    for (std::uint32_t from : {0u, 1u}) {
        const bool in_both = std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
            return std::count(t.begin(), t.end(), from) +
                       std::count(t.begin(), t.end(), from + 2) ==
                   2;
        });
        if (in_both) return {q[from], q[from + 2]};
    }
    ADD_FAILURE() << "the triangles share no diagonal";
    return {};
}

bool same_ends(const std::pair<Vec3, Vec3>& x, const std::pair<Vec3, Vec3>& y) {
    return x == y || (x.first == y.second && x.second == y.first);
}

Quad rotated(Quad q, std::size_t by, bool reversed) {
    std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(by), q.end());
    if (reversed) std::reverse(q.begin(), q.end());
    return q;
}

Vec3 mirrored(Vec3 p, int axis, const Vec3& centre) {
    p[axis] = 2.0 * centre[axis] - p[axis];
    return p;
}

// Squares, rectangles, trapezoids, kites, bent and random quads, most of them with ties.
Quad random_quad(Random& random) {
    const Vec3 at{random.integer(1, 40) * 0.25, random.integer(1, 40) * 0.25,
                  random.integer(-40, 40) * 0.25};
    const double w = random.integer(1, 4) * 0.125, h = random.chance(0.5) ? w : 0.125;
    const double slant = random.chance(0.5) ? 0.0 : 0.0625;
    Quad q{Vec3{-w + slant, -h, 0}, Vec3{w - slant, -h, 0}, Vec3{w, h, 0}, Vec3{-w, h, 0}};
    const int kind = random.integer(0, 3);
    const Vec3 u = random.direction();
    const Vec3 v = glm::normalize(glm::cross(u, random.direction()));
    for (Vec3& p : q) {
        if (kind == 1) p = Vec3{p.z, p.x, p.y};
        if (kind == 2) p += 0.1 * random.direction();
        if (kind == 3) p = p.x * u + p.y * v;
        p += at;
    }
    return q;
}

TEST(QuadDiagonal, DoesNotDependOnTheFirstCornerOrTheOrientation) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const Quad q = random_quad(random);
        const auto diagonal = inner_edge_of(q);
        for (std::size_t by = 0; by < 4; ++by) {
            for (const bool reversed : {false, true}) {
                ASSERT_TRUE(same_ends(inner_edge_of(rotated(q, by, reversed)), diagonal))
                    << "case " << i << ", turned by " << by << ", reversed " << reversed;
            }
        }
    }
}

TEST(QuadDiagonal, IsMirroredWhereTheQuadIs) {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Quad q = random_quad(random);
        const auto [from, to] = inner_edge_of(q);
        for (int axis = 0; axis < 3; ++axis) {
            Quad image = q;
            for (Vec3& p : image) p = mirrored(p, axis, Vec3{0.0});
            const auto [lowest, highest] = std::minmax_element(
                q.begin(), q.end(),
                [&](const Vec3& x, const Vec3& y) { return x[axis] < y[axis]; });
            if ((*lowest)[axis] < 0.0 && (*highest)[axis] > 0.0)
                continue;  // it may be its own mirror image
            const auto by = static_cast<std::size_t>(random.integer(0, 3));
            ASSERT_TRUE(same_ends(inner_edge_of(rotated(image, by, random.chance(0.5))),
                                  {mirrored(from, axis, Vec3{0.0}), mirrored(to, axis, Vec3{0.0})}))
                << "case " << i << ", axis " << axis;
        }
    }
}

TEST(QuadDiagonal, IsMirroredUpToTheRoundingOfFilesAboutAnyCentre) {
    Random random(3);
    const auto rounded = [](double x) { return std::round(x * 1e6) * 1e-6; };
    for (int i = 0; i < 5'000; ++i) {
        Quad q = random_quad(random);
        const Vec3 centre{20.1, -3.3, 0.0};
        Quad image = q;
        for (std::size_t k = 0; k < 4; ++k) {
            image[k].x = 2.0 * centre.x - q[k].x;
            for (int axis = 0; axis < 3; ++axis) {
                q[k][axis] = rounded(q[k][axis]);
                image[k][axis] = rounded(image[k][axis]);
            }
        }
        const bool second = choose_diagonal(q, centre).joins_1_and_3;
        ASSERT_EQ(choose_diagonal(image, centre).joins_1_and_3, second) << "case " << i;
    }
}

TEST(QuadDiagonal, IsTheShorterOneUnlessItLeavesASliver) {
    const Quad kite{Vec3{0, 0, 0}, Vec3{2, 1, 0}, Vec3{5, 0, 0}, Vec3{2, -1, 0}};
    EXPECT_TRUE(same_ends(diagonal_of(kite), {kite[1], kite[3]}));
    const Quad with_straight_corner{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 5, 0}};
    EXPECT_TRUE(same_ends(diagonal_of(with_straight_corner),
                          {with_straight_corner[1], with_straight_corner[3]}));
    const Quad arrow{Vec3{0, 0, 0}, Vec3{2, 1, 0}, Vec3{0, 2, 0}, Vec3{1, 1, 0}};
    EXPECT_TRUE(same_ends(diagonal_of(arrow), {arrow[1], arrow[3]}));
}

TEST(QuadDiagonal, HasTheLargerSmallestAngleWhereBothAreEquallyLong) {
    // Diagonals of length 5 that intersect at different fractions of their lengths.
    const Quad q{Vec3{-2.5, 0, 0}, Vec3{-1, -1, 0}, Vec3{2.5, 0, 0}, Vec3{2, 3, 0}};
    ASSERT_NEAR(glm::distance(q[1], q[3]), 5.0, 1e-15);
    const auto smallest_angle = [&](std::size_t from) {
        double least = INFINITY;
        const auto angle = [](const Vec3& tip, const Vec3& p, const Vec3& r) {
            return std::acos(glm::dot(glm::normalize(p - tip), glm::normalize(r - tip)));
        };
        for (std::size_t side : {from + 1, from + 3}) {
            const Vec3 &a = q[from], &c = q[from + 2], &b = q[side % 4];
            least = std::min({least, angle(a, b, c), angle(b, c, a), angle(c, a, b)});
        }
        return least;
    };
    const std::size_t better = smallest_angle(0) > smallest_angle(1) ? 0 : 1;
    EXPECT_TRUE(same_ends(diagonal_of(q), {q[better], q[better + 2]}));
}

TEST(QuadDiagonal, IsReportedIfNeitherCoversTheQuad) {
    const Quad square{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}};
    EXPECT_TRUE(choose_diagonal(square, Vec3{0.0}).covers);
    const Quad even_tie{square[0], square[2], square[1], square[3]};
    EXPECT_FALSE(choose_diagonal(even_tie, Vec3{0.0}).covers);
    const Quad uneven_tie{Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 3, 0}};
    EXPECT_FALSE(choose_diagonal(uneven_tie, Vec3{0.0}).covers);
    const Quad line{Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{2, 2, 0}, Vec3{3, 3, 0}};
    EXPECT_TRUE(choose_diagonal(line, Vec3{0.0}).covers) << "it has no area to cover";
}

}  // namespace
}  // namespace pectin
