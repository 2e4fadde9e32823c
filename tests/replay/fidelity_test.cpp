// Tests that real models keep all their data: untouched models are saved as they were read, and
// drags change nothing out of their reach. Very small objects and objects far from the origin are
// sculpted like others.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <tuple>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "mesh/unshared_vertices.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

using Corner = IndexedFaceSet::Corner;

Vec2f uv_of(const IndexedFaceSet& set, const Corner& corner) {
    return corner.uv == IndexedFaceSet::kNoIndex ? Vec2f{-1e30f} : set.uvs[corner.uv];
}

const Part& part_of(const IndexedFaceSet& set, std::size_t polygon) {
    return set.parts[set.polygon_part[polygon]];
}

// Checks that `saved` has the polygons of `input` in the same order, with their vertices, texture
// coordinates, parts and, if the input has them, normals.
void expect_same_polygons(const IndexedFaceSet& saved, const IndexedFaceSet& input) {
    ASSERT_EQ(saved.polygon_end, input.polygon_end);
    for (std::size_t p = 0; p < input.polygon_count(); ++p) {
        ASSERT_TRUE(part_of(saved, p) == part_of(input, p)) << "polygon " << p;
    }
    for (std::size_t c = 0; c < input.corners.size(); ++c) {
        ASSERT_EQ(saved.corners[c].position, input.corners[c].position);
        ASSERT_EQ(uv_of(saved, saved.corners[c]), uv_of(input, input.corners[c]));
        if (input.corners[c].normal == IndexedFaceSet::kNoIndex) continue;
        ASSERT_EQ(saved.normals[saved.corners[c].normal], input.normals[input.corners[c].normal]);
    }
}

IndexedFaceSet saved(const Session& session) {
    return parse_obj(format_obj(session.mesh()), "saved.obj");
}

class Model : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override {
        path_ = test::model_path(GetParam());
        if (!std::filesystem::exists(path_)) {
            GTEST_SKIP() << "no model " << path_ << " (CMake option PECTIN_MODELS)";
        }
        input_ = read_obj(path_);
        ASSERT_TRUE(session_.execute(command::Open{.path = path_}));
        size_ = session_.mesh().bounding_box().diagonal();
    }
    std::string path_;
    IndexedFaceSet input_;
    Session session_;
    double size_ = 0.0;
};

TEST_P(Model, IsSavedAsItWasReadIfUntouched) {
    const IndexedFaceSet output = saved(session_);
    EXPECT_EQ(output.positions, input_.positions);
    EXPECT_EQ(output.material_libraries, input_.material_libraries);
    expect_same_polygons(output, input_);
}

// The base faces that a drag may have changed.
class Touched {
  public:
    explicit Touched(const TriMesh& mesh) : is_touched_(mesh.base_face_count(), false) {}

    void add(const TriMesh& mesh, const Box& zone) {
        for (FaceId f : test::live_faces(mesh)) {
            const HalfEdgeId h = TriMesh::half_edge(f, 0);
            if (triangle_meets_box(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)),
                                   mesh.position(mesh.origin(TriMesh::prev(h))), zone)) {
                is_touched_[index(mesh.base_face(f))] = true;
            }
        }
    }
    // Refinement also splits faces next to those in the zone, so all split faces count.
    bool operator()(const TriMesh& mesh, FaceId base) const {
        return is_touched_[index(base)] || split_[index(base)] > 1 || !mesh.is_live(base);
    }
    void count_pieces(const TriMesh& mesh) {
        split_.assign(mesh.base_face_count(), 0);
        for (FaceId f : test::live_faces(mesh)) ++split_[index(mesh.base_face(f))];
    }

  private:
    std::vector<bool> is_touched_;
    std::vector<int> split_;
};

