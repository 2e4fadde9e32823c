// The centre relative to which ties are decided lies on the object's mirror planes.
#include "mesh/mirror_centre.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/random_mesh.h"

namespace pectin {
namespace {

std::vector<Vec3> mirrored_points(test::Random& random, int axis, double middle) {
    std::vector<Vec3> points;
    for (int i = 0; i < 500; ++i) {
        Vec3 p{random.uniform(-1, 1), random.uniform(2, 5), random.uniform(-1, 3)};
        points.push_back(p);
        p[axis] = 2.0 * middle - p[axis];
        points.push_back(p);
    }
    return points;
}

TEST(MirrorCentre, IsTheOriginForAnObjectThatIsMirroredThere) {
    test::Random random(5);
    std::vector<Vec3> points = mirrored_points(random, 0, 0.0);
    EXPECT_EQ(mirror_centre(points).x, 0.0);
    points.push_back({7.0, 3.0, 0.0});  // an asymmetric part moves the middle of the box
    EXPECT_EQ(mirror_centre(points).x, 0.0);
}

TEST(MirrorCentre, IsTheMiddleOfTheBoxForAnObjectThatIsMirroredThere) {
    test::Random random(6);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double middle : {0.3, 40.7, -2.0}) {
            const std::vector<Vec3> points = mirrored_points(random, axis, middle);
            EXPECT_NEAR(mirror_centre(points)[axis], middle, 1e-12) << axis;
        }
    }
}

TEST(MirrorCentre, IsTheOriginWhereThereAreNoPointsOrNoExtent) {
    EXPECT_EQ(mirror_centre({}), Vec3{0.0});
    EXPECT_EQ(mirror_centre(std::vector<Vec3>(3, Vec3{2.0})), Vec3{0.0});
}

}  // namespace
}  // namespace pectin
