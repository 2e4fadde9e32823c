// build_mesh makes manifold triangles, wedges and normals from polygons of any kind.
#include "mesh/build_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "io/obj_reader.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"
#include "support/paths.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::edge_between;
using test::live_edges;
using test::live_faces;
using test::mesh_of;

const std::vector<std::string> kValid;
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

BuiltMesh build(const std::string& obj, double crease_angle = 45.0) {
    return build_mesh(parse_obj(obj, "t.obj"), {.crease_angle = crease_angle});
}

std::size_t wedges_at(const TriMesh& mesh, std::uint32_t v) {
    std::set<WedgeId> wedges;
    for (FaceId f : live_faces(mesh)) {
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(f, c);
            if (index(mesh.origin(h)) == v) wedges.insert(mesh.wedge(h));
        }
    }
    return wedges.size();
}

std::size_t boundary_edges(const TriMesh& mesh) {
    const auto edges = live_edges(mesh);
    return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](EdgeId e) {
        return !exists(mesh.twin(mesh.half_edge(e)));
    }));
}

Vec3 face_normal(const TriMesh& mesh, FaceId f) { return glm::normalize(mesh.area_normal(f)); }

// Compares all counts, so that a count that should be 0 is tested, too.
std::string text_of(const BuildReport& r) {
    std::string text;
    const auto add = [&text](const char* what, std::uint32_t count) {
        if (count > 0) text += std::to_string(count) + ' ' + what + "; ";
    };
    add("triangulated", r.triangulated_polygons);
    add("crossing", r.crossing_polygons);
    add("degenerate", r.degenerate_polygons);
    add("repeated", r.repeated_corners);
    add("zero-area", r.zero_area_faces);
    add("duplicate", r.duplicate_faces);
    add("non-manifold edges", r.nonmanifold_edges);
    add("misoriented", r.misoriented_edges);
    add("non-manifold vertices", r.nonmanifold_vertices);
    add("seams", r.seams);
    add("seam edges", r.seam_edges);
    add("boundary", r.boundary_edges);
    add("isolated", r.isolated_vertices);
    add("lines", r.lines);
    add("points", r.points);
    return text;
}

void expect_report(const BuildReport& report, const BuildReport& expected) {
    EXPECT_EQ(text_of(report), text_of(expected));
}

// The number of siblings of e, including e.
int siblings_of(const TriMesh& mesh, EdgeId e) {
    int count = 1;
    for (EdgeId s = mesh.sibling(e); s != e; s = mesh.sibling(s)) ++count;
    return count;
}

// --- All shapes and the real models

TEST(BuildMesh, MakesValidMeshesOfAllShapes) {
    for (ShapeKind kind : {ShapeKind::sphere, ShapeKind::cube, ShapeKind::plane, ShapeKind::torus,
                           ShapeKind::cylinder}) {
        for (int resolution : {1, 2, 5}) {
            const IndexedFaceSet shape = make_shape(kind, resolution);
            const BuiltMesh built = build_mesh(shape);
            EXPECT_EQ(built.mesh.validate(), kValid);
            EXPECT_EQ(boundary_edges(built.mesh),
                      kind == ShapeKind::plane ? 4u * static_cast<unsigned>(resolution) : 0u);
            EXPECT_EQ(test::euler_characteristic(built.mesh),
                      kind == ShapeKind::plane ? 1 : (kind == ShapeKind::torus ? 0 : 2));
            BuildReport expected;
            expected.triangulated_polygons = built.report.triangulated_polygons;
            if (kind == ShapeKind::plane)
                expected.boundary_edges = 4u * static_cast<unsigned>(resolution);
            expect_report(built.report, expected);
        }
    }
}

