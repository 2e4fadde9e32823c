// Tests real models and shapes: a point that is dragged by a tenth of the object's size arrives,
// the mesh is refined where needed, and undo restores the first save to the byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "io/obj_writer.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

struct Subject {
    std::string name;
    Command begin;
    Vec3 direction;          // the extreme vertex in this direction is dragged in this direction
    bool is_smooth = false;  // no edge is nearly as rough as the theta_max of the tests
};

void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.name; }

Subject model(const std::string& name, const Vec3& direction) {
    return {name, command::Open{.path = test::model_path(name)}, direction};
}

Subject shape(const std::string& name, command::Shape::Kind kind, int resolution, bool is_smooth) {
    return {name, command::Shape{kind, resolution}, {0, 1, 0}, is_smooth};
}

VertexId extreme_vertex(const TriMesh& mesh, const Vec3& direction) {
    VertexId extreme{0};
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const VertexId v{i};
        if (exists(mesh.half_edge(v)) &&
            glm::dot(mesh.position(v), direction) > glm::dot(mesh.position(extreme), direction)) {
            extreme = v;
        }
    }
    return extreme;
}

class Sculpting : public testing::TestWithParam<Subject> {
  protected:
    void SetUp() override {
        if (const auto* open = std::get_if<command::Open>(&GetParam().begin)) {
            if (!std::filesystem::exists(open->path)) {
                GTEST_SKIP() << "no model " << open->path << " (CMake option PECTIN_MODELS)";
            }
        }
        expect_done(GetParam().begin);
    }
    void expect_done(const Command& command) {
        const Done done = session_.execute(command);
        ASSERT_TRUE(done) << done.refusal().reason;
    }
    Session session_;
};

TEST_P(Sculpting, DragsExactlyRefinesAndUndoesToTheByte) {
    expect_done(command::Adapt{.theta_max = Setting::of(10.0)});
    const std::string first = format_obj(session_.mesh());
    const double size = session_.mesh().bounding_box().diagonal();
    const VertexId grabbed = extreme_vertex(session_.mesh(), GetParam().direction);
    const Vec3 from = session_.mesh().position(grabbed);
    const Vec3 to = from + 0.1 * size * GetParam().direction;
    expect_done(command::Drag{.moves = {{from, to}}});

    const double miss = glm::distance(session_.mesh().position(grabbed), to) / size;
    const Statistics after = session_.statistics();
    EXPECT_LE(miss, 1e-6);
    EXPECT_EQ(after.needing_refinement, 0u);
    EXPECT_FALSE(after.budget_hit);
    EXPECT_GT(after.last.splits, 0u);
    EXPECT_EQ(session_.mesh().validate(), std::vector<std::string>{});
    if (!after.floor_hit && GetParam().is_smooth) {
        EXPECT_LE(after.divergence_max_deg, 10.0 + 1e-6);
    }
    std::printf("%s: %llu faces, then %llu; %llu splits; off by %.1e of its size; held back %llu\n",
                GetParam().name.c_str(), static_cast<unsigned long long>(after.base_faces),
                static_cast<unsigned long long>(after.faces),
                static_cast<unsigned long long>(after.last.splits), miss,
                static_cast<unsigned long long>(after.held_back));

    const std::string dragged = format_obj(session_.mesh());
    EXPECT_NE(dragged, first);
    expect_done(command::Undo{});
    EXPECT_EQ(format_obj(session_.mesh()), first);
    expect_done(command::Redo{});
    EXPECT_EQ(format_obj(session_.mesh()), dragged);
}

// With all thresholds off, everything that drags have refined is decimated, and the base faces are
// restored.
TEST_P(Sculpting, DecimatesToTheBaseMeshWithAllThresholdsOff) {
    const TriMesh base = session_.mesh();
    expect_done(command::Adapt{.theta_max = Setting::of(10.0)});
    for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, -1, 0}}) {
        const double size = session_.mesh().bounding_box().diagonal();
        const Vec3 from = session_.mesh().position(extreme_vertex(session_.mesh(), direction));
        expect_done(command::Drag{.moves = {{from, from + 0.05 * size * direction}}});
    }
    EXPECT_GT(session_.mesh().face_count(), base.face_count());
    expect_done(command::Adapt{.theta_max = Setting::off(), .l_max = Setting::off()});
    expect_done(command::Readapt{});
    ASSERT_EQ(session_.mesh().face_count(), base.face_count());
    EXPECT_EQ(session_.mesh().vertex_count(), base.vertex_count());
    for (std::uint32_t h = 0; h < 3 * base.face_slots(); ++h) {
        ASSERT_EQ(session_.mesh().half_edge(HalfEdgeId{h}), base.half_edge(HalfEdgeId{h}));
    }
}

