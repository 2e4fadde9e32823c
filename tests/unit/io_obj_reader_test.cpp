#include "io/obj_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "io/file_error.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

using Indices = std::vector<std::uint32_t>;

IndexedFaceSet parse(const std::string& text) { return parse_obj(text, "t.obj"); }

// The message of the refusal, with its place in front.
std::string refusal(const std::string& text) {
    try {
        parse(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

std::vector<std::uint32_t> position_indices(const IndexedFaceSet& faces) {
    std::vector<std::uint32_t> indices;
    for (const auto& corner : faces.corners) indices.push_back(corner.position);
    return indices;
}

TEST(ReadObj, ReadsPositionsNormalsUvsAndPolygons) {
    const IndexedFaceSet f = parse(kTriangle +
                                   "v 1 1 0\nvt 0.5 0.25\nvn 0 0 2\n"
                                   "f 1/1/1 2//1 4/1 3\n");
    ASSERT_EQ(f.polygon_count(), 1u);
    EXPECT_EQ(position_indices(f), (Indices{0, 1, 3, 2}));
    EXPECT_EQ(f.positions[3], (Vec3{1, 1, 0}));
    EXPECT_EQ(f.uvs, std::vector<Vec2f>{Vec2f(0.5f, 0.25f)});
    EXPECT_EQ(f.normals, std::vector<Vec3f>{Vec3f(0, 0, 1)});
    EXPECT_EQ(f.corners[0].uv, 0u);
    EXPECT_EQ(f.corners[0].normal, 0u);
    EXPECT_EQ(f.corners[1].uv, kNoIndex);
    EXPECT_EQ(f.corners[1].normal, 0u);
    EXPECT_EQ(f.corners[2].uv, 0u);
    EXPECT_EQ(f.corners[2].normal, kNoIndex);
    EXPECT_EQ(f.corners[3].uv, kNoIndex);
    EXPECT_EQ(f.parts, std::vector<Part>{Part{}});
    EXPECT_EQ(f.polygon_part, Indices{0});
}

TEST(ReadObj, ReadsEveryKindOfLine) {
    const char* texts[] = {
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
        "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "# c \\\n\tv\t0  0\t0 \n  v 1 0 0\t# one\n\n \t \nv 0 1 0\n f  1 2 3 # last\n",
        "v 0 \\\n0 \\\r\n0\nv 1 0 0\nv 0 1 0\nf 1\\\n2 3 \\",
        "v +0 -0 0e5\nv 1. .0 0\nv 0 +1e0 0\nvp 1 2\ncurv 0 1\n\x80\xFF junk\nf 1/ 2// 3/ # 4\n",
    };
    for (const char* text : texts) {
        const IndexedFaceSet f = parse(text);
        EXPECT_EQ(f.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
        EXPECT_EQ(position_indices(f), (Indices{0, 1, 2})) << text;
    }
}

TEST(ReadObj, AcceptsAFourthCoordinateColoursAndAThirdTextureCoordinate) {
    const IndexedFaceSet f =
        parse("v 0 0 0 1\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0\nvt 1\nvt 1 2 3\nf 1/1 2/2 3/2\n");
    EXPECT_EQ(f.positions[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(f.uvs, (std::vector<Vec2f>{Vec2f(1, 0), Vec2f(1, 2)}));
}

TEST(ReadObj, FollowsRelativeAndForwardIndices) {
    EXPECT_EQ(position_indices(parse(kTriangle + "f -3 -2 -1\nv 5 5 5\nf -1 -4 2")),
              (Indices{0, 1, 2, 3, 0, 1}));
    const IndexedFaceSet f = parse("f 1/1/1 2/1/1 3/1/1\n" + kTriangle + "vt 0 0\nvn 0 0 1");
    EXPECT_EQ(position_indices(f), (Indices{0, 1, 2}));
    EXPECT_EQ(f.corners[2].normal, 0u);
}

TEST(ReadObj, ReadsPolygonsOfAnySize) {
    std::string text, face = "f";
    for (int i = 1; i <= 600; ++i) {
        text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
        face += " " + std::to_string(i);
    }
    const IndexedFaceSet f = parse(text + face + "\nf 1 2 3\n");
    EXPECT_EQ(f.polygon_end, (Indices{600, 603}));
    EXPECT_EQ(f.corners[599].position, 599u);
}

TEST(ReadObj, LeavesOutFacesWithoutSurfaceButKeepsRepeatedVertices) {
    const IndexedFaceSet f = parse(kTriangle + "f\nf 1\nf 1 2\nl 0 0\np x\nf 1 1 2\nf 3 2 1");
    EXPECT_EQ(position_indices(f), (Indices{0, 0, 1, 2, 1, 0}));
    EXPECT_EQ(f.polygon_count(), 2u);
}

TEST(ReadObj, KeepsObjectGroupMaterialAndSmoothingGroupApart) {
    const IndexedFaceSet f =
        parse("mtllib my first.mtl\n" + kTriangle +
              "f 1 2 3\no Big Thing\ng  left\tupper \nusemtl red metal # 2\ns 3\nf 1 2 3\n"
              "usemtl never used\nusemtl blue\ns off\nf 1 2 3\nf 1 2 3\ng\nusemtl\no\nf 1 2 3\n"
              "o Big Thing\ng left upper\ns 3\nusemtl red metal # 2\nf 1 2 3\nmtllib second.mtl\n");
    EXPECT_EQ(f.material_libraries, (std::vector<std::string>{"my first.mtl", "second.mtl"}));
    EXPECT_EQ(f.parts, (std::vector<Part>{{"", "", "", 0},
                                          {"Big Thing", "left upper", "red metal # 2", 3},
                                          {"Big Thing", "left upper", "blue", 0}}));
    EXPECT_EQ(f.polygon_part, (Indices{0, 1, 2, 2, 0, 1}));
}

TEST(ReadObj, TakesAnythingButANumberForNoSmoothing) {
    const IndexedFaceSet f = parse(kTriangle +
                                   "s on\nf 1 2 3\ns off\nf 1 2 3\ns 4294967295\nf 1 2 3\n"
                                   "s 0\nf 1 2 3\ns -1\nf 1 2 3\ns 99999999999\nf 1 2 3\n");
    EXPECT_EQ(f.polygon_part, (Indices{0, 1, 2, 1, 1, 1}));
    EXPECT_EQ(f.parts[0].smoothing_group, 1u);
    EXPECT_EQ(f.parts[2].smoothing_group, 4294967295u);
}

TEST(ReadObj, MakesNormalsUnitWhateverTheirLength) {
    const IndexedFaceSet f = parse(kTriangle +
                                   "vn 3 0 4\nvn 0 0 0\nvn 0 1e300 0\nvn 1e-320 0 0\n"
                                   "vn 1e-400 0 0\nf 1 2 3\n");
    EXPECT_EQ(f.normals[0], Vec3f(0.6, 0.0, 0.8));
    EXPECT_EQ(f.normals[1], Vec3f(0.0f));
    EXPECT_EQ(f.normals[2], Vec3f(0, 1, 0));
    EXPECT_EQ(f.normals[3], Vec3f(1, 0, 0));
    EXPECT_EQ(f.normals[4], Vec3f(0.0f));
}

TEST(ReadObj, RoundsToTheNearestNumber) {
    const IndexedFaceSet f = parse(
        "v 0.1 1e-400 5e-324\nv 9007199254740993 0.30000000000000004 -1e-999\n"
        "v 123456789.123456789 1.7976931348623157e308 2.2250738585072011e-308\n"
        "vt 0.1 16777217\nvt 1e-50 0.000000000000000000000000000000000000000000000000001\n"
        "f 1 2 3\n");
    EXPECT_EQ(f.positions[0], (Vec3{0.1, 0.0, 5e-324}));
    EXPECT_EQ(f.positions[1], (Vec3{9007199254740992.0, 0.1 + 0.2, -0.0}));
    EXPECT_TRUE(std::signbit(f.positions[1].z));
    EXPECT_EQ(f.positions[2],
              (Vec3{123456789.123456789, 1.7976931348623157e308, 2.2250738585072011e-308}));
    EXPECT_EQ(f.uvs[0], Vec2f(0.1f, 16777216.0f));
    EXPECT_EQ(f.uvs[1], Vec2f(0.0f));
}

TEST(ReadObj, NamesTheLineOfABadNumber) {
    EXPECT_EQ(refusal("v 1,5 2 3\n"),
              "t.obj:1: '1,5' is no number; numbers look like -1.5 or 2e-3");
    EXPECT_EQ(refusal(kTriangle + "v 1 2\n"), "t.obj:4: 'v' needs 3 numbers, here are 2");
    EXPECT_EQ(refusal("\r\n\r\nv\r\n"), "t.obj:3: 'v' needs 3 numbers, here are 0");
    EXPECT_EQ(refusal("\rv nan 0 0"), "t.obj:2: 'nan' is not a finite number");
    EXPECT_EQ(refusal("v 0 -inf 0"), "t.obj:1: '-inf' is not a finite number");
    EXPECT_EQ(refusal("v 0 0 1e400"), "t.obj:1: '1e400' is too large a number");
    EXPECT_EQ(refusal("v 0 0 1e99999999999"), "t.obj:1: '1e99999999999' is too large a number");
    EXPECT_EQ(refusal("vt 1e39 0"), "t.obj:1: '1e39' is too large a number");
    const char* wrong[] = {"v 0 0 0 nan", "v 0 0 0 1 1 x", "v 0x1 0 0", "v 1e 0 0", "v - 0 0",
                           "v +-1 0 0",   "v 1..2 0 0",    "vn 0 0",    "vn 0 0 a", "vt",
                           "vt 0 0 inf",  "v 1 2 3e"};
    for (const char* line : wrong) {
        EXPECT_TRUE(refusal(kTriangle + line + "\nf 1 2 3").starts_with("t.obj:4: ")) << line;
    }
    EXPECT_TRUE(refusal("v 0 0 \\\n 0\n\nv 0 \\\n x 0").starts_with("t.obj:4: "));
}

TEST(ReadObj, NamesTheLineOfABadIndex) {
    EXPECT_EQ(refusal(kTriangle + "f 1 2 4\nf 1 2 9\n"),
              "t.obj:4: vertex 4 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 3\nf 1 2 -4\n"),
              "t.obj:5: vertex -4 does not exist; up to here are 3");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 0"), "t.obj:4: '0' has an index 0; they count from 1");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 3/1"),
              "t.obj:4: texture coordinate 1 does not exist; the file has 0");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 9\nf 1//1 2 3"),
              "t.obj:4: vertex 9 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "f 1//1 2 3\nf 1 2 9"),
              "t.obj:4: normal 1 does not exist; the file has 0");
    EXPECT_EQ(refusal(kTriangle + "f 5 2 3\nf 4 2 3\nf 1 2 9\nv 0 0 0\nv 0 0 0"),
              "t.obj:6: vertex 9 does not exist; the file has 5");
    const char* wrong[] = {
        "f 1 2 x",    "f 1 2 3.5", "f 1 2 3/1/1/1",        "f 1/2 /1 3", "f 1 2 3,",
        "f 1 2 3/0",  "f 1 2 -",   "f 1 2 4294967297",     "f 1 2 3//x", "f 1 2 +3",
        "f 1 2 3/-1", "f a b",     "f 1 2 99999999999999", "f 1 2 3\v4"};
    for (const char* line : wrong) {
        EXPECT_TRUE(refusal(kTriangle + line).starts_with("t.obj:4: ")) << line;
    }
}

TEST(ReadObj, RefusesTextWithoutFaces) {
    for (const std::string& text : {std::string(), kTriangle, kTriangle + "f 1 2\n",
                                    std::string("\0\0\xFF\xFE", 4), std::string("\\")}) {
        EXPECT_TRUE(refusal(text).starts_with("t.obj: holds no faces; ")) << text;
    }
    EXPECT_THROW(read_obj("/nowhere/at/all.obj"), FileError);
}

TEST(ReadObj, IgnoresOrRefusesBinaryJunkButNeverFails) {
    std::mt19937 random(1);
    const std::string alphabet("v f01/-#\\\n\r\t\0gonst.e\xC3", 22);
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = i % 2 == 0 ? kTriangle : "";
        const auto size = random() % 60;
        for (std::uint32_t k = 0; k < size; ++k) text += alphabet[random() % alphabet.size()];
        if (i % 4 == 0) text += "\nf 1 2 3";
        if (refusal(text) == "accepted") ++accepted;
    }
    EXPECT_GT(accepted, 100);
    std::string text = kTriangle + "f 1 2 3\nf 1 2";
    text.push_back('\0');
    EXPECT_TRUE(refusal(text + " 3").starts_with("t.obj:5: "));
}

TEST(ReadObj, RefusesNamesThatWouldFillTheMemory) {
    EXPECT_TRUE(refusal("o " + std::string(5000, 'x')).starts_with("t.obj:1: the name is longer"));
}

}  // namespace
}  // namespace pectin
