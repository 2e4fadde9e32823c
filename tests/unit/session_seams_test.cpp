// Sheets whose vertices coincide along a seam but are not shared. Drags move and refine them
// together, and a save writes them unshared.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/shapes.h"
#include "session/input_summary.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using command::Drag;

const std::string kHinge =
    "v -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 0 -1 0\nv 1 -1 -1\nv 1 1 -1\nv 0 1 0\n"
    "f 1 2 3 4\nf 5 6 7 8\n";

using test::expect_done;

void open_text(Session& session, const std::string& text) {
    const std::string path = testing::TempDir() + "session_seams.obj";
    std::ofstream(path) << text;
    expect_done(session, command::Open{.path = path});
    std::filesystem::remove(path);
}

IndexedFaceSet saved(const Session& session) {
    return parse_obj(format_obj(session.mesh()), "saved.obj");
}

// The distinct vertices on x = 0 that polygons on this side use.
std::vector<std::uint32_t> seam_vertices(const IndexedFaceSet& set, bool left) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t p = 0; p < set.polygon_count(); ++p) {
        double sum = 0.0;
        for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end[p]; ++c) {
            sum += set.positions[set.corners[c].position].x;
        }
        if ((sum < 0.0) != left) continue;
        for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end[p]; ++c) {
            const std::uint32_t v = set.corners[c].position;
            if (std::abs(set.positions[v].x) < 1e-12) vertices.push_back(v);
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

TEST(SessionSeams, AHingeDoesNotCrackAndIsSavedUnshared) {
    Session session;
    open_text(session, kHinge);
    EXPECT_EQ(input_summary("hinge.obj", session.input_report()),
              "hinge.obj: opened with repairs: 1 seam of unshared vertices moved together");
    expect_done(session, command::Brush{.radius = 1.2});
    expect_done(session, Drag{.moves = {{{0, 0, 0}, {0, 0, 0.5}}}});
    const IndexedFaceSet set = saved(session);
    const auto left = seam_vertices(set, true), right = seam_vertices(set, false);
    EXPECT_GT(left.size(), 10u);
    ASSERT_EQ(left.size(), right.size());
    for (std::uint32_t v : left) {
        EXPECT_FALSE(std::binary_search(right.begin(), right.end(), v)) << "shared: " << v;
        EXPECT_TRUE(
            std::any_of(right.begin(), right.end(),
                        [&](std::uint32_t w) { return set.positions[v] == set.positions[w]; }))
            << "a crack at vertex " << v;
    }
    EXPECT_EQ(test::open_sides(set), test::open_edges(session.mesh()));
}

TEST(SessionSeams, AWallOnAnInnerEdgeDoesNotCrackOff) {
    Session session;
    open_text(session,
              "v 0 -1 0\nv 0 1 0\nv 1 0 -1\nv -1 0 -1\nv 0 -1 0\nv 0 1 0\nv 0 0 1\n"
              "f 1 3 2\nf 1 2 4\nf 5 6 7\n");
    EXPECT_EQ(input_summary("wall.obj", session.input_report()),
              "wall.obj: opened with repairs: 1 seam of unshared vertices moved together");
    expect_done(session, command::Brush{.radius = 1.2});
    expect_done(session, Drag{.moves = {{{0, 0, 0}, {0.5, 0, 0}}}, .connected = true});
    EXPECT_GT(session.mesh().face_count(), 50u);
    EXPECT_EQ(test::open_sides(saved(session)), test::open_edges(session.mesh()));
    expect_done(session, Drag{.moves = {{{0.5, 0, 0}, {0, 0, 0}}}});
    EXPECT_EQ(test::open_sides(saved(session)), test::open_edges(session.mesh()));
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
}

TEST(SessionSeams, ConnectedDragsReachAcross) {
    Session session;
    open_text(session, kHinge);
    expect_done(session, command::Brush{.radius = 1.2});
    expect_done(session, Drag{.moves = {{{-0.5, 0, 0}, {-0.5, 0, 0.5}}}, .connected = true});
    const IndexedFaceSet set = saved(session);
    EXPECT_EQ(test::open_sides(set), test::open_edges(session.mesh()));
    EXPECT_GT(seam_vertices(set, false).size(), 2u);
    EXPECT_TRUE(std::any_of(set.positions.begin(), set.positions.end(), [](const Vec3& p) {
        return p.x > 0.05 && p.z + p.x > 1e-3;  // above the right sheet's own plane
    })) << "the other sheet has not moved";
}

TEST(SessionSeams, DecimationUndoAndBakeKeepThemClosed) {
    Session session;
    open_text(session, kHinge);
    const std::string opened = format_obj(session.mesh());
    expect_done(session, command::Brush{.radius = 1.2});
    expect_done(session, Drag{.moves = {{{0, 0, 0}, {0, 0, 0.5}}}});
    const auto fine = session.mesh().face_count();
    expect_done(session, Drag{.moves = {{{0, 0, 0.5}, {0, 0, 0.05}}}});
    EXPECT_LT(session.mesh().face_count(), fine);
    EXPECT_EQ(test::open_sides(saved(session)), test::open_edges(session.mesh()));
    const std::string decimated = format_obj(session.mesh());
    expect_done(session, command::Bake{});
    EXPECT_EQ(format_obj(session.mesh()), decimated);
    expect_done(session, Drag{.moves = {{{0, 0, 0.05}, {0, 0.1, 0.7}}}});
    EXPECT_EQ(test::open_sides(saved(session)), test::open_edges(session.mesh()));
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    expect_done(session, command::Undo{.count = 4});
    EXPECT_EQ(format_obj(session.mesh()), opened);
}

TEST(SessionSeams, LineElementsOnThemAreDeformed) {
    Session session;
    open_text(session, kHinge + "l 5 8\n");
    expect_done(session, command::Brush{.radius = 3.0});
    expect_done(session, Drag{.moves = {{{0, 0, 0}, {0, 0, 0.5}}}});
    const IndexedFaceSet set = saved(session);
    ASSERT_EQ(set.element_corners.size(), 2u);
    EXPECT_EQ(set.element_corners[0].position, 4u);
    EXPECT_EQ(set.positions[4], set.positions[1]);
    EXPECT_GT(set.positions[4].z, 0.05);
}

TEST(SessionSeams, AFacetedSphereRefinesLikeASmoothOne) {
    test::Random random(31);
    IndexedFaceSet sphere = make_shape(ShapeKind::sphere, 3);
    const std::string shared = format_obj(build_mesh(sphere).mesh);
    test::unshare_vertices(sphere, random);
    const std::string facets = format_obj(build_mesh(sphere).mesh);
    Session whole, joined;
    open_text(whole, shared);
    open_text(joined, facets);
    for (Session* session : {&whole, &joined}) {
        expect_done(*session, command::Brush{.radius = 0.7});
        expect_done(*session, command::Symmetry{.plane = command::Symmetry::Plane::x});
        expect_done(*session, Drag{.moves = {{{0.6, 0, 0.8}, {1.2, 0.2, 1.7}}}, .fold_free = true});
        EXPECT_EQ(test::faces_without_image(session->mesh(), 0, 1e-7), 0u);
    }
    EXPECT_EQ(joined.mesh().face_count(), whole.mesh().face_count());
    EXPECT_EQ(test::open_sides(saved(joined)), 0u);
    EXPECT_EQ(test::open_edges(joined.mesh()), 0u);
}

}  // namespace
}  // namespace pectin
