// Seams whose faces meet without sharing vertices are joined in the mesh and separated in a save.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "mesh/unshared_vertices.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::edge_between;
using test::Random;

const std::vector<std::string> kValid;

// Two sheets that meet along x = 0, each with its own vertices there.
const std::string kHinge =
    "v -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 0 -1 0\nv 1 -1 -1\nv 1 1 -1\nv 0 1 0\n"
    "f 1 2 3 4\nf 5 6 7 8\n";

BuiltMesh build(const std::string& obj) { return build_mesh(parse_obj(obj, "t.obj")); }

std::size_t vertices_in_use(const IndexedFaceSet& set) {
    std::set<std::uint32_t> used;
    for (const auto& corner : set.corners) used.insert(corner.position);
    return used.size();
}

TEST(UnsharedSeam, IsOneInnerEdgeAndIsReported) {
    const BuiltMesh hinge = build(kHinge);
    EXPECT_EQ(hinge.mesh.validate(), kValid);
    EXPECT_EQ(hinge.report.seams, 1u);
    EXPECT_EQ(hinge.report.seam_edges, 1u);
    EXPECT_EQ(hinge.report.boundary_edges, 6u);
    EXPECT_EQ(hinge.report.isolated_vertices, 0u);
    EXPECT_EQ(hinge.report.nonmanifold_vertices, 0u);
    EXPECT_EQ(hinge.mesh.base_vertex_count(), 8u);
    EXPECT_TRUE(exists(hinge.mesh.twin(hinge.mesh.half_edge(edge_between(hinge.mesh, 1, 2)))));
}

TEST(UnsharedSeam, IsSavedWithItsOwnVerticesOnEachSide) {
    TriMesh mesh = build(kHinge).mesh;
    const IndexedFaceSet untouched = parse_obj(format_obj(mesh), "untouched.obj");
    const IndexedFaceSet input = parse_obj(kHinge, "hinge.obj");
    ASSERT_EQ(untouched.corners.size(), input.corners.size());
    for (std::size_t i = 0; i < input.corners.size(); ++i) {
        EXPECT_EQ(untouched.corners[i].position, input.corners[i].position);
    }
    const Split s = mesh.split(edge_between(mesh, 1, 2));
    mesh.split(s.mc);
    mesh.set_position(s.m, {0.25, 0, 0.5});
    mesh.set_position(VertexId{1}, {0, -1, 0.75});
    const IndexedFaceSet saved = parse_obj(format_obj(mesh), "saved.obj");
    // Eight vertices of the input, and two new ones on each side.
    EXPECT_EQ(saved.positions.size(), 12u);
    EXPECT_EQ(vertices_in_use(saved), 12u);
    EXPECT_EQ(saved.positions[1], (Vec3{0, -1, 0.75}));
    EXPECT_EQ(saved.positions[4], saved.positions[1]);
    EXPECT_EQ(test::open_sides(saved), test::open_edges(mesh));
    const BuiltMesh again = build_mesh(saved);
    EXPECT_EQ(again.report.seams, 1u);
    EXPECT_EQ(again.report.seam_edges, 3u);
    EXPECT_EQ(format_obj(again.mesh), format_obj(mesh));
}

TEST(UnsharedSeam, KeepsZerosOfBothSignsApartUntilTheyMove) {
    TriMesh mesh = build(
                       "v -1 0 0\nv -0 0 0\nv -0 1 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\n"
                       "f 1 2 3\nf 4 5 6\n")
                       .mesh;
    EXPECT_EQ(test::open_edges(mesh), 4u);
    const IndexedFaceSet saved = parse_obj(format_obj(mesh), "saved.obj");
    EXPECT_TRUE(std::signbit(saved.positions[1].x));
    EXPECT_FALSE(std::signbit(saved.positions[4].x));
}

TEST(UnsharedSeam, OfShapesOfSeparateFacetsLeavesThemClosed) {
    Random random(21);
    for (const ShapeKind kind :
         {ShapeKind::sphere, ShapeKind::cube, ShapeKind::torus, ShapeKind::cylinder}) {
        const IndexedFaceSet shared = make_shape(kind, kind == ShapeKind::sphere ? 2 : 4);
        IndexedFaceSet facets = shared;
        test::unshare_vertices(facets, random);
        ASSERT_EQ(facets.positions.size(), facets.corners.size());
        const BuiltMesh whole = build_mesh(shared), joined = build_mesh(facets);
        EXPECT_EQ(joined.mesh.validate(), kValid);
        EXPECT_EQ(test::open_edges(joined.mesh), 0u);
        EXPECT_EQ(joined.report.seams, 1u);
        EXPECT_EQ(joined.report.boundary_edges, 0u);
        EXPECT_EQ(joined.report.isolated_vertices, 0u);
        EXPECT_EQ(test::euler_characteristic(joined.mesh), test::euler_characteristic(whole.mesh));
        EXPECT_EQ(joined.mesh.face_count(), whole.mesh.face_count());
    }
}

