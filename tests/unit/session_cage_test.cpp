// Cages fitted to the object: an affine map of all control points maps the object by that map.
// Source: linear precision of uniform B-splines; R. H. Bartels, J. C. Beatty, B. A. Barsky. An
// Introduction to Splines for Use in Computer Graphics and Geometric Modeling. Morgan Kaufmann
// 1987.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "command/json.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Cage;
using command::Control;
using command::Shape;

struct Affine {
    Mat3 linear{1.0};
    Vec3 by{0.0};

    Vec3 operator()(const Vec3& x) const { return linear * x + by; }
};

Affine random_affine(LatticeRandom& random) {
    Affine map;
    for (int column = 0; column < 3; ++column) map.linear[column] += random.vector(-1.0, 1.0);
    map.by = random.vector(-5.0, 5.0);
    return map;
}

LatticeField moved_by(const Lattice& lattice, const Affine& map) {
    std::vector<Vec3> displacements(lattice.control_count());
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                const Vec3 rest = lattice.rest({i, j, k});
                displacements[lattice.control_index({i, j, k})] = map(rest) - rest;
            }
        }
    }
    return {lattice, std::move(displacements)};
}

// The rounding error of numbers as large as the lattice and its image.
double rounding(const Lattice& lattice) {
    const Box zone = lattice.influenced_zone();
    return 1e-14 * (20.0 + glm::length(zone.min) + glm::length(zone.max)) * 4.0;
}

TEST(FittedCage, MovedByAnAffineMapMovesItsBoxByThatMap) {
    constexpr unsigned kSeed = 71;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    for (int trial = 0; trial < 100; ++trial) {
        Box box;
        box.include(random.vector(-3.0, 3.0));
        box.include(box.min + random.vector(0.1, 4.0));
        if (trial % 5 == 0) box.max.y = box.min.y;  // flat
        const IVec3 counts{random.count(1, 8), random.count(1, 8), random.count(1, 8)};
        const Affine map = random_affine(random);
        const Lattice lattice = fit_lattice(box, counts);
        ASSERT_TRUE(lattice.is_valid());
        ASSERT_EQ(lattice.counts(), counts);
        const LatticeField field = moved_by(lattice, map);
        for (int i = 0; i < 50; ++i) {
            Vec3 x = box.min + random.vector(0.0, 1.0) * box.extent();
            for (int axis = 0; axis < 3; ++axis) {  // corners, edges and sides, too
                const int side = random.count(0, 3);
                if (side < 2) x[axis] = side == 0 ? box.min[axis] : box.max[axis];
            }
            ASSERT_LE(glm::distance(x + field.displacement(x), map(x)), rounding(lattice))
                << "trial " << trial;
            const Mat3 jacobian = field.jacobian(x);
            for (int column = 0; column < 3; ++column) {
                ASSERT_LE(glm::distance(jacobian[column], map.linear[column]),
                          rounding(lattice) / lattice.smallest_cell_extent());
            }
        }
    }
}

// ---- Commands

using test::expect_done;
using test::refusal_of;

std::vector<Vec3> positions(const TriMesh& mesh) {
    std::vector<Vec3> all;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
        all.push_back(mesh.position(VertexId{i}));
    return all;
}

// The command that moves all control points by the map.
Control all_moved(const Lattice& cage, const Affine& map) {
    Control control;
    for (int k = cage.first_index().z; k <= cage.last_index().z; ++k) {
        for (int j = cage.first_index().y; j <= cage.last_index().y; ++j) {
            for (int i = cage.first_index().x; i <= cage.last_index().x; ++i) {
                const Vec3 rest = cage.rest(cage.control_of_user_index({i, j, k}));
                control.points.push_back({{i, j, k}, map(rest)});
            }
        }
    }
    return control;
}

TEST(FittedCage, MovesTheObjectExactlyAsFarAsAllItsControlPoints) {
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 4});
    expect_done(session, Adapt{.enabled = false});
    const std::vector<Vec3> before = positions(session.mesh());
    expect_done(session, Cage{.fit = IVec3{4, 4, 4}});
    const Lattice cage = *session.lattice_settings().cage;
    expect_done(session, all_moved(cage, {.by = {1, 0, 0}}));
    const std::vector<Vec3> after = positions(session.mesh());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LE(glm::distance(after[i], before[i] + Vec3(1, 0, 0)), 1e-14);
    }
}

TEST(FittedCage, IsItsOwnMirrorImageAlsoAboutAPlaneBesideTheMiddle) {
    constexpr double kAt = 0.1;
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    const Box object = session.mesh().bounding_box();
    for (int axis = 0; axis < 3; ++axis) {
        const MirrorPlane plane{axis, kAt};
        expect_done(session, command::Symmetry{.plane = static_cast<command::Symmetry::Plane>(axis),
                                               .through = Vec3{kAt}});
        expect_done(session, Cage{.fit = IVec3{3, 4, 5}});
        const Lattice& cage = *session.lattice_settings().cage;
        EXPECT_LE(glm::distance(mirror_image(plane, cage).origin, cage.origin), 1e-14);
        // The points of the first and the last layer are on the box or beyond it.
        const Vec3 first = cage.rest(cage.margin);
        const Vec3 last = cage.rest(cage.counts() - 1 + cage.margin);
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE(first[i], object.min[i] + 1e-14);
            EXPECT_GE(last[i], object.max[i] - 1e-14);
        }
        const Vec3 to = cage.rest(cage.control_of_user_index({0, 0, 0})) + Vec3{0.1};
        expect_done(session, Control{.points = {{{0, 0, 0}, to}}});
        expect_done(session, command::Undo{});
    }
}