TEST_P(Model, KeepsEverythingOutOfReachOfFiftyDrags) {
    ASSERT_TRUE(session_.execute(command::Brush{.radius = 0.03 * size_}));
    ASSERT_TRUE(session_.execute(command::Adapt{.budget = 100'000}));
    const TriMesh base = session_.mesh();
    Touched touched(base);
    test::Random random(50);
    for (int drags = 0; drags < 50;) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(base.vertex_slots()) - 1))};
        if (!exists(base.half_edge(v))) continue;
        const Vec3 from = session_.mesh().position(v);
        const TriMesh before = session_.mesh();
        ASSERT_TRUE(session_.execute(
            command::Drag{.moves = {{from, from + 0.01 * size_ * random.direction()}}}));
        touched.add(before, session_.lattice_in_use()->influenced_zone());
        ++drags;
    }
    const TriMesh& mesh = session_.mesh();
    EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
    touched.count_pieces(mesh);

    const IndexedFaceSet output = saved(session_);
    ASSERT_GE(output.positions.size(), input_.positions.size());
    std::size_t still = 0, untouched = 0;
    const UnsharedVertices unshared(mesh);
    for (std::uint32_t v = 0; v < input_.positions.size(); ++v) {
        ASSERT_EQ(output.positions[v], unshared.position(VertexId{v}));
        still += output.positions[v] == input_.positions[v] ? 1 : 0;
    }
    std::vector<bool> is_reached(input_.polygon_count(), false);
    for (std::uint32_t f = 0; f < base.base_face_count(); ++f) {
        if (touched(mesh, FaceId{f})) is_reached[base.polygon(FaceId{f})] = true;
    }
    // Polygons out of reach keep their order and corners between the changed ones.
    std::size_t at = 0;
    for (std::size_t p = 0; p < input_.polygon_count(); ++p) {
        if (is_reached[p]) continue;
        ++untouched;
        const auto is_this = [&](std::size_t q) {
            const std::uint32_t begin = output.polygon_begin(q), from = input_.polygon_begin(p);
            if (output.polygon_end[q] - begin != input_.polygon_end[p] - from) return false;
            for (std::uint32_t c = 0; c < output.polygon_end[q] - begin; ++c) {
                const Corner &o = output.corners[begin + c], &i = input_.corners[from + c];
                if (o.position != i.position || uv_of(output, o) != uv_of(input_, i)) return false;
                if (output.positions[o.position] != input_.positions[i.position]) return false;
            }
            return part_of(output, q) == part_of(input_, p);
        };
        while (at < output.polygon_count() && !is_this(at)) ++at;
        ASSERT_LT(at, output.polygon_count()) << "polygon " << p << " is not in its place";
        ++at;
    }
    EXPECT_GT(still, 0u);
    std::printf("%s: 50 drags, %zu of %zu polygons out of reach kept, %zu vertices inserted\n",
                GetParam().c_str(), untouched, input_.polygon_count(),
                output.positions.size() - input_.positions.size());

    while (session_.execute(command::Undo{})) {
    }
    EXPECT_TRUE(session_.mesh() == base);
}

// All pieces of a base face stay inside the bounds of its triangle in the texture.
TEST_P(Model, KeepsTextureCoordinatesInsideTheirCharts) {
    const TriMesh base = session_.mesh();
    if (!base.has_uvs()) GTEST_SKIP() << GetParam() << " has no texture coordinates";
    ASSERT_TRUE(session_.execute(command::Adapt{.theta_max = Setting::of(8.0), .budget = 100'000}));
    test::Random random(51);
    for (int drags = 0; drags < 20; ++drags) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(base.vertex_slots()) - 1))};
        const Vec3 from = session_.mesh().position(v);
        std::ignore = session_.execute(
            command::Drag{.moves = {{from, from + 0.05 * size_ * random.direction()}}});
    }
    const TriMesh& mesh = session_.mesh();
    EXPECT_GT(mesh.vertex_count(), base.vertex_count());
    for (FaceId f : test::live_faces(mesh)) {
        Vec2f low{1e30f}, high{-1e30f};
        for (int c = 0; c < 3; ++c) {
            const Vec2f uv = base.uv(base.wedge(TriMesh::half_edge(mesh.base_face(f), c)));
            low = glm::min(low, uv);
            high = glm::max(high, uv);
        }
        for (int c = 0; c < 3; ++c) {
            const Vec2f uv = mesh.uv(mesh.wedge(TriMesh::half_edge(f, c)));
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(uv, low)) &&
                        glm::all(glm::lessThanEqual(uv, high)));
        }
    }
}

