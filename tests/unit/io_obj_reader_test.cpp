#include "io/obj_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

using Indices = std::vector<std::uint32_t>;

IndexedFaceSet parse(const std::string& text) { return parse_obj(text, "t.obj"); }

// The error message, which begins with the path and line.
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

TEST(ReadObj, ReadsThreeNumbersAfterTheCoordinatesAsAColour) {
    const IndexedFaceSet f = parse(
        "v 0 0 0 1\nv 1 0 0 0.1 0.2 1e-50\nv 0 1 0\nv 1 1 1 9 9\nv 2 2 2 1 0.5 0 0.25\n"
        "v 3 3 3 7e40\nf 1 2 3\n");
    EXPECT_EQ(f.positions[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(f.positions[4], (Vec3{2, 2, 2}));
    ASSERT_EQ(f.colors.size(), f.positions.size());
    EXPECT_EQ(f.colors[1], Vec3f(0.1f, 0.2f, 0.0f));
    EXPECT_EQ(f.colors[4], Vec3f(1.0f, 0.5f, 0.0f));
    for (std::size_t v : {0u, 2u, 3u, 5u}) {
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(f.colors[v][i])) << v;
    }
    EXPECT_TRUE(parse(kTriangle + "v 1 1 1 1\nf 1 2 3\n").colors.empty());
}

TEST(ReadObj, IgnoresAThirdTextureCoordinate) {
    const IndexedFaceSet f = parse(kTriangle + "vt 1\nvt 1 2 3\nf 1/1 2/2 3/2\n");
    EXPECT_EQ(f.uvs, (std::vector<Vec2f>{Vec2f(1, 0), Vec2f(1, 2)}));
}

TEST(ReadObj, ResolvesRelativeAndForwardIndices) {
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

TEST(ReadObj, KeepsFacesWithoutSurfaceAndRepeatedVertices) {
    const IndexedFaceSet f = parse(kTriangle + "f\nf 1\nf 1 2\nf 1 1 2\nf # none\nf 3 2 1 3");
    EXPECT_EQ(position_indices(f), (Indices{0, 0, 1, 0, 0, 1, 2, 1, 0, 2}));
    EXPECT_EQ(f.polygon_end, (Indices{1, 3, 6, 10}));
}

TEST(ReadObj, KeepsThePositionsOfLinesAndPointsInTheFile) {
    using Kind = IndexedFaceSet::Element::Kind;
    const IndexedFaceSet f = parse(kTriangle +
                                   "vt 0 0\np 3\ng wire\nl 1 2/1 -1\nl\nf 1 2 3\nf 1 2 3\n"
                                   "g dots\np 1 2 # 3\nl 5 1\nv 9 9 9\nv 8 8 8\n");
    ASSERT_EQ(f.elements.size(), 4u);
    const Kind kinds[] = {Kind::points, Kind::line, Kind::points, Kind::line};
    const Indices before = {0, 0, 2, 2}, parts = {0, 1, 2, 2}, ends = {1, 4, 6, 8};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(f.elements[i].kind, kinds[i]) << i;
        EXPECT_EQ(f.elements[i].before_polygon, before[i]) << i;
        EXPECT_EQ(f.elements[i].part, parts[i]) << i;
        EXPECT_EQ(f.elements[i].corners_end, ends[i]) << i;
    }
    EXPECT_EQ(f.parts, (std::vector<Part>{{}, {"", "wire", "", 0}, {"", "dots", "", 0}}));
    EXPECT_EQ(f.polygon_part, (Indices{1, 1}));
    Indices positions, uvs;
    for (const auto& corner : f.element_corners) {
        positions.push_back(corner.position);
        uvs.push_back(corner.uv);
    }
    EXPECT_EQ(positions, (Indices{2, 0, 1, 2, 0, 1, 4, 0}));
    EXPECT_EQ(uvs[2], 0u);
    EXPECT_EQ(std::count(uvs.begin(), uvs.end(), kNoIndex), 7);
}

TEST(ReadObj, ChecksTheIndicesOfLinesAndPointsLikeThoseOfFaces) {
    EXPECT_EQ(refusal(kTriangle + "l 0 1"), "t.obj:4: '0' has an index 0; they count from 1");
    EXPECT_EQ(refusal(kTriangle + "p x"),
              "t.obj:4: 'x' is no corner; corners look like 1, 1/2, 1//3 or 1/2/3");
    EXPECT_EQ(refusal(kTriangle + "p 1\nl 1 -4\nf 1 2 3"),
              "t.obj:5: vertex -4 does not exist; up to here are 3");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 3\np 4\n"),
              "t.obj:5: vertex 4 does not exist; the file has 3");
}