TEST(BuildMesh, MakesValidMeshesOfRealModels) {
    const auto models = test::real_models();
    if (models.empty()) GTEST_SKIP() << "no models in " << test::models_folder();
    for (const std::string& path : models) {
        SCOPED_TRACE(path);
        const IndexedFaceSet input = read_obj(path);
        const TriMesh mesh = build_mesh(input).mesh;
        EXPECT_EQ(mesh.validate(), kValid);
        EXPECT_EQ(mesh.base_vertex_count(), input.positions.size());
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            ASSERT_EQ(mesh.position(VertexId{v}), input.positions[v]);
        }
    }
}

TEST(BuildMesh, MakesAnEmptyMeshOfNothing) {
    const BuiltMesh built = build_mesh({});
    EXPECT_EQ(built.mesh.slot_counts(), SlotCounts{});
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_TRUE(built.mesh.bounding_box().is_empty());
}

// --- Corner normals

TEST(BuildMesh, GivesCornersOfACubeTheNormalOfTheirSide) {
    for (const double angle : {45.0, 89.9}) {
        const TriMesh cube = mesh_of(kCube, angle);
        for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(wedges_at(cube, v), 3u);
        for (FaceId f : live_faces(cube)) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(cube.normal(cube.wedge(TriMesh::half_edge(f, c))),
                          Vec3f{face_normal(cube, f)});
            }
        }
    }
}

TEST(BuildMesh, SmoothsACubeIfTheCreaseAngleAllowsIt) {
    const TriMesh cube = mesh_of(kCube, 90.1);
    for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(wedges_at(cube, v), 1u);
    for (FaceId f : live_faces(cube)) {
        const HalfEdgeId h = TriMesh::half_edge(f, 0);
        // Each side contributes 90 degrees at each corner, however it is triangulated.
        const Vec3 outwards = glm::normalize(cube.position(cube.origin(h)) - 0.5);
        EXPECT_NEAR(glm::distance(Vec3{cube.normal(cube.wedge(h))}, outwards), 0.0, 1e-6);
    }
}

