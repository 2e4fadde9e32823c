#include "mesh/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/vec.h"

namespace pectin {
namespace {

constexpr ShapeKind kKinds[] = {ShapeKind::sphere, ShapeKind::cube, ShapeKind::plane,
                                ShapeKind::torus, ShapeKind::cylinder};

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

const Vec3& position(const IndexedFaceSet& shape, std::uint32_t corner) {
    return shape.positions[shape.corners[corner].position];
}

// Calls visit(corner, next corner of the same polygon).
template <typename Visit>
void for_each_side(const IndexedFaceSet& shape, Visit visit) {
    for (std::size_t p = 0; p < shape.polygon_count(); ++p) {
        const std::uint32_t begin = shape.polygon_begin(p), end = shape.polygon_end[p];
        for (std::uint32_t c = begin; c < end; ++c) visit(c, c + 1 == end ? begin : c + 1);
    }
}

std::set<DirectedEdge> directed_edges(const IndexedFaceSet& shape) {
    std::set<DirectedEdge> edges;
    for_each_side(shape, [&](std::uint32_t a, std::uint32_t b) {
        const DirectedEdge edge{shape.corners[a].position, shape.corners[b].position};
        EXPECT_TRUE(edges.insert(edge).second) << "an edge is used twice in one direction";
    });
    return edges;
}

int boundary_edges(const IndexedFaceSet& shape) {
    const std::set<DirectedEdge> edges = directed_edges(shape);
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [&](const DirectedEdge& e) {
        return !edges.contains({e.second, e.first});
    }));
}

int euler_characteristic(const IndexedFaceSet& shape) {
    std::set<DirectedEdge> undirected;
    std::set<std::uint32_t> used;
    for (const DirectedEdge& e : directed_edges(shape)) {
        undirected.insert(std::minmax(e.first, e.second));
        used.insert(e.first);
    }
    EXPECT_EQ(used.size(), shape.positions.size()) << "a vertex has no face";
    return static_cast<int>(shape.positions.size()) - static_cast<int>(undirected.size()) +
           static_cast<int>(shape.polygon_count());
}

Vec3 area_normal(const IndexedFaceSet& shape, std::size_t polygon) {
    const std::uint32_t begin = shape.polygon_begin(polygon);
    Vec3 sum{0.0};
    for (std::uint32_t c = begin + 1; c + 1 < shape.polygon_end[polygon]; ++c) {
        const Vec3& a = position(shape, begin);
        sum += glm::cross(position(shape, c) - a, position(shape, c + 1) - a);
    }
    return sum;
}

// The volume by the divergence theorem: the sum of signed tetrahedra, positive if faces point
// outwards.
double signed_volume(const IndexedFaceSet& shape) {
    double sum = 0.0;
    for (std::size_t p = 0; p < shape.polygon_count(); ++p) {
        const std::uint32_t a = shape.polygon_begin(p);
        for (std::uint32_t c = a + 1; c + 1 < shape.polygon_end[p]; ++c) {
            sum += glm::dot(position(shape, a),
                            glm::cross(position(shape, c), position(shape, c + 1)));
        }
    }
    return sum / 6.0;
}

std::size_t triangle_count(const IndexedFaceSet& shape) {
    return shape.corners.size() - 2 * shape.polygon_count();
}

bool has_position(const IndexedFaceSet& shape, const Vec3& p) {
    return std::find(shape.positions.begin(), shape.positions.end(), p) != shape.positions.end();
}

TEST(Shapes, AreClosedSurfacesOfTheirGenusAndThePlaneADisc) {
    for (int n : {1, 2, 3, 4, 5}) {
        EXPECT_EQ(euler_characteristic(make_shape(ShapeKind::sphere, n)), 2);
        EXPECT_EQ(euler_characteristic(make_shape(ShapeKind::cube, n)), 2);
        EXPECT_EQ(euler_characteristic(make_shape(ShapeKind::cylinder, n)), 2);
        EXPECT_EQ(euler_characteristic(make_shape(ShapeKind::torus, n)), 0);
        EXPECT_EQ(euler_characteristic(make_shape(ShapeKind::plane, n)), 1);
        for (ShapeKind kind : kKinds) {
            EXPECT_EQ(boundary_edges(make_shape(kind, n)), kind == ShapeKind::plane ? 4 * n : 0);
        }
    }
}