TEST(ReadObj, KeepsObjectGroupMaterialAndSmoothingGroupSeparately) {
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

TEST(ReadObj, ReadsAnythingButANumberAsNoSmoothing) {
    const IndexedFaceSet f = parse(kTriangle +
                                   "s on\nf 1 2 3\ns off\nf 1 2 3\ns 4294967295\nf 1 2 3\n"
                                   "s 0\nf 1 2 3\ns -1\nf 1 2 3\ns 99999999999\nf 1 2 3\n");
    EXPECT_EQ(f.polygon_part, (Indices{0, 1, 2, 1, 1, 1}));
    EXPECT_EQ(f.parts[0].smoothing_group, 1u);
    EXPECT_EQ(f.parts[2].smoothing_group, 4294967295u);
}

TEST(ReadObj, NormalisesNormalsOfAnyLength) {
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
    EXPECT_EQ(refusal(kTriangle + "v 1\n"), "t.obj:4: 'v' needs 3 numbers, here is 1");
    EXPECT_EQ(refusal("v 0 0 0\nf -1 -1 -2\n"),
              "t.obj:2: vertex -2 does not exist; up to here is 1");
    EXPECT_EQ(refusal("\r\n\r\nv\r\n"), "t.obj:3: 'v' needs 3 numbers, here are 0");
    EXPECT_EQ(refusal("\rv nan 0 0"), "t.obj:2: 'nan' is not a finite number");
    EXPECT_EQ(refusal("v 0 -inf 0"), "t.obj:1: '-inf' is not a finite number");
    EXPECT_EQ(refusal("v 0 0 1e400"), "t.obj:1: '1e400' is too large a number");
    EXPECT_EQ(refusal("v 0 0 1e99999999999"), "t.obj:1: '1e99999999999' is too large a number");
    const char* wrong[] = {"v 0x1 0 0", "v 1e 0 0",   "v - 0 0",
                           "v +-1 0 0", "v 1..2 0 0", "v 1 2 3e"};
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
    EXPECT_EQ(refusal(kTriangle + "f 1 2 9\nf 1//1 2 3"),
              "t.obj:4: vertex 9 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "f 1//1 2 3\nf 1 2 9"),
              "t.obj:5: vertex 9 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "f 5 2 3\nf 4 2 3\nf 1 2 9\nv 0 0 0\nv 0 0 0"),
              "t.obj:6: vertex 9 does not exist; the file has 5");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 2147483647"),
              "t.obj:4: vertex 2147483647 does not exist; the file has 3");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 -2147483648"),
              "t.obj:4: vertex -2147483648 does not exist; up to here are 3");
    EXPECT_EQ(refusal(kTriangle + "f 1 2 2147483648"),
              "t.obj:4: '2147483648' has an index that is too large");
    const char* wrong[] = {
        "f 1 2 x",   "f 1 2 3.5",  "f 1 2 3/1/1/1",       "f 1/2 /1 3", "f 1 2 3,",
        "f 1 2 3/x", "f 1 2 -",    "f 1 2 4294967297",    "f 1 2 3//x", "f 1 2 +3",
        "f a b",     "f 1 2 3\v4", "f 1 2 99999999999999"};
    for (const char* line : wrong) {
        EXPECT_TRUE(refusal(kTriangle + line).starts_with("t.obj:4: ")) << line;
    }
}

