// Compares our OBJ reader with tinyobjloader's: both give the same polygons, corners, numbers and
// names, except for the differences that third_party/README.md lists.
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/read_file.h"
#include "support/paths.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;

struct Peer {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::string warning;
    bool is_read = false;
};

Peer peer_read(const std::string& text) {
    Peer peer;
    std::vector<tinyobj::material_t> materials;
    std::string error;
    std::istringstream stream(text);
    peer.is_read = tinyobj::LoadObj(&peer.attributes, &peer.shapes, &materials, &peer.warning,
                                    &error, &stream, nullptr, /*triangulate=*/false,
                                    /*default_vcols_fallback=*/false);
    return peer;
}

// The peer's numbers are floats with an error of a few units in the last place.
bool is_near(double ours, double theirs) {
    constexpr double kTolerance = 4.0 * std::numeric_limits<float>::epsilon();
    return std::abs(ours - theirs) <= kTolerance * std::max(std::abs(ours), 1e-30);
}

void expect_near(const Vec3& ours, const std::vector<float>& theirs, std::size_t i) {
    for (int k = 0; k < 3; ++k) {
        const double number = double{theirs[3 * i + static_cast<std::size_t>(k)]};
        ASSERT_TRUE(is_near(ours[k], number)) << i << ": " << ours[k] << " and " << number;
    }
}

void expect_same_values(const IndexedFaceSet& ours, const tinyobj::attrib_t& theirs) {
    ASSERT_EQ(3 * ours.positions.size(), theirs.vertices.size());
    for (std::size_t i = 0; i < ours.positions.size(); ++i) {
        expect_near(ours.positions[i], theirs.vertices, i);
    }
    ASSERT_EQ(2 * ours.uvs.size(), theirs.texcoords.size());
    for (std::size_t i = 0; i < ours.uvs.size(); ++i) {
        ASSERT_TRUE(is_near(double{ours.uvs[i].x}, double{theirs.texcoords[2 * i]})) << i;
        ASSERT_TRUE(is_near(double{ours.uvs[i].y}, double{theirs.texcoords[2 * i + 1]})) << i;
    }
    ASSERT_EQ(3 * ours.normals.size(), theirs.normals.size());
    for (std::size_t i = 0; i < ours.normals.size(); ++i) {
        const Vec3 theirs_there{theirs.normals[3 * i], theirs.normals[3 * i + 1],
                                theirs.normals[3 * i + 2]};
        ASSERT_LT(glm::distance(Vec3(ours.normals[i]), theirs_there / glm::length(theirs_there)),
                  1e-6)
            << i << ": ours are unit";
    }
    ASSERT_EQ(3 * ours.colors.size(), theirs.colors.size());
    for (std::size_t i = 0; i < ours.colors.size(); ++i) {
        expect_near(Vec3(ours.colors[i]), theirs.colors, i);
    }
}

int signed_index(std::uint32_t index) { return index == kNoIndex ? -1 : static_cast<int>(index); }

// The peer gives each shape the name of the object or group that was named last.
void expect_same_polygons(const IndexedFaceSet& ours, const Peer& peer) {
    std::size_t polygon = 0;
    for (const tinyobj::shape_t& shape : peer.shapes) {
        std::size_t at = 0;
        for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); ++f, ++polygon) {
            ASSERT_LT(polygon, ours.polygon_count());
            const std::uint32_t begin = ours.polygon_begin(polygon);
            const std::size_t corners = shape.mesh.num_face_vertices[f];
            ASSERT_EQ(ours.polygon_end[polygon] - begin, corners) << "polygon " << polygon;
            for (std::uint32_t c = 0; c < corners; ++c, ++at) {
                const IndexedFaceSet::Corner& corner = ours.corners[begin + c];
                const tinyobj::index_t& theirs = shape.mesh.indices[at];
                ASSERT_EQ(signed_index(corner.position), theirs.vertex_index) << polygon;
                ASSERT_EQ(signed_index(corner.uv), theirs.texcoord_index) << polygon;
                ASSERT_EQ(signed_index(corner.normal), theirs.normal_index) << polygon;
            }
            const Part& part = ours.parts[ours.polygon_part[polygon]];
            ASSERT_EQ(part.smoothing_group, shape.mesh.smoothing_group_ids[f]) << polygon;
            ASSERT_TRUE(shape.name == part.object || shape.name == part.group)
                << shape.name << " is neither " << part.object << " nor " << part.group;
        }
    }
    ASSERT_EQ(polygon, ours.polygon_count());
}