TEST(UnsharedSeam, SmoothsNormalsAcrossUpToTheCreaseAngle) {
    Random random(22);
    IndexedFaceSet sphere = make_shape(ShapeKind::sphere, 2);
    sphere.normals.clear();
    for (auto& corner : sphere.corners) corner.normal = IndexedFaceSet::kNoIndex;
    IndexedFaceSet facets = sphere;
    test::unshare_vertices(facets, random);
    for (const double crease_angle : {45.0, 5.0}) {
        const TriMesh whole = build_mesh(sphere, {.crease_angle = crease_angle}).mesh;
        const TriMesh joined = build_mesh(facets, {.crease_angle = crease_angle}).mesh;
        for (std::uint32_t h = 0; h < 3 * whole.face_slots(); ++h) {
            const HalfEdgeId corner{h};
            ASSERT_LT(glm::distance(whole.normal(whole.wedge(corner)),
                                    joined.normal(joined.wedge(corner))),
                      1e-6f)
                << "crease angle " << crease_angle << ", half-edge " << h;
        }
    }
}

TEST(UnsharedSeam, OfThreeSheetsOrOfSheetsThatFaceOppositeWaysIsSplitAtOneVertex) {
    // Three sheets that coincide along one edge, and two sheets that face opposite ways.
    const std::string spine = "v 0 0 0\nv 0 1 0\n";
    const std::string book =
        spine + "v 1 0 0\n" + spine + "v 0 0 1\n" + spine + "v -1 0 0\nf 1 2 3\nf 4 5 6\nf 7 8 9\n";
    const std::string flipped = spine + "v 1 0 0\n" + spine + "v -1 0 0\nf 1 2 3\nf 4 5 6\n";
    for (const std::string& text : {book, flipped}) {
        BuiltMesh built = build(text);
        EXPECT_EQ(built.mesh.validate(), kValid);
        EXPECT_EQ(built.report.nonmanifold_edges, 0u) << "the file has none";
        EXPECT_EQ(built.report.misoriented_edges, 0u);
        EXPECT_EQ(built.report.nonmanifold_vertices, 0u);
        EXPECT_EQ(built.report.seams, 1u);
        const auto faces = built.mesh.face_count();
        const TriMesh before = built.mesh;
        const Split s = built.mesh.split(edge_between(built.mesh, 0, 1));
        EXPECT_EQ(built.mesh.face_count(), 2 * faces);
        EXPECT_EQ(built.mesh.validate(), kValid);
        const IndexedFaceSet saved = parse_obj(format_obj(built.mesh), "saved.obj");
        EXPECT_EQ(vertices_in_use(saved), 4 * faces);
        EXPECT_EQ(test::open_sides(saved), test::open_edges(built.mesh));
        const auto star = built.mesh.removable(s.m);
        ASSERT_TRUE(star.has_value());
        const TriMesh::RollbackScope scope(built.mesh, before.slot_counts());
        built.mesh.unsplit(*star);
        EXPECT_TRUE(built.mesh == before);
    }
}

// A ridge of two faces that share its edge, and a wall on it with vertices of its own.
const std::string kWall =
    "v 0 0 0\nv 0 1 0\nv 1 0 -1\nv -1 0 -1\nv 0 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 5 6 7\n";

TEST(UnsharedSeam, JoinsABoundaryToAnInnerEdge) {
    BuiltMesh built = build(kWall);
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.report.seams, 1u);
    EXPECT_EQ(built.report.seam_edges, 1u);
    EXPECT_EQ(built.report.nonmanifold_edges, 0u) << "the file has none";
    EXPECT_EQ(built.report.nonmanifold_vertices, 0u);
    EXPECT_EQ(built.report.boundary_edges, 6u);
    const TriMesh before = built.mesh;
    EXPECT_EQ(format_obj(build_mesh(parse_obj(format_obj(before), "t.obj")).mesh),
              format_obj(before));
    const Split s = built.mesh.split(edge_between(built.mesh, 0, 1));
    EXPECT_EQ(built.mesh.face_count(), 6u);
    EXPECT_EQ(built.mesh.validate(), kValid);
    const std::string text = format_obj(built.mesh);
    const IndexedFaceSet saved = parse_obj(text, "saved.obj");
    // The ridge keeps one vertex at the middle, the wall gets one of its own.
    EXPECT_EQ(vertices_in_use(saved), 9u);
    EXPECT_EQ(test::open_sides(saved), test::open_edges(built.mesh));
    EXPECT_EQ(format_obj(build_mesh(saved).mesh), text);
    const auto star = built.mesh.removable(s.m);
    ASSERT_TRUE(star.has_value());
    const TriMesh::RollbackScope scope(built.mesh, before.slot_counts());
    built.mesh.unsplit(*star);
    EXPECT_TRUE(built.mesh == before);
}

