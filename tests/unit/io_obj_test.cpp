#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "support/paths.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

IndexedFaceSet parse(const std::string& text) { return parse_obj(text, "t.obj"); }

std::vector<std::uint32_t> position_indices(const IndexedFaceSet& faces) {
    std::vector<std::uint32_t> indices;
    for (const auto& corner : faces.corners) indices.push_back(corner.position);
    return indices;
}

TriMesh mesh_of(const std::string& text) { return build_mesh(parse(text)).mesh; }

std::size_t count_of(const std::string& what, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
    return count;
}

// --- Writing

TEST(WriteObj, WritesBytesThatDependOnTheMeshAlone) {
    EXPECT_EQ(format_obj(mesh_of("mtllib a.mtl\nmtllib b c.mtl\nv 0 0 0\nv 9 9 9\nv 1e0 0 0\n"
                                 "v 0 0.10 0\nvt 0 0\nvt 1 0\nvt 0 0\nvn 0 0 1\n"
                                 "o thing\ng a b\nusemtl red\ns 2\n"
                                 "f 1/1/1 3/2/1 4/3/1\n")),
              "mtllib a.mtl\nmtllib b c.mtl\nv 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 0.1 0\n"
              "vt 0 0\nvt 1 0\nvn 0 0 1\no thing\ng a b\nusemtl red\ns 2\n"
              "f 1/1/1 3/2/1 4/1/1\n");
}

TEST(WriteObj, WritesDoublesAndFloatsThatReadBackToTheBit) {
    std::mt19937_64 random(7);
    IndexedFaceSet input;
    input.parts.emplace_back();
    const auto any_double = [&] {
        while (true) {
            const double x = std::bit_cast<double>(random());
            if (std::isfinite(x)) return x;
        }
    };
    const auto any_float = [&] {
        while (true) {
            const float x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            if (std::isfinite(x)) return x;
        }
    };
    for (std::uint32_t i = 0; i < 3000; ++i) {
        input.positions.push_back({any_double(), any_double(), any_double()});
        input.uvs.push_back({any_float(), any_float()});
        std::normal_distribution<double> gauss;
        const Vec3 n{gauss(random), gauss(random), gauss(random)};
        input.normals.push_back(Vec3f(glm::normalize(n)));
        input.corners.push_back({i, i, i});
        if (i % 3 != 2) continue;
        input.polygon_end.push_back(i + 1);
        input.polygon_part.push_back(0);
    }
    const IndexedFaceSet output = parse(format_obj(build_mesh(input).mesh));
    ASSERT_EQ(output.positions.size(), input.positions.size());
    for (std::size_t i = 0; i < input.corners.size(); ++i) {
        const auto& corner = output.corners[i];
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>(output.positions[i][k]),
                      std::bit_cast<std::uint64_t>(input.positions[i][k]));
        }
        EXPECT_EQ(output.normals[corner.normal], input.normals[i]);
        EXPECT_EQ(output.uvs[corner.uv], input.uvs[i]);
    }
}

TEST(WriteObj, WritesNoUvForCornersWithoutOne) {
    const std::string text = format_obj(
        mesh_of(kTriangle + "v 1 1 0\nvt 0.5 0.5\nvn 0 0 1\nf 1/1/1 2//1 3/1/1\nf 2//1 4//1 3//1"));
    EXPECT_NE(text.find("f 1/1/1 2//1 3/1/1\nf 2//1 4//1 3//1\n"), std::string::npos) << text;
    EXPECT_EQ(count_of("vt ", text), 1u);
}

// Other programs shade corners with zero normals black or refuse the file.
TEST(WriteObj, NeverWritesAZeroNormal) {
    const std::string text = format_obj(
        mesh_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nvt 0 0\nf 1 2 4\n"
                "f 1/1 2/1 3/1\nf 1/1 2/1\nf 3 3 1\nf 1 2 3 2\n"));  // only the first face has area
    EXPECT_EQ(count_of("vn ", text), 1u) << text;
    EXPECT_EQ(count_of("vn 0 0 0\n", text), 0u) << text;
    EXPECT_EQ(format_obj(mesh_of(text)), text) << "a save of a save is the same bytes";
}