void expect_same(const std::string& text) {
    const IndexedFaceSet ours = parse_obj(text, "t.obj");
    const Peer peer = peer_read(text);
    ASSERT_TRUE(peer.is_read);
    ASSERT_NO_FATAL_FAILURE(expect_same_values(ours, peer.attributes));
    ASSERT_NO_FATAL_FAILURE(expect_same_polygons(ours, peer));
}

TEST(ObjReaderAndItsPeer, ReadRealModelsAlike) {
    if (!std::filesystem::exists(test::models_folder())) {
        GTEST_SKIP() << "no models in " << test::models_folder() << " (CMake option PECTIN_MODELS)";
    }
    int models = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::models_folder())) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path());
        ++models;
        expect_same(read_whole_file(entry.path().string()));
    }
    EXPECT_GT(models, 0);
}

// Generates a file like those of exporters, with all kinds of corners, absolute and relative
// indices, triangles and polygons, groups and smoothing groups.
class GeneratedFile {
  public:
    explicit GeneratedFile(std::uint32_t seed) : random_(seed) {}

    std::string text() {
        const int blocks = pick(1, 4), style = pick(0, 4);
        with_colors_ = pick(0, 2) == 0;
        line_end_ = pick(0, 1) == 0 ? "\n" : "\r\n";
        for (int block = 0; block < blocks; ++block) {
            if (pick(0, 1) == 0)
                line((pick(0, 1) == 0 ? "o block" : "g block") + std::to_string(block));
            for (int i = pick(3, 20); i > 0; --i) add_vertex();
            for (int i = pick(1, 9); i > 0; --i) line("vt " + number() + " " + number()), ++uvs_;
            for (int i = pick(1, 9); i > 0; --i) {
                line("vn " + number() + " " + number() + " " + std::to_string(pick(1, 9))),
                    ++normals_;
            }
            for (int i = pick(1, 20); i > 0; --i) {
                if (pick(0, 5) == 0)
                    line(pick(0, 3) == 0 ? "s off" : "s " + std::to_string(pick(1, 30)));
                if (pick(0, 9) == 0) line("# a comment");
                add_face(style == 4 ? pick(0, 3) : style);
            }
        }
        return text_;
    }

  private:
    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    std::string number() {
        char digits[32];
        const double x = std::uniform_real_distribution(-100.0, 100.0)(random_);
        const char* const formats[] = {"%.6f", "%.3f", "%.9g", "%.0f", "%.4e"};
        std::snprintf(digits, sizeof digits, formats[pick(0, 4)], x);
        return digits;
    }
    void line(const std::string& statement) { text_ += statement + line_end_; }
    void add_vertex() {
        std::string statement = "v " + number() + "  " + number() + "\t" + number();
        for (int i = 0; i < 3 && with_colors_; ++i) {
            statement += " 0." + std::to_string(pick(0, 999999));
        }
        line(statement);
        ++vertices_;
    }
    std::string index(int count) {
        const int i = pick(1, count);
        return std::to_string(pick(0, 1) == 0 ? i : i - count - 1);
    }
    void add_face(int style) {
        std::string statement = "f";
        for (int corners = pick(3, 7); corners > 0; --corners) {
            statement += " " + index(vertices_);
            if (style == 1 || style == 3) statement += "/" + index(uvs_);
            if (style == 2) statement += "/";
            if (style == 2 || style == 3) statement += "/" + index(normals_);
        }
        line(statement);
    }