TEST(FittedCage, FitsTheObjectAloneWhereTheSymmetryPlaneIsBesideIt) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 2});
    expect_done(session, Cage{.fit = IVec3{4, 4, 4}});
    const Lattice without = *session.lattice_settings().cage;
    expect_done(session, command::Symmetry{.plane = command::Symmetry::Plane::x,
                                           .through = Vec3{1.5, 0.0, 0.0}});
    expect_done(session, Cage{.fit = IVec3{4, 4, 4}});
    EXPECT_EQ(session.lattice_settings().cage, without);
}

TEST(FittedCage, MovesEveryShapeByTheAffineMapOfItsControlPoints) {
    constexpr unsigned kSeed = 72;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    for (int trial = 0; trial < 40; ++trial) {
        Session session;
        expect_done(session, Shape{trial % 2 == 0 ? Shape::Kind::sphere : Shape::Kind::plane, 3});
        expect_done(session, Adapt{.enabled = false});
        const std::vector<Vec3> before = positions(session.mesh());
        const IVec3 counts{random.count(1, 8), random.count(1, 8), random.count(1, 8)};
        expect_done(session, Cage{.fit = counts});
        const Lattice cage = *session.lattice_settings().cage;
        const Affine map = random_affine(random);
        expect_done(session, all_moved(cage, map));
        const std::vector<Vec3> after = positions(session.mesh());
        for (std::size_t i = 0; i < before.size(); ++i) {
            ASSERT_LE(glm::distance(after[i], map(before[i])), rounding(cage)) << "trial " << trial;
        }
    }
}

// The mirror image of a control point beyond the box is the one beyond the box on the other side.
TEST(FittedCage, MovesBothSidesAlikeWithSymmetry) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    expect_done(session, Adapt{.enabled = false});
    const std::vector<Vec3> before = positions(session.mesh());
    expect_done(session, command::Symmetry{.plane = command::Symmetry::Plane::x});
    expect_done(session, Cage{.fit = IVec3{3, 1, 4}});
    const Lattice cage = *session.lattice_settings().cage;
    // The map widens the object by half and shears it within the plane.
    Affine map{.linear = {1.5, 0, 0, 0, 1, 0.25, 0, 0.5, 1}, .by = {0, 1, 2}};
    Control half = all_moved(cage, map);
    std::erase_if(half.points, [](const Control::Point& point) { return point.index.x > 1; });
    expect_done(session, half);
    const std::vector<Vec3> after = positions(session.mesh());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LE(glm::distance(after[i], map(before[i])), rounding(cage));
    }
}

TEST(FittedCage, NumbersTheLayersBeyondTheBoxFromMinusOne) {
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 2});
    expect_done(session, Cage{.fit = IVec3{3, 1, 2}});
    const auto moves = [](const IVec3& index) { return Control{{{index, {0, 0, 0}}}}; };
    for (const IVec3& index :
         {IVec3{-2, 0, 0}, IVec3{4, 0, 0}, IVec3{0, 3, 0}, IVec3{0, 0, 3}, IVec3{0, 0, -2}}) {
        const std::string reason = refusal_of(session, moves(index));
        EXPECT_NE(reason.find("its last is [3, 2, 2], the first [-1, -2, -1]"), std::string::npos)
            << reason;
    }
    EXPECT_NE(refusal_of(session, moves({0, -3, 0})).find("from -2 to 255"), std::string::npos);
    for (const IVec3& index : {IVec3{-1, -2, -1}, IVec3{3, 2, 2}, IVec3{1, 0, 0}}) {
        expect_done(session, moves(index));
    }
}

// A cage that is given by its origin and cells can have layers beyond the box, too.
TEST(Cage, WithMarginsIsTheFittedOneOfTheSameBox) {
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 2});
    expect_done(session, Cage{.fit = IVec3{3, 1, 2}});
    const Lattice fitted = *session.lattice_settings().cage;
    expect_done(session, Cage{.origin = Vec3{-1, 0, -1},
                              .cell = Vec3{1, 1, 2},
                              .deformable = IVec3{3, 1, 2},
                              .margin = IVec3{1, 2, 1}});
    EXPECT_EQ(*session.lattice_settings().cage, fitted);
    expect_done(
        session,
        Cage{.origin = Vec3{-1, 0, -1}, .cell = Vec3{1, 1, 2}, .deformable = IVec3{3, 1, 2}});
    EXPECT_EQ(session.lattice_settings().cage->deformable, IVec3(3, 1, 2)) << "none by default";
}

}  // namespace
}  // namespace pectin
