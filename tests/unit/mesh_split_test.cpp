// Split and unsplit of every edge of small literal meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <set>

#include "mesh/build_mesh.h"
#include "mesh/mesh_change.h"
#include "mesh/midpoint_normal.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using test::edge_between;
using test::euler_characteristic;
using test::live_edges;
using test::live_faces;
using test::mesh_of;

const std::vector<std::string> kValid;

struct Literal {
    const char* name;
    const char* obj;
};

void operator<<(std::ostream& out, const Literal& literal) { out << literal.name; }

// Each is the smallest mesh with the property that its comment names.
constexpr Literal kSingleTriangle{"single triangle",  // all edges are boundaries
                                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"};
constexpr Literal kTwoTriangles{"two triangles",  // one inner edge, with both ends on the boundary
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.1\nf 1 2 3\nf 3 2 4\n"};
constexpr Literal kTetrahedron{"tetrahedron",  // closed, with an edge between any two vertices
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                               "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"};
constexpr Literal kPillow{"pillow",  // two faces back to back: a and d are one vertex
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"};
constexpr Literal kCube{"cube",  // edges between sides are creases, diagonals are smooth
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n"};
constexpr Literal kSeam{"seam",  // smooth, with a UV seam between two charts
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                        "vt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\nvt 6 5\nvt 6 7\n"
                        "f 1/1 2/2 3/3\nf 3/4 2/5 4/6\n"};
constexpr Literal kHalfCrease{"half-crease",  // the normals differ at vertex 3 only
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\n"
                              "vn 0 0 1\nvn 1 0 0\n"
                              "f 1//1 2//1 3//1\nf 3//2 2//1 4//1\n"};
constexpr Literal kOtherHalfCrease{"other half-crease",  // at vertex 2 only
                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\n"
                                   "vn 0 0 1\nvn 1 0 0\n"
                                   "f 1//1 2//1 3//1\nf 3//1 2//2 4//1\n"};
constexpr Literal kBowTie{"bow-tie",  // two sheets that share one vertex
                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n"};
constexpr Literal kBook{"book",  // three faces at one edge, which is cut
                        "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\n"
                        "f 1 2 3\nf 1 2 4\nf 1 2 5\n"};
constexpr Literal kTurnedPage{"turned page",  // the same with one face reversed
                              "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\n"
                              "f 1 2 3\nf 2 1 4\nf 1 2 5\n"};
constexpr Literal kTwice{"twice",  // two faces on the same vertices: all edges are cut
                         "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n"};
constexpr Literal kHalfTextured{"half textured",  // one face has no texture coordinates
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                "f 1/1 2/2 3/3\nf 3 2 4\n"};

using Corners = std::array<std::uint32_t, 3>;

// Rotates a face so that its smallest vertex comes first; its slot may begin with any corner.
Corners canonical(VertexId a, VertexId b, VertexId c) {
    Corners corners{index(a), index(b), index(c)};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::multiset<Corners> faces_of(const TriMesh& mesh) {
    std::multiset<Corners> faces;
    for (FaceId f : live_faces(mesh)) {
        const HalfEdgeId h = TriMesh::half_edge(f, 0);
        faces.insert(canonical(mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h))));
    }
    return faces;
}

void undo_split(TriMesh& mesh, VertexId m, EdgeId bc) {
    const auto star = mesh.removable(m);
    ASSERT_TRUE(star.has_value());
    EXPECT_EQ(mesh.unsplit(*star), bc);
}

class SplitOf : public testing::TestWithParam<Literal> {
  protected:
    TriMesh mesh() const { return mesh_of(GetParam().obj); }
    template <typename Visit>
    void for_each_split(Visit visit) const {
        const TriMesh whole = mesh();
        for (EdgeId e : live_edges(whole)) {
            SCOPED_TRACE("edge " + std::to_string(index(e)));
            TriMesh split_mesh = whole;
            const Split s = split_mesh.split(e);
            visit(whole, split_mesh, s, whole.representative(e));
        }
    }
};

TEST_P(SplitOf, EveryEdgeIsUndoneToTheByte) {
    for_each_split([](const TriMesh& whole, TriMesh& split_mesh, const Split& s, EdgeId e) {
        EXPECT_EQ(split_mesh.validate(), kValid);
        EXPECT_FALSE(split_mesh == whole);
        TriMesh rolled_back = split_mesh;
        undo_split(split_mesh, s.m, e);
        EXPECT_EQ(split_mesh.validate(), kValid);
        EXPECT_TRUE(test::has_the_faces_of(split_mesh, whole));
        const TriMesh::RollbackScope scope(rolled_back, whole.slot_counts());
        undo_split(rolled_back, s.m, e);
        EXPECT_TRUE(rolled_back == whole);
    });
}

TEST_P(SplitOf, EveryTwoEdgesAreUndoneToTheByte) {
    for_each_split([](const TriMesh& whole, TriMesh& once, const Split& s, EdgeId e) {
        for (EdgeId second : live_edges(once)) {
            SCOPED_TRACE("then edge " + std::to_string(index(second)));
            TriMesh twice = once;
            const Split t = twice.split(second);
            EXPECT_EQ(twice.validate(), kValid);
            const TriMesh::RollbackScope scope(twice, whole.slot_counts());
            undo_split(twice, t.m, once.representative(second));
            EXPECT_EQ(twice.validate(), kValid);
            undo_split(twice, s.m, e);
            EXPECT_TRUE(twice == whole);
        }
    });
}

TEST_P(SplitOf, AnEdgeReplacesItsFacesByTheirHalves) {
    for_each_split([](const TriMesh& whole, const TriMesh& split_mesh, const Split& s, EdgeId e) {
        std::multiset<Corners> expected = faces_of(whole);
        whole.for_each_side(e, [&](HalfEdgeId h) {
            const VertexId b = whole.origin(h), c = whole.target(h);
            const VertexId a = whole.origin(TriMesh::prev(h));
            expected.erase(expected.find(canonical(a, b, c)));
            expected.insert(canonical(a, b, s.m));
            expected.insert(canonical(a, s.m, c));
        });
        EXPECT_EQ(faces_of(split_mesh), expected);
        EXPECT_EQ(euler_characteristic(split_mesh), euler_characteristic(whole));
        EXPECT_NEAR(test::area(split_mesh), test::area(whole), 1e-14);
        EXPECT_EQ(split_mesh.position(s.m), 0.5 * whole.position(s.b) + 0.5 * whole.position(s.c));
        EXPECT_EQ(split_mesh.position(s.a), whole.position(s.a));
    });
}

TEST_P(SplitOf, AnEdgeKeepsPartsAndCornersOfTheFacesItSplits) {
    for_each_split([](const TriMesh& whole, const TriMesh& split_mesh, const Split& s, EdgeId e) {
        const HalfEdgeId bc = whole.half_edge(e);
        EXPECT_EQ(split_mesh.base_face(s.face3), whole.base_face(TriMesh::face(bc)));
        if (s.right) {
            EXPECT_EQ(split_mesh.base_face(s.face4),
                      whole.base_face(TriMesh::face(whole.twin(bc))));
        }
        // Every old wedge is used by pieces of the same base faces as before.
        std::map<std::uint32_t, std::set<std::uint32_t>> before, after;
        const auto collect = [](const TriMesh& mesh, auto& wedges) {
            for (FaceId f : live_faces(mesh)) {
                for (int c = 0; c < 3; ++c) {
                    const HalfEdgeId h = TriMesh::half_edge(f, c);
                    wedges[index(mesh.wedge(h))].insert(index(mesh.base_face(f)));
                }
            }
        };
        collect(whole, before);
        collect(split_mesh, after);
        for (const auto& [wedge, faces] : before) EXPECT_EQ(after[wedge], faces);
    });
}

TEST_P(SplitOf, AnEdgeSetsLevelsOneAboveThoseAround) {
    for_each_split([](const TriMesh& whole, TriMesh& once, const Split& s, EdgeId e) {
        EXPECT_EQ(once.level(s.m), 1);
        for (EdgeId second : live_edges(once)) {
            TriMesh twice = once;
            const int level = twice.level(second);
            const Split t = twice.split(second);
            int highest = std::max(once.level(t.b), once.level(t.c));
            once.for_each_side(second, [&](HalfEdgeId h) {
                highest = std::max(highest, int{once.level(once.origin(TriMesh::prev(h)))});
            });
            EXPECT_EQ(twice.level(t.m), highest + 1);
            EXPECT_EQ(twice.level(t.am), highest + 1);
            if (t.right) {
                EXPECT_EQ(twice.level(t.dm), highest + 1);
            }
            EXPECT_EQ(t.bm, once.representative(second));
            EXPECT_EQ(twice.level(t.bm), level);
            EXPECT_EQ(twice.level(t.mc), level);
        }
        EXPECT_EQ(once.level(e), whole.level(e));
    });
}

TEST_P(SplitOf, AnEdgeSetsTheHalfEdgesThatUnsplitStartsFrom) {
    for_each_split([](const TriMesh& whole, const TriMesh& split_mesh, const Split& s, EdgeId e) {
        const auto star = split_mesh.removable(s.m);
        ASSERT_TRUE(star.has_value());
        EXPECT_EQ(star->mc, TriMesh::half_edge(s.face3, 0));
        EXPECT_EQ(star->bm, whole.half_edge(e));
        EXPECT_EQ(split_mesh.target(star->mc), s.c);
        EXPECT_EQ(split_mesh.origin(star->bm), s.b);
        EXPECT_EQ(star->a, s.a);
        EXPECT_EQ(star->d, s.d);
        EXPECT_EQ(star->on_boundary(), !s.right.has_value());
        EXPECT_EQ(inserted_vertex(split_mesh, e), s.m);
    });
}

TEST_P(SplitOf, AnEdgeMakesOneWedgeIfItIsSmoothAndOtherwiseOnePerSide) {
    for_each_split([](const TriMesh& whole, const TriMesh& split_mesh, const Split& s, EdgeId e) {
        const HalfEdgeId bc = whole.half_edge(e), cb = whole.twin(bc);
        const bool smooth = !exists(cb) || (whole.wedge(bc) == whole.wedge(TriMesh::next(cb)) &&
                                            whole.wedge(cb) == whole.wedge(TriMesh::next(bc)));
        std::uint32_t sides = 0;
        whole.for_each_side(e, [&](HalfEdgeId) { ++sides; });
        EXPECT_EQ(split_mesh.wedge_slots() - whole.wedge_slots(), s.right && smooth ? 1u : sides);
        if (s.right) {
            EXPECT_EQ(s.right->m == s.left.m, smooth);
        }
        const auto expect_mean = [&](const Split::Side& side) {
            const Vec3 sum = Vec3{whole.normal(side.b)} + Vec3{whole.normal(side.c)};
            if (glm::length(sum) < 0.1) return;
            EXPECT_EQ(split_mesh.normal(side.m), Vec3f{glm::normalize(sum)});
            if (!split_mesh.has_uvs() || std::isnan(whole.uv(side.b).x)) return;
            EXPECT_EQ(split_mesh.uv(side.m), 0.5f * (whole.uv(side.b) + whole.uv(side.c)));
        };
        expect_mean(s.left);
        EXPECT_EQ(s.left.b, whole.wedge(bc));
        EXPECT_EQ(s.left.c, whole.wedge(TriMesh::next(bc)));
        if (!s.right) return;
        expect_mean(*s.right);
        EXPECT_EQ(s.right->b, whole.wedge(TriMesh::next(cb)));
        EXPECT_EQ(s.right->c, whole.wedge(cb));
    });
}

TEST_P(SplitOf, AnEdgeSplitsItsSiblingsAtTheSameVertexAndNowhereElse) {
    for_each_split([](const TriMesh&, TriMesh& once, const Split&, EdgeId) {
        for (EdgeId second : live_edges(once)) {
            TriMesh twice = once;
            const Split t = twice.split(second);
            // Each half has as many siblings as the edge had, between the same ends.
            std::size_t sides = 0;
            once.for_each_side(second, [&](HalfEdgeId) { ++sides; });
            std::multiset<VertexId> far_ends;
            for (std::uint32_t i = 0; i < 3 * twice.face_slots(); ++i) {
                const HalfEdgeId h{i};
                if (twice.origin(h) == t.m) far_ends.insert(twice.target(h));
                if (twice.target(h) == t.m) far_ends.insert(twice.origin(h));
            }
            EXPECT_EQ(far_ends.count(t.b), sides);
            EXPECT_EQ(far_ends.count(t.c), sides);
            EXPECT_EQ(far_ends.size(), 4 * sides);
            const auto star = twice.removable(t.m);
            ASSERT_TRUE(star.has_value());
            std::set<FaceId> faces;
            std::size_t sheets = 0;
            twice.for_each_sheet(*star, [&](const Star& sheet) {
                ++sheets;
                EXPECT_EQ(sheet.m, t.m);
                EXPECT_EQ(std::minmax({sheet.b, sheet.c}), std::minmax({t.b, t.c}));
                faces.insert({TriMesh::face(sheet.mc), TriMesh::face(sheet.bm)});
                if (!sheet.on_boundary()) {
                    faces.insert({TriMesh::face(sheet.cm), TriMesh::face(sheet.mb)});
                }
            });
            EXPECT_EQ(faces.size(), 2 * sides);
            EXPECT_EQ(sheets, t.right ? 1u : sides);
        }
    });
}

TEST_P(SplitOf, AnEdgeMarksTheMidpointDeformedIfAnEndIs) {
    for_each_split([](const TriMesh& whole, const TriMesh&, const Split& s, EdgeId e) {
        for (VertexId v : {s.a, s.b, s.c, s.d}) {
            if (!exists(v)) continue;
            TriMesh marked = whole;
            marked.set_deformed(v, true);
            const Split again = marked.split(e);
            EXPECT_EQ(marked.is_deformed(again.m), v == s.b || v == s.c);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(EveryShape, SplitOf,
                         testing::Values(kSingleTriangle, kTwoTriangles, kTetrahedron, kPillow,
                                         kCube, kSeam, kHalfCrease, kOtherHalfCrease, kBowTie,
                                         kBook, kTurnedPage, kTwice, kHalfTextured));

TEST(Split, MakesTwoWedgesAcrossACreaseASeamAndAHalfCreaseOnly) {
    const auto wedges_made = [](const Literal& literal, std::uint32_t v, std::uint32_t w) {
        TriMesh mesh = mesh_of(literal.obj);
        const std::uint32_t before = mesh.wedge_slots();
        mesh.split(edge_between(mesh, v, w));
        return mesh.wedge_slots() - before;
    };
    EXPECT_EQ(wedges_made(kTwoTriangles, 1, 2), 1u);
    EXPECT_EQ(wedges_made(kSeam, 1, 2), 2u);
    EXPECT_EQ(wedges_made(kHalfCrease, 1, 2), 2u);
    EXPECT_EQ(wedges_made(kOtherHalfCrease, 1, 2), 2u);
    EXPECT_EQ(wedges_made(kHalfTextured, 1, 2), 2u);
    EXPECT_EQ(wedges_made(kCube, 0, 1), 2u);  // an edge of the cube
    EXPECT_EQ(wedges_made(kCube, 0, 2), 1u);  // the diagonal of a side
    EXPECT_EQ(wedges_made(kSingleTriangle, 0, 1), 1u);
}

TEST(Split, ReusesFreedIdsSoThatTheSameEditsGiveTheSameBytes) {
    TriMesh mesh = mesh_of(kCube.obj);
    const TriMesh base = mesh;
    const auto split_some = [](TriMesh& m) {
        std::vector<std::pair<VertexId, EdgeId>> made;
        for (std::uint32_t e : {3u, 7u, 3u, 11u, 20u, 0u}) {
            made.emplace_back(m.split(EdgeId{e}).m, EdgeId{e});
        }
        return made;
    };
    const auto made = split_some(mesh);
    const TriMesh once = mesh;
    for (std::size_t i = made.size(); i-- > 0;) undo_split(mesh, made[i].first, made[i].second);
    EXPECT_EQ(mesh.slot_counts(), once.slot_counts());  // slots were freed, not removed
    EXPECT_EQ(split_some(mesh), made);
    EXPECT_TRUE(mesh == once);
}

// Whether a corner of the faces at the edge has the highest level.
bool is_full_around(const TriMesh& mesh, EdgeId e) {
    for (HalfEdgeId h : {mesh.half_edge(e), mesh.twin(mesh.half_edge(e))}) {
        if (!exists(h)) continue;
        for (HalfEdgeId corner : {h, TriMesh::next(h), TriMesh::prev(h)}) {
            if (mesh.level(mesh.origin(corner)) == 65535) return true;
        }
    }
    return false;
}

TEST(Split, IsRefusedWhereTheLevelWouldNotFitSixteenBits) {
    const TriMesh whole = mesh_of(kTetrahedron.obj);
    for (EdgeId first : live_edges(whole)) {
        TriMesh mesh = whole;
        EdgeId e = first;
        for (int level = 1; level <= 65535; ++level) {
            ASSERT_TRUE(mesh.may_split(e));
            const Split s = mesh.split(e);
            ASSERT_EQ(int{mesh.level(s.m)}, level);
            e = level % 2 == 0 ? s.am : s.dm;
        }
        EXPECT_FALSE(mesh.may_split(e));
        for (EdgeId each : live_edges(mesh)) {
            ASSERT_EQ(mesh.may_split(each), !is_full_around(mesh, each));
        }
        EXPECT_EQ(mesh.validate(), kValid);
    }
}

TEST(Unsplit, IsRefusedForBaseVerticesAndStarsThatWereSplitFurther) {
    TriMesh mesh = mesh_of(kTwoTriangles.obj);
    for (std::uint32_t v = 0; v < 4; ++v) EXPECT_FALSE(mesh.removable(VertexId{v}).has_value());
    const Split s = mesh.split(edge_between(mesh, 1, 2));
    EXPECT_TRUE(mesh.removable(s.m).has_value());
    for (EdgeId e : live_edges(mesh)) {
        TriMesh further = mesh;
        const Split t = further.split(e);
        // All faces touch m, so any split gives it a neighbour of a higher level.
        EXPECT_FALSE(further.removable(s.m).has_value()) << index(e);
        EXPECT_TRUE(further.removable(t.m).has_value()) << index(e);
    }
}

TEST(Unsplit, KeepsTheAttributesOfRemainingElements) {
    TriMesh mesh = mesh_of(kHalfCrease.obj);
    const Split s = mesh.split(edge_between(mesh, 1, 2));
    mesh.set_position(VertexId{1}, {7, 8, 9});
    mesh.set_normal(s.left.b, {0, 1, 0});
    mesh.set_deformed(VertexId{2}, true);
    mesh.set_position(s.m, {3, 3, 3});
    mesh.set_normal(s.right->m, {0, 1, 0});
    undo_split(mesh, s.m, s.bm);
    EXPECT_EQ(mesh.position(VertexId{1}), Vec3(7, 8, 9));
    EXPECT_EQ(mesh.normal(s.left.b), Vec3f(0, 1, 0));
    EXPECT_TRUE(mesh.is_deformed(VertexId{2}));
    EXPECT_EQ(mesh.validate(), kValid);
}

TEST(MidpointNormal, IsTheNormalisedSumOfItsEnds) {
    const Vec3f x{1, 0, 0}, y{0, 1, 0};
    EXPECT_EQ(midpoint_normal(x, x, {0, 0, 5}), x);
    const Vec3f n = midpoint_normal(x, y, {0, 0, 5});
    EXPECT_NEAR(n.x, std::sqrt(0.5), 1e-7);
    EXPECT_EQ(n.x, n.y);
    EXPECT_EQ(n.z, 0.0f);
}

TEST(MidpointNormal, TakesTheFaceNormalWhereTheEndsOpposeEachOther) {
    const Vec3f up{0, 0, 1}, down{0, 0, -1};
    EXPECT_EQ(midpoint_normal(up, down, {0, 3, 0}), Vec3f(0, 1, 0));
    EXPECT_EQ(midpoint_normal(up, down, {0, 0, 0}), Vec3f(0.0f));
    EXPECT_EQ(midpoint_normal({}, {}, {0, 3, 0}), Vec3f(0, 1, 0));
    EXPECT_EQ(midpoint_normal({}, up, {0, 3, 0}), up);
    // Normals at `angle` to each other have a sum of length 2 cos(angle / 2), which is less than
    // 0.1 beyond 174.27 degrees.
    const auto rotated = [](double degrees) {
        const double a = degrees * 3.14159265358979 / 180.0;
        return Vec3f{Vec3{std::sin(a), 0.0, std::cos(a)}};
    };
    EXPECT_EQ(midpoint_normal(up, rotated(174.2), {0, 1, 0}).y, 0.0f);
    const Vec3f helped = midpoint_normal(up, rotated(174.3), {0, 1, 0});
    EXPECT_NEAR(helped.y, 1.0 / std::hypot(1.0, 2.0 * std::cos(87.15 * 3.14159265 / 180)), 1e-5);
}

TEST(Split, AddsTheFaceNormalOfItsOwnSideWhereEndNormalsCancel) {
    // Opposed normals at the ends of edge 2-3. The faces' normals are along +z and along +x + z.
    TriMesh mesh = mesh_of(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0.5 -1\nvn 0 1 0\nvn 0 -1 0\nvt 0 0\nvt 1 1\n"
        "f 1/1/1 2/1/1 3/1/2\nf 3/2/2 2/2/1 4/2/1\n");
    const Split s = mesh.split(edge_between(mesh, 1, 2));
    ASSERT_TRUE(s.right && s.right->m != s.left.m);
    const auto face_normal = [&](FaceId f) { return Vec3f{glm::normalize(mesh.area_normal(f))}; };
    EXPECT_NEAR(glm::distance(mesh.normal(s.left.m), face_normal(s.face3)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(mesh.normal(s.right->m), face_normal(s.face4)), 0.0f, 1e-6f);
    EXPECT_GT(glm::distance(mesh.normal(s.left.m), mesh.normal(s.right->m)), 0.5f);
}

}  // namespace
}  // namespace pectin