// The point and the target of a moderate drag, and its radius.
command::Drag random_drag(const TriMesh& mesh, double radius, test::Random& random) {
    VertexId v{0};
    do {
        v = VertexId{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
    } while (!mesh.is_live(v) || !exists(mesh.half_edge(v)));
    const Vec3 from = mesh.position(v);
    return {.moves = {{from, from + 0.2 * radius * random.direction()}}, .fold_free = true};
}

// Real models are rough, and eighty drags bend the same places again and again. By the paper's rule
// suzanne would get 75 times as many triangles as it has, and spot 6 times as many.
TEST_P(Sculpting, EndsManyModerateDragsWithFewTriangles) {
    const TriMesh base = session_.mesh();
    const std::string first = format_obj(base);
    const double size = base.bounding_box().diagonal();
    test::Random random(80);
    const int drags = test::is_sanitized() ? 20 : 80;
    std::uint64_t left_needing = 0;
    for (int i = 0; i < drags; ++i) {
        const double radius = size * random.uniform(0.06, 0.2);
        expect_done(command::Brush{.radius = radius});
        expect_done(random_drag(session_.mesh(), radius, random));
        left_needing += session_.statistics().needing_refinement;
    }
    EXPECT_EQ(left_needing, 0u);
    EXPECT_EQ(session_.mesh().validate(), std::vector<std::string>{});
    EXPECT_LT(session_.mesh().face_count(), 2 * base.face_count() + 20'000);
    std::printf("%s: %u faces, then %u\n", GetParam().name.c_str(), base.face_count(),
                session_.mesh().face_count());
    const std::string dragged = format_obj(session_.mesh());
    expect_done(command::Undo{.count = drags});
    EXPECT_EQ(format_obj(session_.mesh()), first);
    expect_done(command::Redo{.count = drags});
    EXPECT_EQ(format_obj(session_.mesh()), dragged);
}

// At most a twentieth of the triangles is thinner than the drags make those of the base mesh, by a
// degree. Bisections divide equilateral triangles, too, so angles above 20 degrees do not count.
TEST_P(Sculpting, KeepsTheShapesOfTrianglesOverManyDrags) {
    const auto angle_after_drags = [](const Command& begin, bool adaptive) {
        Session session;
        test::expect_done(session, begin);
        test::expect_done(session, command::Adapt{.enabled = adaptive});
        const double size = session.mesh().bounding_box().diagonal();
        test::Random random(79);
        for (int i = 0; i < 80; ++i) {
            const double radius = size * random.uniform(0.06, 0.2);
            // Adaptivity must not change where the drags are, so base vertices are grabbed.
            const VertexId v{static_cast<std::uint32_t>(
                random.integer(0, static_cast<int>(session.mesh().base_vertex_count()) - 1))};
            const Vec3 way = 0.2 * radius * random.direction();
            if (!exists(session.mesh().half_edge(v))) continue;
            const Vec3 from = session.mesh().position(v);
            test::expect_done(session, command::Brush{.radius = radius});
            test::expect_done(session,
                              command::Drag{.moves = {{from, from + way}}, .fold_free = true});
        }
        return test::smallest_angle_quantile(session.mesh(), 0.05);
    };
    const double adaptive = angle_after_drags(GetParam().begin, true);
    const double fixed = angle_after_drags(GetParam().begin, false);
    EXPECT_GE(adaptive, std::min(fixed, 21.0) - 1.0);
    std::printf("%s: %.2f degrees, %.2f without adaptivity\n", GetParam().name.c_str(), adaptive,
                fixed);
}

std::string identifier_of(const testing::TestParamInfo<Subject>& subject) {
    std::string name = subject.param.name;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Subjects, Sculpting,
                         testing::Values(model("spot", {0, 0, -1}), model("rocker-arm", {0, 1, 0}),
                                         model("teapot", {1, 0, 0}), model("suzanne", {0, 0, 1}),
                                         model("fandisk", {0, 1, 0}), model("beetle", {0, 1, 0}),
                                         shape("cube", command::Shape::Kind::cube, 8, true),
                                         shape("plane", command::Shape::Kind::plane, 8, true),
                                         shape("torus", command::Shape::Kind::torus, 8, false),
                                         shape("cylinder", command::Shape::Kind::cylinder, 6,
                                               false),
                                         shape("sphere", command::Shape::Kind::sphere, 3, false)),
                         identifier_of);

TEST(SculptingACube, RefinesWhereItBendsButNotItsRightAngles) {
    Session session;
    ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::cube, 8}));
    ASSERT_TRUE(
        session.execute(command::Adapt{.theta_max = Setting::of(10.0), .l_max = Setting::off()}));
    ASSERT_TRUE(session.execute(command::Brush{.radius = 1.0}));
    ASSERT_TRUE(session.execute(command::Drag{.moves = {{{0, 0, 1}, {0, 0, 1.2}}}}));
    const TriMesh& mesh = session.mesh();
    EXPECT_GT(session.statistics().last.splits, 50u);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    for (std::uint32_t i = mesh.base_vertex_count(); i < mesh.vertex_slots(); ++i) {
        const Vec3& p = mesh.position(VertexId{i});
        EXPECT_LT(std::max(std::abs(p.x), std::abs(p.y)), 1.0) << "on an edge of the cube";
        EXPECT_GT(p.z, 1.0) << "not where it bends";
    }
}

TEST(SculptingACube, RefinesNothingForATinyDrag) {
    Session session;
    ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::cube, 8}));
    ASSERT_TRUE(
        session.execute(command::Adapt{.theta_max = Setting::of(10.0), .l_max = Setting::off()}));
    ASSERT_TRUE(session.execute(command::Brush{.radius = 1.0}));
    ASSERT_TRUE(session.execute(command::Drag{.moves = {{{0, 0, 1}, {0, 0, 1.0001}}}}));
    EXPECT_EQ(session.statistics().last.splits, 0u);
    EXPECT_GT(session.statistics().last.influenced_vertices, 0u);
}

}  // namespace
}  // namespace pectin