TEST(UnsharedSeam, JoinsAWallInsideAClosedSurface) {
    // No vertex of the octahedron is on a boundary; the wall's four sides lie on its edges.
    const std::string text =
        "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
        "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n"
        "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\nf 7 8 9 10\n";
    BuiltMesh built = build(text);
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.report.seams, 1u);
    EXPECT_EQ(built.report.seam_edges, 4u);
    EXPECT_EQ(built.report.boundary_edges, 0u);
    built.mesh.split(edge_between(built.mesh, 0, 1));
    EXPECT_EQ(built.mesh.face_count(), 13u);
    EXPECT_EQ(test::open_sides(parse_obj(format_obj(built.mesh), "saved.obj")), 0u);
}

TEST(UnsharedSeam, LeavesClosedSurfacesThatTouchAlongAnEdgeApart) {
    // Two tetrahedra with an edge at the same place, and an open triangle at one of its ends.
    const BuiltMesh built = build(
        "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\n"
        "v 0 0 0\nv 5 5 0\nv 5 6 0\n"
        "f 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\nf 5 7 6\nf 5 8 7\nf 5 6 8\nf 6 7 8\nf 9 10 11\n");
    EXPECT_EQ(built.report.seams, 0u);
    EXPECT_TRUE(built.mesh.input_form().seams.is_empty());
}

// Triangles that stand on sides of random polygons, with vertices of their own.
void add_walls(IndexedFaceSet& set, Random& random, int count) {
    const auto polygons = static_cast<int>(set.polygon_count());
    while (count-- > 0) {
        const auto p = static_cast<std::size_t>(random.integer(0, polygons - 1));
        const std::uint32_t begin = set.polygon_begin(p), size = set.polygon_end[p] - begin;
        const auto k = static_cast<std::uint32_t>(random.integer(0, static_cast<int>(size) - 1));
        const Vec3 a = set.positions[set.corners[begin + k].position];
        const Vec3 b = set.positions[set.corners[begin + (k + 1) % size].position];
        for (const Vec3& point : {a, b, 1.2 * (a + b) + 0.1 * random.direction()}) {
            IndexedFaceSet::Corner corner;
            corner.position = static_cast<std::uint32_t>(set.positions.size());
            set.corners.push_back(corner);
            set.positions.push_back(point);
        }
        set.polygon_end.push_back(static_cast<std::uint32_t>(set.corners.size()));
        set.polygon_part.push_back(0);
    }
}

TEST(UnsharedSeam, SheetsThatShareVerticesOnOneSideStillDoInASave) {
    // Three sheets that share the vertices of one edge, and a fourth with its own vertices there.
    TriMesh mesh = build(
                       "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nv 0 0 0\nv 0 1 0\nv 0 0 -1\n"
                       "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 6 7 8\n")
                       .mesh;
    EXPECT_EQ(mesh.validate(), kValid);
    mesh.split(edge_between(mesh, 0, 1));
    EXPECT_EQ(mesh.face_count(), 8u);
    const IndexedFaceSet saved = parse_obj(format_obj(mesh), "saved.obj");
    EXPECT_EQ(saved.positions.size(), 10u);
    EXPECT_EQ(vertices_in_use(saved), 10u);
}