TEST(Shapes, EncloseVolumesThatConvergeFromBelowToTheSolids) {
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(signed_volume(make_shape(ShapeKind::cube, 3)), 8.0, 1e-13);
    const struct {
        ShapeKind kind;
        int coarse, fine;
        double exact;
    } solids[] = {{ShapeKind::sphere, 2, 3, 4.0 / 3.0 * pi},
                  {ShapeKind::torus, 8, 16, 2.0 * pi * pi * 0.16},
                  {ShapeKind::cylinder, 8, 16, 2.0 * pi}};
    for (const auto& solid : solids) {
        const double coarse = solid.exact - signed_volume(make_shape(solid.kind, solid.coarse));
        const double fine = solid.exact - signed_volume(make_shape(solid.kind, solid.fine));
        EXPECT_GT(fine, 0.0);
        EXPECT_LT(fine, 0.02 * solid.exact);
        EXPECT_NEAR(coarse / fine, 4.0, 0.2);  // the error is of second order
    }
}

TEST(Shapes, HaveTheFacesTheyPromiseAndStayBelowSixMillionTriangles) {
    EXPECT_EQ(make_shape(ShapeKind::sphere, 0).polygon_count(), 20u);
    EXPECT_EQ(make_shape(ShapeKind::sphere, 3).polygon_count(), 20u * 64u);
    EXPECT_EQ(make_shape(ShapeKind::cube, 3).polygon_count(), 6u * 9u);
    EXPECT_EQ(make_shape(ShapeKind::plane, 3).polygon_count(), 9u);
    EXPECT_EQ(make_shape(ShapeKind::torus, 3).polygon_count(), 12u * 6u);
    EXPECT_EQ(make_shape(ShapeKind::torus, 1).polygon_count(), 8u * 4u);
    EXPECT_EQ(make_shape(ShapeKind::cylinder, 3).polygon_count(), 12u * (3u + 2u * 3u));
    for (ShapeKind kind : kKinds) {
        const std::size_t most = triangle_count(make_shape(kind, max_resolution(kind)));
        EXPECT_LT(most, 6'000'000u);
        EXPECT_GT(most, kind == ShapeKind::sphere ? 1'500'000u : 5'900'000u);
    }
}

TEST(Shapes, BelongToOneUnnamedPartAndOnlyThePlaneHasTextureCoordinates) {
    for (ShapeKind kind : kKinds) {
        const IndexedFaceSet shape = make_shape(kind, 2);
        EXPECT_EQ(shape.parts, std::vector<Part>{Part{}});
        EXPECT_EQ(shape.polygon_part, std::vector<std::uint32_t>(shape.polygon_count(), 0u));
        EXPECT_EQ(shape.uvs.empty(), kind != ShapeKind::plane);
        for (const auto& corner : shape.corners) {
            ASSERT_LT(corner.normal, shape.normals.size());
            if (kind == ShapeKind::plane) {
                ASSERT_LT(corner.uv, shape.uvs.size());
            } else {
                ASSERT_EQ(corner.uv, IndexedFaceSet::kNoIndex);
            }
        }
    }
}

TEST(Shapes, HaveUnitNormalsOnTheOutsideOfTheirFaces) {
    for (ShapeKind kind : kKinds) {
        const IndexedFaceSet shape = make_shape(kind, 4);
        for (const Vec3f& normal : shape.normals) {
            EXPECT_NEAR(glm::length(Vec3(normal)), 1.0, 1e-7);
        }
        for (std::size_t p = 0; p < shape.polygon_count(); ++p) {
            const Vec3 face = glm::normalize(area_normal(shape, p));
            for (std::uint32_t c = shape.polygon_begin(p); c < shape.polygon_end[p]; ++c) {
                EXPECT_GT(glm::dot(face, Vec3(shape.normals[shape.corners[c].normal])), 0.9);
            }
        }
    }
}