    std::mt19937 random_;
    std::string text_, line_end_;
    bool with_colors_ = false;
    int vertices_ = 0, uvs_ = 0, normals_ = 0;
};

TEST(ObjReaderAndItsPeer, ReadGeneratedFilesAlike) {
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string text = GeneratedFile(seed).text();
        ASSERT_NO_FATAL_FAILURE(expect_same(text)) << text;
    }
}

// The following tests document the differences. A test is skipped if a version of the peer agrees
// with our reader. It can be removed when all supported versions do.
constexpr const char* kAgrees = "this version of tinyobjloader agrees with us";

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

bool is_refused(const std::string& text) {
    try {
        parse_obj(text, "t.obj");
    } catch (const FileError&) {
        return true;
    }
    return false;
}

TEST(ObjReaderAndItsPeer, DifferInNumbersThatAreNotFinite) {
    for (const char* number : {"nan", "1e400"}) {
        const std::string text = "v " + std::string(number) + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        EXPECT_TRUE(is_refused(text)) << number;
        if (!peer_read(text).is_read) GTEST_SKIP() << kAgrees;
    }
}

TEST(ObjReaderAndItsPeer, DifferInIndicesOutOfRange) {
    EXPECT_TRUE(is_refused(kTriangle + "f 1 2 9\n"));
    EXPECT_EQ(parse_obj(kTriangle + "f 1/9 2 3\n", "t.obj").corners[0].uv, kNoIndex);
    const Peer peer = peer_read(kTriangle + "f 1 2 9\n");
    if (!peer.is_read || peer.shapes.empty()) GTEST_SKIP() << kAgrees;
    EXPECT_EQ(peer.shapes[0].mesh.indices[2].vertex_index, 8);
}

TEST(ObjReaderAndItsPeer, DifferInFacesOfFewerThanThreeCorners) {
    const std::string text = kTriangle + "f 1 2\nf 1 2 3\n";
    EXPECT_EQ(parse_obj(text, "t.obj").polygon_count(), 2u);
    if (peer_read(text).shapes.at(0).mesh.num_face_vertices.size() != 1) GTEST_SKIP() << kAgrees;
}

TEST(ObjReaderAndItsPeer, DifferInWhetherAGroupEndsAnObject) {
    const std::string text = kTriangle + "o thing\ng side\nusemtl red\nf 1 2 3\n";
    EXPECT_EQ(parse_obj(text, "t.obj").parts[0], (Part{"thing", "side", "red", 0}));
    const Peer peer = peer_read(text);
    EXPECT_EQ(peer.shapes.at(0).name, "side");
    EXPECT_EQ(peer.shapes.at(0).mesh.material_ids.at(0), -1) << "no library has the material";
}

TEST(ObjReaderAndItsPeer, DifferInFilesWhereOnlySomeVerticesHaveColours) {
    const std::string text = "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const IndexedFaceSet ours = parse_obj(text, "t.obj");
    EXPECT_EQ(ours.colors[0], Vec3f(1, 0, 0));
    EXPECT_TRUE(std::isnan(ours.colors[1].x));
    if (!peer_read(text).attributes.colors.empty()) GTEST_SKIP() << kAgrees;
}

TEST(ObjReaderAndItsPeer, DifferInStatementsOfSeveralLines) {
    const std::string text = kTriangle + "f 1 2 \\\n3\n";
    const Peer peer = peer_read(text);
    const bool has_face = !peer.shapes.empty() && !peer.shapes[0].mesh.num_face_vertices.empty() &&
                          peer.shapes[0].mesh.indices.back().vertex_index == 2 &&
                          peer.shapes[0].mesh.num_face_vertices[0] == 3;
    EXPECT_EQ(parse_obj(text, "t.obj").corners.size(), 3u);
    if (has_face) GTEST_SKIP() << kAgrees;
}

}  // namespace
}  // namespace pectin