// The two sides of a doubled face are smooth across their edges, so their normals cancel out.
TEST(WriteObj, WritesFaceNormalsForCornersWhoseNormalsCancelOut) {
    const std::string text = format_obj(mesh_of(kTriangle + "s 1\nf 1 2 3\nf 3 2 1\n"));
    EXPECT_EQ(text, kTriangle + "vn 0 0 1\nvn 0 0 -1\ns 1\nf 1//1 2//1 3//1\nf 3//2 2//2 1//2\n");
    EXPECT_EQ(format_obj(mesh_of(text)), text);
}

TEST(WriteObj, ResetsObjectGroupMaterialAndSmoothing) {
    const std::string faces =
        "f 1//1 2//1 3//1\no a\\ \nf 1//1 2//1 3//1\ng b\nusemtl c\ns 1\nf 1//1 2//1 3//1\n"
        "o\ng\nusemtl\ns off\nf 1//1 2//1 3//1\n";
    const std::string text = format_obj(mesh_of(kTriangle + "vn 0 0 1\n" + faces));
    EXPECT_EQ(text, kTriangle + "vn 0 0 1\n" + faces);
    EXPECT_EQ(format_obj(mesh_of(text)), text);
}

TEST(WriteObj, WritesThePiecesOfAFaceInItsPlace) {
    TriMesh mesh = mesh_of(kTriangle +
                           "v 1 1 1\nv 2 2 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"
                           "o last\nf 3//1 2//1 4//1\n");
    const std::string before = format_obj(mesh);
    const Split split = mesh.split(mesh.edge(TriMesh::half_edge(FaceId{0}, 0)));
    const std::string text = format_obj(mesh);
    EXPECT_NE(text.find("v 2 2 0\nv 0.5 0 0\nvn"), std::string::npos) << text;
    EXPECT_EQ(count_of("f ", text.substr(0, text.find("o last"))), 2u);
    EXPECT_EQ(count_of("f ", text), 3u);
    const auto star = mesh.removable(split.m);
    ASSERT_TRUE(star);
    mesh.unsplit(*star);
    EXPECT_EQ(format_obj(mesh), before);
}

TEST(WriteObj, KeepsExactlyTheUnsplitPolygons) {
    TriMesh cube = build_mesh(make_shape(ShapeKind::cube, 1)).mesh;
    EXPECT_EQ(count_of("f ", format_obj(cube)), 6u);
    const Split split = cube.split(cube.edge(TriMesh::half_edge(FaceId{0}, 0)));
    EXPECT_EQ(count_of("f ", format_obj(cube)), 4u + 6u);  // the split edge belongs to two quads
    cube.unsplit(cube.removable(split.m).value());
    EXPECT_EQ(count_of("f ", format_obj(cube)), 6u);

    // A moved quad stays a polygon even if it is no longer planar.
    cube.set_position(VertexId{0}, 1.25 * cube.position(VertexId{0}));
    EXPECT_EQ(count_of("f ", format_obj(cube)), 6u);
    EXPECT_EQ(build_mesh(parse(format_obj(cube))).mesh.position(VertexId{0}),
              cube.position(VertexId{0}));
}

TEST(WriteObj, KeepsEveryUnsplitPolygonAsItWas) {
    // Concave polygons that start at each corner, a duplicate, a reversed one, one with repeated
    // corners and some without area.
    const std::string text =
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nv 9 9 9\nvn 0 0 1\nvn 0 0 -1\n"
        "f 1//1 2//1 3//1 4//1 5//1\nf 2//1 3//1 4//1 5//1 1//1\nf 3//1 4//1 5//1 1//1 2//1\n"
        "f 4//1 5//1 1//1 2//1 3//1\nf 5//2 4//2 3//2 2//2 1//2\nf 2//1 3//1 4//1 1//1\n"
        "f 1//1 2//1 2//1 3//1 1//1\nf 6//1 6//1 1//1\nf 1//1 2//1\nf 6//1\nf 1//1 2//1 1//1 "
        "3//1\n";
    EXPECT_EQ(format_obj(mesh_of(text)), text);
}

TEST(WriteObj, KeepsTheUvsOfCornersOutsideAllTriangles) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0.125 1\nvt 0.5 0.25\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3//1\nf 1/1/1 2/2/1 2/4/1 3/3/1\n";
    EXPECT_EQ(format_obj(mesh_of(text)), text);
}