TEST(Shapes, KeepHardEdgesByNormalsOfTheirOwn) {
    // Flat sides and caps have the normal of their faces.
    for (ShapeKind kind : {ShapeKind::cube, ShapeKind::plane, ShapeKind::cylinder}) {
        const IndexedFaceSet shape = make_shape(kind, 3);
        for (std::size_t p = 0; p < shape.polygon_count(); ++p) {
            const Vec3 face = glm::normalize(area_normal(shape, p));
            const bool flat = kind != ShapeKind::cylinder || std::abs(face.y) > 0.5;
            for (std::uint32_t c = shape.polygon_begin(p); flat && c < shape.polygon_end[p]; ++c) {
                const Vec3 normal(shape.normals[shape.corners[c].normal]);
                EXPECT_NEAR(glm::distance(face, normal), 0.0, 1e-12);
            }
        }
    }
}

TEST(Shapes, MirrorThemselvesToTheBit) {
    for (ShapeKind kind : kKinds) {
        for (int n : {1, 2, 3}) {
            const IndexedFaceSet shape = make_shape(kind, n);
            const auto less = [](const Vec3& a, const Vec3& b) {
                return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
            };
            const std::set<Vec3, decltype(less)> points(shape.positions.begin(),
                                                        shape.positions.end(), less);
            EXPECT_EQ(points.size(), shape.positions.size()) << "two vertices at one place";
            for (Vec3 p : points) {
                for (int axis = 0; axis < 3; ++axis) {
                    Vec3 mirrored = p;
                    mirrored[axis] = -mirrored[axis];
                    EXPECT_TRUE(points.contains(mirrored));
                }
            }
        }
    }
}

TEST(Sphere, HasTheAxisPointsAmongItsVerticesToTheBit) {
    for (int n : {1, 2, 5}) {
        const IndexedFaceSet sphere = make_shape(ShapeKind::sphere, n);
        for (int axis = 0; axis < 3; ++axis) {
            for (double sign : {-1.0, 1.0}) {
                Vec3 p{0.0};
                p[axis] = sign;
                EXPECT_TRUE(has_position(sphere, p));
            }
        }
    }
}

TEST(Sphere, HasNormalsThatAreItsPositions) {
    const IndexedFaceSet sphere = make_shape(ShapeKind::sphere, 3);
    for (const auto& corner : sphere.corners) {
        EXPECT_EQ(sphere.normals[corner.normal], Vec3f(sphere.positions[corner.position]));
        EXPECT_NEAR(glm::length(sphere.positions[corner.position]), 1.0, 3e-16);
    }
}

TEST(Plane, HasItsTextureUprightAsSeenFromAbove) {
    const IndexedFaceSet plane = make_shape(ShapeKind::plane, 3);
    for (const auto& corner : plane.corners) {
        const Vec3& p = plane.positions[corner.position];
        const Vec2f& uv = plane.uvs[corner.uv];
        EXPECT_EQ(p.y, 0.0);
        EXPECT_NEAR(uv.x, (p.x + 1.0) / 2.0, 1e-7);
        EXPECT_NEAR(uv.y, (1.0 - p.z) / 2.0, 1e-7);
    }
}

TEST(Torus, LiesAtItsTubeRadiusFromItsCircle) {
    const IndexedFaceSet torus = make_shape(ShapeKind::torus, 5);
    for (const Vec3& p : torus.positions) {
        const double from_circle = std::hypot(p.x, p.z) - 1.0;
        EXPECT_NEAR(std::hypot(from_circle, p.y), 0.4, 1e-15);
    }
}

}  // namespace
}  // namespace pectin