TEST(ReadObj, RefusesTextWithoutFaces) {
    for (const std::string& text : {std::string(), kTriangle, kTriangle + "f\np 1\nl 1 2\n",
                                    std::string("\0\0\xFF\xFE", 4), std::string("\\")}) {
        EXPECT_TRUE(refusal(text).starts_with("t.obj: holds no faces; ")) << text;
    }
    EXPECT_THROW(read_obj("/nowhere/at/all.obj"), FileError);
}

TEST(ReadObj, IgnoresOrRefusesBinaryJunk) {
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

TEST(ReadObj, RefusesCombinationsOfLongNamesThatWouldFillTheMemory) {
    EXPECT_TRUE(refusal("o " + std::string(5000, 'x')).starts_with("t.obj:1: the name is longer"));
    // Each short line of 12 bytes needs a copy of a name of 4 KB.
    std::string text = kTriangle + "o " + std::string(4000, 'x') + "\n";
    for (int i = 1; i <= 1000; ++i) text += "s " + std::to_string(i) + "\nf 1 2 3\n";
    const std::string message = refusal(text);
    EXPECT_NE(message.find("too many combinations of long object, group"), message.npos) << message;
}

TEST(ReadObj, KeepsManyPartsWithNamesOfOrdinaryLength) {
    std::string text = kTriangle;
    for (int i = 0; i < 20000; ++i) text += "g group" + std::to_string(i) + "\nf 1 2 3\n";
    const IndexedFaceSet f = parse(text);
    ASSERT_EQ(f.parts.size(), 20000u);
    EXPECT_EQ(f.parts[19999].group, "group19999");
    EXPECT_EQ(f.polygon_part[19999], 19999u);
}

TEST(ReadObj, RefusesMoreElementsThanTheIdsOfAMeshAllow) {
    const auto message = [](const std::string& text, const ObjLimits& limits) -> std::string {
        try {
            parse_obj(text, "t.obj", {}, limits);
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    };
    const std::string text = kTriangle + "f 1 2\nf 1 2 3\nf 1 2 3 1 2\n";
    EXPECT_EQ(message(text, {.triangles = 4}), "accepted");
    EXPECT_EQ(message(text, {.triangles = 3}),
              "t.obj:6: more than 3 triangles up to here; split the model into several files");
    EXPECT_EQ(message(text, {.bytes = text.size()}), "accepted");
    EXPECT_EQ(message(std::string(1 << 20, '\n') + text, {.bytes = 1 << 20}),
              "t.obj: is larger than 1 MB");
    EXPECT_LT(3u * std::uint64_t{ObjLimits{}.triangles}, std::uint64_t{1} << 31);
}

// A text long enough for many reports of progress.
std::string long_text() {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "v 1.5 2.5 " + std::to_string(i) + "\n";
    return text + "f 1 2 3\n";
}

TEST(ReadObj, ReportsItsProgress) {
    const std::string text = long_text();
    std::vector<double> reports;
    parse_obj(text, "t.obj", Progress({}, [&](double fraction) { reports.push_back(fraction); }));
    EXPECT_GE(reports.size(), text.size() / 70000);
    EXPECT_LE(reports.size(), text.size() / 65536);
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    EXPECT_GT(reports.front(), 0.0);
    EXPECT_GT(reports.back(), 0.9);
    EXPECT_LE(reports.back(), 1.0);
}

TEST(ReadObj, StopsWhenItIsCancelled) {
    std::stop_source stop;
    int reports = 0;
    const Progress progress(stop.get_token(), [&](double) {
        if (++reports == 3) stop.request_stop();
    });
    EXPECT_THROW(parse_obj(long_text(), "t.obj", progress), Cancelled);
    EXPECT_EQ(reports, 3);
}

TEST(ReadObj, ReportsProgressFromZeroToOneForAFile) {
    const ScratchFolder folder;
    folder.write("long.obj", long_text());
    const std::string path = folder.path("long.obj");
    std::vector<double> reports;
    const IndexedFaceSet f =
        read_obj(path, Progress({}, [&](double fraction) { reports.push_back(fraction); }));
    EXPECT_EQ(f.positions.size(), 100000u);
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    EXPECT_LE(reports.back(), 1.0);

    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(read_obj(path, Progress(stop.get_token(), {})), Cancelled);
}

}  // namespace
}  // namespace pectin
