// Tests that invalid optional attributes are dropped and the rest of the file is read.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct Read {
    IndexedFaceSet faces;
    ReadReport report;
};

Read read(const std::string& text) {
    Read result;
    result.faces = parse_obj(text, "t.obj", {}, {}, &result.report);
    return result;
}

std::string refusal(const std::string& text) {
    try {
        parse_obj(text, "t.obj");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DroppedAttributes, AreThoseThatTheFileDoesNotHave) {
    const Read r = read(kTriangle + "f 1/1/1 2/2/1 3/3/1\nl 1/1 2\n");
    for (const auto& corner : r.faces.corners) {
        EXPECT_EQ(corner.uv, kNoIndex);
        EXPECT_EQ(corner.normal, kNoIndex);
    }
    EXPECT_EQ(r.faces.element_corners[0].uv, kNoIndex);
    EXPECT_EQ(r.report.missing_uvs, (ReadFinding{4, 4}));
    EXPECT_EQ(r.report.missing_normals, (ReadFinding{3, 4}));
    const TriMesh mesh = build_mesh(r.faces).mesh;
    EXPECT_FALSE(mesh.has_uvs());
    EXPECT_EQ(mesh.normal(mesh.wedge(HalfEdgeId{0})), Vec3f(0, 0, 1)) << "that of the face";
}

TEST(DroppedAttributes, AreOnlyThoseOutOfRange) {
    const Read r = read(kTriangle +
                        "vt 0.5 0.25\nvn 0 0 -1\nf 1/1/1 2/2/2 3/-1/-1\nf 1/-2/-2 2/0/0 3/1/1\n"
                        "f 1/99999999999/1 2/-99999999999/1 3/1/99999999999\nf 1/3 2 3\nvt 1 1\n");
    const std::vector<std::uint32_t> uvs = {0,        1,        0, kNoIndex, kNoIndex, 0,
                                            kNoIndex, kNoIndex, 0, kNoIndex, kNoIndex, kNoIndex};
    const std::vector<std::uint32_t> normals = {0, kNoIndex, 0,        kNoIndex, kNoIndex, 0, 0,
                                                0, kNoIndex, kNoIndex, kNoIndex, kNoIndex};
    ASSERT_EQ(r.faces.corners.size(), uvs.size());
    for (std::size_t i = 0; i < uvs.size(); ++i) {
        EXPECT_EQ(r.faces.corners[i].uv, uvs[i]) << i;
        EXPECT_EQ(r.faces.corners[i].normal, normals[i]) << i;
    }
    EXPECT_EQ(r.report.missing_uvs, (ReadFinding{5, 7}));
    EXPECT_EQ(r.report.missing_normals, (ReadFinding{4, 6}));
}

TEST(DroppedAttributes, AreThoseThatAreNotFiniteAndOtherIndicesStayValid) {
    const Read r = read(kTriangle +
                        "vt nan 0\nvt 0.5 0.5\nvt\nvt a b\nvt 1e39 0\nvt 0 0 inf\n"
                        "vn nan nan nan\nvn 0 0 2\nvn 0 0\nvn 0 0 x\nvn 0 0 0\nvn inf 0 0\n"
                        "f 1/1/1 2/2/2 3/3/3\nf 1/4/4 2/5/5 3/6/6\n");
    const std::vector<std::uint32_t> uvs = {kNoIndex, 1, kNoIndex, kNoIndex, kNoIndex, 5};
    for (std::size_t i = 0; i < uvs.size(); ++i) EXPECT_EQ(r.faces.corners[i].uv, uvs[i]) << i;
    EXPECT_EQ(r.faces.uvs[1], Vec2f(0.5f, 0.5f));
    EXPECT_EQ(r.faces.corners[1].normal, 1u);
    for (std::size_t i : {0u, 2u, 3u, 4u, 5u}) EXPECT_EQ(r.faces.corners[i].normal, kNoIndex) << i;
    EXPECT_EQ(r.report.undefined_uvs, (ReadFinding{4, 4}));
    EXPECT_EQ(r.report.undefined_normals, (ReadFinding{5, 10}));
    for (const Vec2f& uv : r.faces.uvs) EXPECT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
}

TEST(DroppedAttributes, AreNotReportedIfNoCornerUsesThem) {
    const Read r = read(kTriangle + "vt nan nan\nvn 0 0 0\nf 1 2 3\n");
    EXPECT_EQ(r.report, ReadReport{});
}

TEST(DroppedColors, AreOnlyThoseThatAreNotFinite) {
    const Read r = read(
        "v 0 0 0 1 0 0\nv 1 0 0 nan nan nan\nv 0 1 0 1 inf 0\nv 1 1 0 1 1e39 0\n"
        "v 2 2 2 0 1 0\nv 3 3 3 1 1 x\nv 4 4 4 nan\nv 5 5 5 0 0 1 nan\nf 1 2 3\n");
    ASSERT_EQ(r.faces.colors.size(), 8u);
    EXPECT_EQ(r.faces.colors[0], Vec3f(1, 0, 0));
    EXPECT_EQ(r.faces.colors[4], Vec3f(0, 1, 0));
    EXPECT_EQ(r.faces.colors[7], Vec3f(0, 0, 1)) << "a fourth number is ignored, whatever it is";
    for (std::size_t v : {1u, 2u, 3u, 5u, 6u}) EXPECT_TRUE(std::isnan(r.faces.colors[v].x)) << v;
    EXPECT_EQ(r.report.undefined_colors, (ReadFinding{5, 2}));
    EXPECT_TRUE(read("v 0 0 0 nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").faces.colors.empty());
}

TEST(DroppedStatements, HaveNoCornersOrAnUnknownKeyword) {
    const Read r = read(kTriangle + "f\nf 1 2 3\nl\np # 1\nf # 1 2 3\nF 1 2 3\nvp 1 2\nF 3 2 1\n");
    EXPECT_EQ(r.faces.polygon_count(), 1u);
    EXPECT_EQ(r.report.empty_statements, (ReadFinding{4, 4}));
    EXPECT_EQ(r.report.unknown_statements, (ReadFinding{2, 9}));
    EXPECT_EQ(r.report.unknown_keyword, "F");
    EXPECT_EQ(r.report.likely_keyword, "f");
}

TEST(DroppedStatements, HaveNoKeywordOfTheFormat) {
    const Read r = read(kTriangle +
                        "cstype bezier\ndeg 3\nsurf 0 1 0 1 1 2\nparm u 0 1\nend\nmg 0\nlod 1\n"
                        "shadow_obj x\nusemap off\nbevel on\nc_interp on\nf 1 2 3\n");
    EXPECT_EQ(r.report, ReadReport{});
}

TEST(InvalidPositions, AreRefusedWithTheirLine) {
    EXPECT_EQ(refusal(kTriangle + "f 1/1/1 2/2/2 4/3/3\n"),
              "t.obj:4: vertex 4 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "v nan 0 0 1 1 1\nf 1 2 3\n"),
              "t.obj:4: 'nan' is not a finite number");
    EXPECT_EQ(refusal(kTriangle + "f 0/1 1/1 2/1\n"),
              "t.obj:4: '0/1' has an index 0; they count from 1");
}

TEST(MisspeltKeywords, AreReportedIfTheFileHasNoFaces) {
    EXPECT_EQ(refusal("V 0 0 0\nV 1 0 0\nV 0 1 0\nFace 1 2 3\n"),
              "t.obj: holds no faces; 'V' in line 1 should be 'v'; 'Face' in line 4 should be 'f'");
    EXPECT_EQ(refusal("hello world\n"),
              "t.obj: holds no faces; 'hello' in line 1 is no OBJ keyword");
    EXPECT_EQ(refusal(kTriangle),
              "t.obj: holds no faces; a model has f statements of 3 corners or more");
    EXPECT_EQ(refusal(""), "t.obj: holds no faces; it is empty");
}

// A file with random attributes opens if its positions are valid. The saved file opens without a
// report and is saved with the same bytes.
TEST(DroppedAttributes, AreNotReportedAgainAfterSaving) {
    constexpr std::uint32_t kSeed = 17;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random(kSeed);
    const auto pick = [&](std::vector<std::string> of) { return of[random() % of.size()]; };
    const std::vector<std::string> numbers = {"0", "1", "-0.5", "nan", "inf", "x", "1e39", "1e-60"};
    const std::vector<std::string> indices = {"", "0", "1", "2", "7", "-1", "-9", "99999999999"};
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (int v = 0; v < 5; ++v) {
            text += "v " + std::to_string(random() % 3) + " " + std::to_string(random() % 3) + " 0";
            for (auto n = random() % 5; n > 0; --n) text += " " + pick(numbers);
            text += "\n";
        }
        for (auto n = random() % 4; n > 0; --n)
            text += "vt " + pick(numbers) + " " + pick(numbers) + "\n";
        for (auto n = random() % 4; n > 0; --n) {
            text += "vn " + pick(numbers) + " " + pick(numbers) + " " + pick(numbers) + "\n";
        }
        for (int f = 0; f < 3; ++f) {
            text += "f";
            for (auto n = 1 + random() % 4; n > 0; --n) {
                text += " " + std::to_string(1 + random() % 5) + "/" + pick(indices) + "/" +
                        pick(indices);
            }
            text += "\n";
        }
        const std::string saved = format_obj(build_mesh(read(text).faces).mesh);
        const Read again = read(saved);
        ASSERT_EQ(again.report, ReadReport{}) << text << "saved as\n" << saved;
        ASSERT_EQ(saved.find("nan"), saved.npos) << saved;
        ASSERT_EQ(saved.find("vn 0 0 0\n"), saved.npos) << saved;
        ASSERT_EQ(format_obj(build_mesh(again.faces).mesh), saved) << text;
    }
}

}  // namespace
}  // namespace pectin