TEST(UnsharedSeam, NeverMakesAFaceLoseAnEdge) {
    // A triangle with two corners at one position, next to another with the same edges.
    const BuiltMesh built = build(
        "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
        "f 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.mesh.face_count(), 2u);
}

TEST(UnsharedSeam, IsJoinedBesideAFacetWithoutArea) {
    // Facets with two corners at one position between others, as some exporters write them.
    Random random(25);
    IndexedFaceSet set = make_shape(ShapeKind::sphere, 1);
    test::unshare_vertices(set, random);
    for (const std::uint32_t polygon : {0u, 17u}) {
        const std::uint32_t first = set.polygon_begin(polygon);
        for (const std::uint32_t corner : {first, first, first + 1}) {
            set.positions.push_back(Vec3{set.positions[set.corners[corner].position]});
            IndexedFaceSet::Corner copy = set.corners[corner];
            copy.position = static_cast<std::uint32_t>(set.positions.size() - 1);
            set.corners.push_back(copy);
        }
        set.polygon_end.push_back(static_cast<std::uint32_t>(set.corners.size()));
        set.polygon_part.push_back(0);
    }
    const BuiltMesh built = build_mesh(set);
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(test::open_edges(built.mesh), 6u) << "those of the two facets";
}

TEST(UnsharedSeam, DoesNotJoinPointsAlone) {
    const BuiltMesh built = build(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv -1 0 0\nv 0 -1 0\n"
        "f 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(built.report.seams, 0u);
    EXPECT_TRUE(built.mesh.input_form().seams.is_empty());
}

TEST(UnsharedSeam, CountsConnectedRuns) {
    // Two separate seams.
    std::string text = kHinge;
    for (const char* v :
         {"-2 5 0", "0 5 0", "0 7 0", "-2 7 0", "0 5 0", "1 5 -1", "1 7 -1", "0 7 0"}) {
        text += std::string("v ") + v + '\n';
    }
    const BuiltMesh built = build(text + "f 9 10 11 12\nf 13 14 15 16\n");
    EXPECT_EQ(built.report.seams, 2u);
    EXPECT_EQ(built.report.seam_edges, 2u);
}

// Gives each polygon its own colour.
void add_colors_by_polygon(IndexedFaceSet& set, Random& random) {
    set.colors.assign(set.positions.size(), Vec3f{0.0f});
    for (std::size_t p = 0; p < set.polygon_count(); ++p) {
        const Vec3f color{static_cast<float>(random.integer(0, 255)) / 255.0f, 0.5f, 0.25f};
        for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end[p]; ++c) {
            set.colors[set.corners[c].position] = color;
        }
    }
}

TEST(UnsharedSeam, KeepsTheColoursOfEachSide) {
    Random random(24);
    for (int i = 0; i < 20; ++i) {
        IndexedFaceSet set = make_shape(ShapeKind::cube, 2);
        test::unshare_vertices(set, random);
        add_colors_by_polygon(set, random);
        set.parts.clear();  // one part per polygon identifies its pieces in the save
        for (std::uint32_t p = 0; p < set.polygon_count(); ++p) {
            set.parts.push_back({.object = "", .group = "g" + std::to_string(p), .material = ""});
            set.polygon_part[p] = p;
        }
        TriMesh mesh = build_mesh(set).mesh;
        for (int k = 0; k < 80; ++k) {
            const auto edges = test::live_edges(mesh);
            mesh.split(edges[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(edges.size()) - 1))]);
        }
        for (const std::string& text : {format_obj(mesh), format_obj(mesh.baked())}) {
            const IndexedFaceSet saved = parse_obj(text, "saved.obj");
            ASSERT_EQ(saved.colors.size(), saved.positions.size());
            for (std::size_t p = 0; p < saved.polygon_count(); ++p) {
                const std::string& group = saved.parts[saved.polygon_part[p]].group;
                const auto from = static_cast<std::size_t>(std::stoi(group.substr(1)));
                const std::uint32_t v = set.corners[set.polygon_begin(from)].position;
                for (std::uint32_t c = saved.polygon_begin(p); c < saved.polygon_end[p]; ++c) {
                    ASSERT_EQ(saved.colors[saved.corners[c].position], set.colors[v]);
                }
            }
        }
    }
}

TEST(UnsharedSeam, IsKeptByABakeToTheByte) {
    Random random(23);
    for (int i = 0; i < test::case_count(40); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        IndexedFaceSet set = make_shape(ShapeKind::cube, random.integer(1, 3));
        test::unshare_vertices(set, random, random.chance(0.5) ? 1.0 : 0.5 * random.integer(0, 1));
        if (random.chance(0.5)) add_walls(set, random, random.integer(1, 5));
        if (random.chance(0.5)) add_colors_by_polygon(set, random);
        TriMesh mesh = build_mesh(set).mesh;
        for (int pass = 0; pass < 2; ++pass) {
            for (int k = random.integer(0, 60); k > 0; --k) {
                const auto edges = test::live_edges(mesh);
                const Split s = mesh.split(edges[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(edges.size()) - 1))]);
                mesh.set_position(s.m, mesh.position(s.m) + 0.02 * random.direction());
            }
            ASSERT_EQ(mesh.validate(), kValid);
            const std::string text = format_obj(mesh);
            ASSERT_EQ(test::open_sides(parse_obj(text, "t.obj")), test::open_edges(mesh));
            ASSERT_EQ(format_obj(build_mesh(parse_obj(text, "t.obj")).mesh), text);
            TriMesh baked = mesh.baked();
            ASSERT_EQ(baked.validate(), kValid);
            ASSERT_EQ(format_obj(baked), text);
            ASSERT_EQ(baked.vertex_slots(),
                      mesh.vertex_count() + UnsharedVertices(mesh).added().size());
            mesh = std::move(baked);
        }
    }
}

}  // namespace
}  // namespace pectin
