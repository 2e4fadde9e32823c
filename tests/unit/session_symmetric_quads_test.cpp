// Symmetric meshes of quads stay symmetric under symmetric drags, whatever corner a face begins
// with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Drag;
using command::Shape;
using Plane = command::Symmetry::Plane;

using test::expect_done;

std::size_t faces_without_image(const Session& session, int axis = 0) {
    const double tolerance = 1e-7 * session.mesh().bounding_box().diagonal();
    return test::faces_without_image(session.mesh(), axis, tolerance);
}

void open_text(Session& session, const std::string& text) {
    const std::string path = testing::TempDir() + "symmetric_quads.obj";
    std::ofstream(path) << text;
    expect_done(session, command::Open{.path = path});
    std::filesystem::remove(path);
}

TEST(SymmetricQuads, TwoSquaresRefineAsEachOthersImage) {
    Session session;
    open_text(session,
              "v -1 0 0\nv 0 0 0\nv 1 0 0\nv -1 2 0\nv 0 1 0\nv 1 2 0\n"
              "f 1 2 5 4\nf 2 3 6 5\n");
    expect_done(session, command::Symmetry{.plane = Plane::x});
    expect_done(session, command::Brush{.radius = 1.0});
    expect_done(session, Drag{.moves = {{{0.5, 0.5, 0}, {0.5, 0.5, 0.5}}}});
    EXPECT_GT(session.mesh().face_count(), 50u);
    EXPECT_EQ(faces_without_image(session), 0u);
}

TEST(SymmetricQuads, TheTorusTheCylinderAndTheGridsStaySymmetricInEachAxis) {
    struct Case {
        Shape shape;
        Vec3 from, to;
    };
    const Case cases[] = {{{Shape::Kind::torus, 16}, {0.7, 0.39, 0.7}, {0.8, 0.8, 0.8}},
                          {{Shape::Kind::cylinder, 8}, {0.6, 0.5, 0.8}, {0.9, 0.7, 1.2}},
                          {{Shape::Kind::cube, 8}, {1, 0.5, 0.4}, {1.5, 0.6, 0.6}},
                          {{Shape::Kind::plane, 16}, {0.5, 0, 0.4}, {0.5, 0.4, 0.4}}};
    const Plane planes[] = {Plane::x, Plane::y, Plane::z};
    for (const Case& c : cases) {
        for (int axis = 0; axis < 3; ++axis) {
            if (c.shape.kind == Shape::Kind::plane && axis == 1) continue;  // it lies in y = 0
            Session session;
            expect_done(session, c.shape);
            EXPECT_EQ(faces_without_image(session, axis), 0u) << "before the drag";
            const auto faces = session.mesh().face_count();
            expect_done(session, command::Symmetry{.plane = planes[axis]});
            expect_done(session, command::Brush{.radius = 0.5});
            // Refined by angles alone, since the border of the zone crosses the faces of the cube.
            expect_done(session,
                        command::Adapt{.theta_max = Setting::of(12.0), .l_max = Setting::off()});
            expect_done(session, Drag{.moves = {{c.from, c.to}}});
            EXPECT_GT(session.mesh().face_count(), faces + 20);
            EXPECT_EQ(faces_without_image(session, axis), 0u)
                << "shape " << static_cast<int>(c.shape.kind) << ", axis " << axis;
        }
    }
}

// A grid of quads over x >= 0 with random heights, and its mirror image, whose faces begin with any
// corner. The coordinates are exact, or rounded as in a file.
std::string mirrored_grid(test::Random& random) {
    const int columns = random.integer(2, 5), rows = random.integer(2, 6);
    const bool is_regular = random.chance(0.3), mirrors_order = random.chance(0.5);
    const auto rounded = [](double x) { return std::round(x * 1e6) * 1e-6; };
    std::string text;
    std::vector<Vec3> points;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            Vec3 p{i * 0.5, j * 0.5, 0.0};
            if (!is_regular) {
                p += 0.15 * random.direction();
                if (i == 0) p.x = 0.0;
            }
            points.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
        }
    }
    const auto count = static_cast<int>(points.size());
    for (const double side : {1.0, -1.0}) {
        for (const Vec3& p : points) {
            text += "v " + std::to_string(side * p.x) + ' ' + std::to_string(p.y) + ' ' +
                    std::to_string(p.z) + '\n';
        }
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i + 1;
            std::vector<int> quad{a, a + 1, a + columns + 2, a + columns + 1};
            const auto add = [&](bool image) {
                std::vector<int> face = quad;
                for (int& v : face) {
                    if (image && (v - 1) % (columns + 1) != 0) v += count;
                }
                if (image) std::reverse(face.begin(), face.end());
                if (!mirrors_order) {
                    std::rotate(face.begin(), face.begin() + random.integer(0, 3), face.end());
                }
                text += "f";
                for (int v : face) text += ' ' + std::to_string(v);
                text += '\n';
            };
            add(false);
            add(true);
        }
    }
    return text;
}

TEST(SymmetricQuads, TwoHundredMirroredMeshesStaySymmetricWhateverTheirFacesBeginWith) {
    const int cases = test::case_count(200);
    int refined = 0;
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed " + std::to_string(7000 + i));
        test::Random random(static_cast<std::uint64_t>(7000 + i));
        Session session;
        open_text(session, mirrored_grid(random));
        const auto faces = session.mesh().face_count();
        expect_done(session, command::Symmetry{.plane = Plane::x});
        expect_done(session, command::Brush{.radius = random.uniform(0.4, 1.2)});
        const auto base = session.mesh().base_vertex_count();
        const Vec3 from = session.mesh().position(
            VertexId{static_cast<std::uint32_t>(random.integer(0, static_cast<int>(base) - 1))});
        Vec3 to = from + random.uniform(0.1, 0.4) * random.direction();
        if (from.x == 0.0 || from.x * to.x < 0.0) to.x = from.x;
        expect_done(session, Drag{.moves = {{from, to}}});
        refined += session.mesh().face_count() > faces ? 1 : 0;
        ASSERT_EQ(faces_without_image(session), 0u);
        ASSERT_EQ(session.mesh().validate(), std::vector<std::string>{});
    }
    EXPECT_GT(refined, cases / 2);
}

}  // namespace
}  // namespace pectin