std::string identifier_of(const testing::TestParamInfo<std::string>& model) {
    std::string name = model.param;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Real, Model,
                         testing::Values("spot", "rocker-arm", "teapot", "suzanne", "fandisk",
                                         "beetle"),
                         identifier_of);

// --- Large and small numbers

struct Sculpted {
    std::uint32_t vertices = 0, faces = 0;
    double farthest = 0.0;  // largest distance of a vertex from its place in the object at the
                            // origin, relative to the size
};

// Drags a scaled and translated sphere three times. home: the positions of the same sphere at the
// origin; filled if empty.
Sculpted sculpt(double scale, const Vec3& offset, std::vector<Vec3>& home) {
    const ScratchFolder folder;
    IndexedFaceSet set = make_shape(ShapeKind::sphere, 3);
    const auto placed = [&](const Vec3& p) { return scale * p + offset; };
    for (Vec3& p : set.positions) p = placed(p);
    set.normals.clear();
    for (auto& corner : set.corners) corner.normal = IndexedFaceSet::kNoIndex;
    folder.write("a.obj", format_obj(build_mesh(set).mesh));
    Session session;
    EXPECT_TRUE(session.execute(command::Open{.path = folder.path("a.obj")}));
    for (const auto& [from, to] :
         {std::pair{Vec3{0, 0, 1}, Vec3{0, 0.2, 1.4}}, std::pair{Vec3{0, 1, 0}, Vec3{0.1, 0.7, 0}},
          std::pair{Vec3{-1, 0, 0}, Vec3{-1.3, 0.1, 0.1}}}) {
        EXPECT_TRUE(session.execute(command::Drag{.moves = {{placed(from), placed(to)}}}));
    }
    const TriMesh& mesh = session.mesh();
    EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    Sculpted result{mesh.vertex_count(), mesh.face_count()};
    for (std::uint32_t v = 0; v < mesh.base_vertex_count(); ++v) {
        const Vec3 p = (mesh.position(VertexId{v}) - offset) / scale;
        if (home.size() <= v) home.push_back(p);
        result.farthest = std::max(result.farthest, glm::distance(p, home[v]));
    }
    return result;
}

TEST(AModel, IsSculptedFarFromTheOriginAndVerySmallAsAtTheOrigin) {
    std::vector<Vec3> home;
    const Sculpted there = sculpt(1.0, Vec3{0.0}, home);
    EXPECT_GT(there.faces, 1280u + 200u);
    struct Case {
        const char* name;
        double scale;
        Vec3 offset;
    };
    for (const Case& c : {Case{"a million units away", 1.0, {1e6, -1e6, 1e6}},
                          Case{"a millionth of a unit", 1e-6, {0, 0, 0}},
                          Case{"a million units", 1e6, {0, 0, 0}}}) {
        SCOPED_TRACE(c.name);
        const Sculpted here = sculpt(c.scale, c.offset, home);
        std::printf("%s: %u faces (%u at home), base vertices off by %.1e\n", c.name, here.faces,
                    there.faces, here.farthest);
        EXPECT_LT(here.farthest, 1e-6);
        // Angles that differ in the last digits may change one or two splits.
        EXPECT_NEAR(here.faces, there.faces, 0.01 * there.faces);
    }
}

}  // namespace
}  // namespace pectin