TEST(WriteObj, NumbersAttributesInCornerOrderForAnyTriangulation) {
    // An arrowhead, which can only be triangulated with the diagonal from its second to its fourth
    // corner.
    const std::string text =
        "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    EXPECT_EQ(format_obj(mesh_of(text)), text);
}

TEST(WriteObj, ReportsWhatIsWrongWithThePathAndLeavesNoFile) {
    const TriMesh mesh = mesh_of(kTriangle + "f 1 2 3");
    EXPECT_THROW(write_obj(mesh, "/nowhere/at/all.obj"), FileError);
    const ScratchFolder folder;
    write_obj(mesh, folder.path("a.obj"));
    EXPECT_EQ(folder.read("a.obj"), format_obj(mesh));
}

// --- Round trip

// Checks that the saved mesh reads back bit for bit, apart from wedge and polygon numbers.
void expect_same_surface(const TriMesh& a, const TriMesh& b) {
    ASSERT_EQ(a.slot_counts(), b.slot_counts());
    for (std::uint32_t i = 0; i < a.vertex_slots(); ++i) {
        ASSERT_EQ(a.position(VertexId{i}), b.position(VertexId{i}));
    }
    for (std::uint32_t i = 0; i < 3 * a.face_slots(); ++i) {
        const HalfEdgeId h{i};
        ASSERT_EQ(a.origin(h), b.origin(h));
        ASSERT_EQ(a.twin(h), b.twin(h));
        ASSERT_EQ(a.normal(a.wedge(h)), b.normal(b.wedge(h)));
        ASSERT_EQ(a.has_uvs(), b.has_uvs());
        ASSERT_EQ(a.part(TriMesh::face(h)), b.part(TriMesh::face(h)));
        if (!a.has_uvs() || std::isnan(a.uv(a.wedge(h)).x)) continue;
        ASSERT_EQ(a.uv(a.wedge(h)), b.uv(b.wedge(h)));
    }
}

TEST(Obj, ReadsBackTheSameShapes) {
    for (ShapeKind kind : {ShapeKind::sphere, ShapeKind::cube, ShapeKind::plane, ShapeKind::torus,
                           ShapeKind::cylinder}) {
        const IndexedFaceSet shape = make_shape(kind, 3);
        const TriMesh mesh = build_mesh(shape).mesh;
        const std::string text = format_obj(mesh);
        const IndexedFaceSet back = parse(text);
        EXPECT_EQ(back.polygon_end, shape.polygon_end);
        EXPECT_EQ(position_indices(back), position_indices(shape));
        expect_same_surface(mesh, build_mesh(back).mesh);
        EXPECT_EQ(format_obj(build_mesh(back).mesh), text);
    }
}

// Cases that the fuzzer found.
TEST(Obj, SavesTheSameBytesAgain) {
    const std::string texts[] = {
        // A corner of a polygon stays one corner if a non-manifold cut separates its two triangles.
        "v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 5\nf 1 2 3 1 4 5\n",
    };
    for (const std::string& text : texts) {
        const std::string saved = format_obj(mesh_of(text));
        EXPECT_EQ(format_obj(mesh_of(saved)), saved) << text;
    }
}

TEST(Obj, ReadsBackTheSameRealModels) {
    if (!std::filesystem::exists(test::models_folder())) {
        GTEST_SKIP() << "no models in " << test::models_folder() << " (CMake option PECTIN_MODELS)";
    }
    int models = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::models_folder())) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path());
        ++models;
        const IndexedFaceSet input = read_obj(entry.path().string());
        const BuiltMesh built = build_mesh(input);
        const std::string text = format_obj(built.mesh);
        const IndexedFaceSet back = parse(text);
        EXPECT_EQ(back.positions, input.positions);
        EXPECT_EQ(back.polygon_end, input.polygon_end);
        EXPECT_EQ(position_indices(back), position_indices(input));
        EXPECT_EQ(back.polygon_part, input.polygon_part);
        EXPECT_EQ(back.parts, input.parts);
        EXPECT_EQ(back.material_libraries, input.material_libraries);
        expect_same_surface(built.mesh, build_mesh(back).mesh);
        EXPECT_EQ(format_obj(build_mesh(back).mesh), text);
    }
    EXPECT_GT(models, 0);
}

}  // namespace
}  // namespace pectin