TEST(BuildMesh, WeighsFacesByCornerAngle) {
    // At vertex 1 there are two right angles: one triangle, and an upright quad of two triangles.
    const TriMesh mesh = mesh_of(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0.7 0.7\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 5\n", 95.0);
    const WedgeId w = mesh.wedge(TriMesh::half_edge(FaceId{0}, 0));
    EXPECT_EQ(wedges_at(mesh, 0), 1u);
    EXPECT_NEAR(glm::distance(Vec3{mesh.normal(w)}, glm::normalize(Vec3{1, 0, 1})), 0.0, 1e-6);
}

TEST(BuildMesh, FollowsSmoothingGroupsWhereThereAreAny) {
    const std::string fold = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0.5 1\n";  // a right angle
    EXPECT_EQ(wedges_at(mesh_of(fold + "s 1\nf 1 2 3\nf 3 2 4\n"), 1), 1u);
    EXPECT_EQ(wedges_at(mesh_of(fold + "s 1\nf 1 2 3\ns 2\nf 3 2 4\n", 180.0), 1), 2u);
    EXPECT_EQ(wedges_at(mesh_of(fold + "s 1\nf 1 2 3\ns off\nf 3 2 4\n", 180.0), 1), 2u);
    EXPECT_EQ(wedges_at(mesh_of(fold + "f 1 2 3\nf 3 2 4\n", 180.0), 1), 1u);
    EXPECT_EQ(wedges_at(mesh_of(fold + "f 1 2 3\nf 3 2 4\n", 10.0), 1), 2u);
    // Faces with smoothing off do not form a group.
    EXPECT_EQ(wedges_at(mesh_of(kSquare + "v 2 2 0\ns off\nf 1 2 3\nf 3 2 4\ns 1\nf 4 2 5\n"), 2),
              1u);  // flat: the normals are equal, so there is one wedge
    EXPECT_EQ(wedges_at(mesh_of(fold + "v 9 9 9\ns off\nf 1 2 3\nf 3 2 4\ns 1\nf 4 2 5\n"), 2), 2u);
}

TEST(BuildMesh, KeepsGivenNormalsAndMakesThoseThatAreMissing) {
    const TriMesh mesh = mesh_of(kSquare + "vn 1 0 0\nf 1//1 2//1 3//1\nf 3 2 4\n");
    EXPECT_EQ(mesh.normal(mesh.wedge(TriMesh::half_edge(FaceId{0}, 1))), Vec3f(1, 0, 0));
    EXPECT_EQ(mesh.normal(mesh.wedge(TriMesh::half_edge(FaceId{1}, 1))), Vec3f(0, 0, 1));
    EXPECT_EQ(wedges_at(mesh, 1), 2u);
    EXPECT_EQ(wedges_at(mesh, 0), 1u);
}

TEST(BuildMesh, LeavesNormalsUndefinedAtFacesWithoutArea) {
    const TriMesh line = mesh_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    EXPECT_EQ(line.face_count(), 1u);
    EXPECT_EQ(line.normal(line.wedge(TriMesh::half_edge(FaceId{0}, 0))), Vec3f(0.0f));
    EXPECT_EQ(line.validate(), kValid);
    // Next to a face with a normal they take that normal.
    const TriMesh beside = mesh_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 -1 0\nf 1 2 3\nf 2 1 4\n");
    EXPECT_EQ(beside.normal(beside.wedge(TriMesh::half_edge(FaceId{0}, 0))), Vec3f(0, 0, 1));
}

// --- Wedges

TEST(BuildMesh, MergesCornersOfEqualValuesIntoOneWedge) {
    const TriMesh mesh = mesh_of(kSquare +
                                 "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvt 1 0\nvt 0 1\n"
                                 "vn 0 0 1\nvn 0 0 1\n"
                                 "f 1/1/1 2/2/1 3/3/1\nf 3/6/2 2/5/2 4/4/2\n");
    EXPECT_EQ(mesh.wedge_slots(), 4u);
    EXPECT_EQ(wedges_at(mesh, 1), 1u);
}

TEST(BuildMesh, SeparatesWedgesAlongUvSeams) {
    const TriMesh mesh = mesh_of(kSquare +
                                 "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvt 5 5\n"
                                 "f 1/1 2/2 3/3\nf 3/5 2/2 4/4\n");
    EXPECT_EQ(wedges_at(mesh, 1), 1u);
    EXPECT_EQ(wedges_at(mesh, 2), 2u);
    EXPECT_EQ(mesh.uv(mesh.wedge(TriMesh::half_edge(FaceId{1}, 0))), Vec2f(5, 5));
    EXPECT_TRUE(exists(mesh.twin(mesh.half_edge(edge_between(mesh, 1, 2)))));
}

TEST(BuildMesh, MarksCornersWithoutTextureCoordinatesByNotANumber) {
    const TriMesh mesh = mesh_of(kSquare + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 3 2 4\n");
    EXPECT_TRUE(mesh.has_uvs());
    EXPECT_TRUE(std::isnan(mesh.uv(mesh.wedge(TriMesh::half_edge(FaceId{1}, 0))).x));
    EXPECT_EQ(wedges_at(mesh, 1), 2u);
    EXPECT_EQ(mesh.validate(), kValid);
    EXPECT_FALSE(mesh_of(kSquare + "f 1 2 3\n").has_uvs());
}

TEST(BuildMesh, TellsNegativeZeroFromZeroSoThatASaveGivesBothBack) {
    const TriMesh mesh = mesh_of(kSquare +
                                 "vt 0 0\nvt -0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
                                 "f 1/1 2/3 3/1\nf 3/2 2/3 4/5\n");
    EXPECT_EQ(wedges_at(mesh, 2), 2u);
}

// --- Non-manifold input

TEST(BuildMesh, CutsAnEdgeOfThreeFacesIntoBoundaries) {
    const BuiltMesh book =
        build("v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    EXPECT_EQ(book.mesh.validate(), kValid);
    EXPECT_EQ(book.mesh.edge_count(), 9u);
    EXPECT_EQ(boundary_edges(book.mesh), 9u);
    EXPECT_EQ(book.mesh.vertex_count(), 5u);
    EXPECT_EQ(siblings_of(book.mesh, edge_between(book.mesh, 0, 1)), 3);
    EXPECT_EQ(siblings_of(book.mesh, edge_between(book.mesh, 0, 2)), 1);
    expect_report(book.report,
                  {.nonmanifold_edges = 1, .nonmanifold_vertices = 2, .boundary_edges = 6});
}

TEST(BuildMesh, CutsBetweenFacesThatDisagreeOnTheirSide) {
    const BuiltMesh flipped = build(kSquare + "f 1 2 3\nf 2 3 4\n");
    EXPECT_EQ(flipped.mesh.validate(), kValid);
    EXPECT_EQ(boundary_edges(flipped.mesh), 6u);
    EXPECT_EQ(siblings_of(flipped.mesh, edge_between(flipped.mesh, 1, 2)), 2);
    expect_report(flipped.report,
                  {.misoriented_edges = 1, .nonmanifold_vertices = 2, .boundary_edges = 4});
    EXPECT_EQ(wedges_at(flipped.mesh, 1), 2u);  // one normal up, one down
}

TEST(BuildMesh, KeepsOneVertexWhereTwoSheetsMeetInIt) {
    const BuiltMesh tie =
        build("v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n");
    EXPECT_EQ(tie.mesh.validate(), kValid);
    EXPECT_EQ(tie.mesh.vertex_count(), 5u);
    EXPECT_EQ(tie.mesh.edge_count(), 6u);
    expect_report(tie.report, {.nonmanifold_vertices = 1, .boundary_edges = 6});
}

TEST(BuildMesh, KeepsFacesThatLieOnEachOther) {
    const BuiltMesh twice = build(kSquare + "f 1 2 3\nf 1 2 3\n");
    EXPECT_EQ(twice.mesh.validate(), kValid);
    EXPECT_EQ(twice.mesh.face_count(), 2u);
    expect_report(twice.report, {.duplicate_faces = 1,
                                 .misoriented_edges = 3,
                                 .nonmanifold_vertices = 3,
                                 .isolated_vertices = 1});
    const BuiltMesh pillow = build(kSquare + "f 1 2 3\nf 3 2 1\n");
    EXPECT_EQ(pillow.mesh.validate(), kValid);
    EXPECT_EQ(boundary_edges(pillow.mesh), 0u);
    expect_report(pillow.report, {.isolated_vertices = 1});
}

TEST(BuildMesh, KeepsIsolatedVerticesOutOfTheBoundingBox) {
    const BuiltMesh built = build("v 99 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.mesh.vertex_count(), 4u);
    EXPECT_FALSE(exists(built.mesh.half_edge(VertexId{0})));
    EXPECT_TRUE(built.mesh.is_live(VertexId{0}));
    EXPECT_EQ(built.mesh.bounding_box(), (Box{.min = Vec3{0.0}, .max = {1, 1, 0}}));
    expect_report(built.report, {.boundary_edges = 3, .isolated_vertices = 1});
}

TEST(BuildMesh, KeepsPolygonsOfFewerThanThreeVerticesWithoutFaces) {
    const BuiltMesh built = build(kSquare + "f 1 2 3\nf 1 1 2\nf 2 2 2 2\nf 1 2 1 2\nf 3 2 4\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.mesh.face_count(), 2u);
    expect_report(built.report, {.degenerate_polygons = 3, .boundary_edges = 4});
    ASSERT_EQ(built.mesh.input_form().outlines.size(), 3u);
    EXPECT_EQ(built.mesh.input_form().corners(1).size(), 4u);
    EXPECT_TRUE(built.mesh.input_form().corners(1)[3].is_loose());
    EXPECT_EQ(built.mesh.polygon(FaceId{0}), 0u);
    EXPECT_EQ(built.mesh.polygon(FaceId{1}), 4u);
}

TEST(BuildMesh, DropsRepeatedCornersOfAPolygonAndKeepsTheRest) {
    const BuiltMesh built = build(kSquare + "f 1 2 2 4 3 1\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    EXPECT_EQ(built.mesh.face_count(), 2u);
    EXPECT_NEAR(test::area(built.mesh), 1.0, 1e-15);
    expect_report(built.report,
                  {.triangulated_polygons = 1, .repeated_corners = 1, .boundary_edges = 4});
    // A quad that repeats a vertex is a triangle, which does not count as triangulated.
    expect_report(build(kSquare + "f 1 1 2 4\n").report,
                  {.repeated_corners = 1, .boundary_edges = 3, .isolated_vertices = 1});
}

TEST(BuildMesh, CountsFacesWhoseCornersLieOnALine) {
    const BuiltMesh built = build("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    expect_report(built.report, {.zero_area_faces = 1, .boundary_edges = 4});
}

TEST(BuildMesh, CountsAVertexWhereTwoClosedSheetsMeet) {
    const std::string tetrahedron = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const BuiltMesh built =
        build("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 3\nv 1 0 3\nv 0 0 3\n" + tetrahedron +
              "f 4 5 6\nf 4 6 7\nf 4 7 5\nf 5 7 6\n");
    EXPECT_EQ(built.mesh.validate(), kValid);
    expect_report(built.report, {.nonmanifold_vertices = 1});
}

TEST(BuildMesh, PutsNoCreaseAlongTheDiagonalOfAPolygon) {
    // A quad that is bent by a right angle along its diagonal, with smoothing off.
    const TriMesh mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\ns off\nf 1 2 3 4\n", 5.0);
    EXPECT_EQ(mesh.face_count(), 2u);
    for (std::uint32_t v = 0; v < 4; ++v) EXPECT_EQ(wedges_at(mesh, v), 1u);
}

TEST(BuildMesh, FindsTheWedgesOfAVertexWithManyFaces) {
    // A fan of 5,000 faces around one vertex. All have different normals, except every tenth.
    std::string obj = "v 0 0 0\n";
    constexpr int kFaces = 5000;
    const auto number = [](int i) { return std::to_string(i); };
    for (int i = 0; i <= kFaces; ++i) {
        const double angle = 6.0 * i / kFaces;
        obj +=
            "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
        obj += "vn " + std::to_string(0.01 * (i - i % 10)) + " 0 1\n";
    }
    for (int i = 1; i <= kFaces; ++i) {
        const std::string n = "//" + number(i);
        obj += "f 1" + n + ' ' + number(i + 1) + n + ' ' + number(i + 2) + n + '\n';
    }
    const TriMesh mesh = mesh_of(obj);
    EXPECT_EQ(mesh.validate(), kValid);
    EXPECT_EQ(wedges_at(mesh, 0), static_cast<std::size_t>(kFaces / 10));
}

TEST(BuildMesh, KeepsPartsPolygonsAndMaterialLibraries) {
    const TriMesh mesh =
        mesh_of("mtllib a.mtl\n" + kSquare +
                "v 2 0 0\no thing\ng one\nusemtl red\nf 1 2 4 3\ng two\nf 2 5 4\n");
    EXPECT_EQ(mesh.input_form().material_libraries, std::vector<std::string>{"a.mtl"});
    EXPECT_EQ(mesh.part(FaceId{1}).group, "one");
    EXPECT_EQ(mesh.part(FaceId{2}).group, "two");
    EXPECT_EQ(mesh.part(FaceId{2}).material, "red");
    EXPECT_EQ(mesh.polygon(FaceId{1}), 0u);
    EXPECT_EQ(mesh.polygon(FaceId{2}), 1u);
}

TEST(BuildMesh, PreservesEveryValueOfEveryCorner) {
    for (std::uint64_t seed = 40; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        IndexedFaceSet set = make_shape(ShapeKind::cube, random.integer(1, 4));
        for (int i = 0; i < 5; ++i) {
            set.uvs.emplace_back(static_cast<float>(i / 2), 0.0f);
            set.normals.push_back(Vec3f{random.direction()});
        }
        for (auto& corner : set.corners) {
            if (random.chance(0.8)) corner.uv = static_cast<std::uint32_t>(random.integer(0, 4));
            corner.normal = static_cast<std::uint32_t>(
                random.integer(0, static_cast<int>(set.normals.size()) - 1));
        }
        const TriMesh mesh = build_mesh(set).mesh;
        ASSERT_EQ(mesh.validate(), kValid);
        for (FaceId f : live_faces(mesh)) {
            const std::uint32_t polygon = mesh.polygon(f);
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                bool found = false;
                for (auto k = set.polygon_begin(polygon); k < set.polygon_end[polygon]; ++k) {
                    const auto& corner = set.corners[k];
                    if (corner.position != index(mesh.origin(h))) continue;
                    found = true;
                    EXPECT_EQ(mesh.normal(mesh.wedge(h)), set.normals[corner.normal]);
                    if (corner.uv == IndexedFaceSet::kNoIndex) {
                        EXPECT_TRUE(std::isnan(mesh.uv(mesh.wedge(h)).x));
                    } else {
                        EXPECT_EQ(mesh.uv(mesh.wedge(h)), set.uvs[corner.uv]);
                    }
                }
                EXPECT_TRUE(found);
            }
        }
    }
}

// --- validate() reports invalid attributes

TEST(Validate, ReportsPositionsNormalsAndTextureCoordinatesThatAreNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto said = [](TriMesh mesh, auto spoil) {
        EXPECT_EQ(mesh.validate(), kValid);
        spoil(mesh);
        const auto lines = mesh.validate();
        return lines.empty() ? std::string() : lines.front();
    };
    const TriMesh square = mesh_of(kSquare + "f 1 2 3\nf 3 2 4\n");
    EXPECT_EQ(said(square,
                   [&](TriMesh& m) {
                       m.set_position(VertexId{2}, {0, nan, 0});
                   }),
              "8: position not finite at vertex 2");
    EXPECT_EQ(said(square,
                   [&](TriMesh& m) {
                       m.set_normal(WedgeId{1}, {0, 0, 2});
                   }),
              "8: normal not unit at wedge 1");
    EXPECT_EQ(said(square,
                   [&](TriMesh& m) {
                       m.set_normal(WedgeId{1}, {0, 0, nan});
                   }),
              "8: normal not unit at wedge 1");
    EXPECT_EQ(said(square, [&](TriMesh& m) { m.set_normal(WedgeId{1}, Vec3f{0.0f}); }), "");
    IndexedFaceSet set = parse_obj(kSquare + "vt 0 0\nf 1/1 2/1 3/1\n", "t.obj");
    set.uvs[0].y = std::numeric_limits<float>::infinity();
    ASSERT_FALSE(build_mesh(set).mesh.validate().empty());
    EXPECT_EQ(build_mesh(set).mesh.validate().front(), "8: texture coordinate infinite at wedge 0");
}

TEST(Validate, ReportsFreeSlotsThatWereWrittenTo) {
    TriMesh mesh = mesh_of(kSquare + "f 1 2 3\nf 3 2 4\n");
    const Split s = mesh.split(EdgeId{0});
    mesh.unsplit(*mesh.removable(s.m));
    EXPECT_EQ(mesh.validate(), kValid);
    TriMesh moved = mesh;
    moved.set_position(s.m, {1, 0, 0});
    EXPECT_EQ(moved.validate(), std::vector<std::string>{"1: not cleared at dead vertex 4"});
    TriMesh marked = mesh;
    marked.set_deformed(s.m, true);
    EXPECT_EQ(marked.validate(), std::vector<std::string>{"1: not cleared at dead vertex 4"});
    TriMesh changed = mesh;
    changed.set_normal(s.left.m, {1, 0, 0});
    EXPECT_EQ(changed.validate(), std::vector<std::string>{"1: not cleared at dead wedge 4"});
}

}  // namespace
}  // namespace pectin
