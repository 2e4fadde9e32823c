// The number of self-intersections that fold-free drags report equals the number by definition, on
// models and shapes, also on models that intersect themselves as opened.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <string>

#include "geometry/decimal.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/intersections_by_definition.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

struct Subject {
    std::string name;
    Command begin;
};

void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.name; }

// The number in the remark "the surface intersects itself in 5 places; …", or 0.
std::size_t reported_intersections(const std::string& remark) {
    static const std::string kBefore = "the surface intersects itself in ";
    const std::size_t at = remark.find(kBefore);
    std::size_t count = 0;
    if (at != std::string::npos) {
        const char* number = remark.data() + at + kBefore.size();
        std::from_chars(number, remark.data() + remark.size(), count);
    }
    return count;
}

// The mesh with the faces that it has after the change, and the positions from before it. New
// vertices are at the midpoints of their edges.
TriMesh at_rest(TriMesh mesh, const MeshChange& change) {
    for (const TopologyEdit& edit : change.edits) {
        if (edit.is_split()) {
            mesh.split(edit.edge());
        } else {
            MeshChange unsplit;
            unsplit.slots_before = change.slots_before;
            unsplit.edits = {edit};
            redo(unsplit, mesh);
        }
    }
    return mesh;
}

class ReportedIntersections : public testing::TestWithParam<Subject> {
  protected:
    void SetUp() override {
        if (const auto* open = std::get_if<command::Open>(&GetParam().begin)) {
            if (!std::filesystem::exists(open->path)) {
                GTEST_SKIP() << "no model " << open->path << " (CMake option PECTIN_MODELS)";
            }
        }
        test::expect_done(session_, GetParam().begin);
        size_ = session_.mesh().bounding_box().diagonal();
    }

    // A fold-free drag at a random vertex, `way` radii long.
    command::Drag random_drag(double radius, double way, test::Random& random) const {
        const TriMesh& mesh = session_.mesh();
        VertexId v{0};
        do {
            const int last = static_cast<int>(mesh.vertex_slots()) - 1;
            v = VertexId{static_cast<std::uint32_t>(random.integer(0, last))};
        } while (!mesh.is_live(v) || !exists(mesh.half_edge(v)));
        const Vec3 from = mesh.position(v);
        return {.moves = {{from, from + way * radius * random.direction()}}, .fold_free = true};
    }

    // Returns the number by definition.
    std::size_t expect_exact_report(const command::Drag& drag) {
        TriMesh before = session_.mesh();
        const std::size_t steps = session_.undo_count();
        test::expect_done(session_, drag);
        const std::size_t reported = reported_intersections(session_.remark());
        if (session_.undo_count() == steps) {
            EXPECT_EQ(reported, 0u);
            return 0;
        }
        const TriMesh rest = at_rest(std::move(before), session_.history().latest()->change);
        const std::size_t expected = test::new_intersections(session_.mesh(), rest);
        EXPECT_EQ(reported, expected) << session_.remark();
        return expected;
    }

    Session session_;
    double size_ = 0.0;
};

TEST_P(ReportedIntersections, AreAllAfterDragsThatMayRefine) {
    test::Random random(80);
    std::size_t left = 0;
    for (int i = 0; i < test::case_count(80); ++i) {
        const double radius = size_ * random.uniform(0.06, 0.2);
        test::expect_done(session_, command::Brush{.radius = radius});
        left += expect_exact_report(random_drag(radius, 0.2, random));
    }
    std::printf("%s: %zu left\n", GetParam().name.c_str(), left);
}

// The floor keeps all edges from being split, so intersections remain where drags are long.
TEST_P(ReportedIntersections, AreAllAfterDragsThatMayNotRefine) {
    test::expect_done(session_, command::Adapt{.floor = Setting::of(size_)});
    test::Random random(81);
    std::size_t left = 0;
    // Few of the first drags leave any, so that sanitizers get as many.
    for (int i = 0; i < std::max(40, test::case_count(40)); ++i) {
        const double radius = size_ * random.uniform(0.1, 0.5);
        test::expect_done(session_, command::Brush{.radius = radius});
        left += expect_exact_report(random_drag(radius, random.uniform(0.5, 3.0), random));
        if (random.chance(0.5)) test::expect_done(session_, command::Undo{});
    }
    EXPECT_GT(left, 0u);
    std::printf("%s: %zu left\n", GetParam().name.c_str(), left);
}

// Nine thousand triangles, each across all others, are more pairs than the search tests.
TEST(ReportedIntersectionsOfAHeap, AreSaidToBeIncomplete) {
    if (test::is_sanitized()) GTEST_SKIP() << "takes too long with sanitizers";
    test::Random random(82);
    std::string obj;
    constexpr int kTriangles = 9000;
    for (int i = 0; i < 3 * kTriangles; ++i) {
        const Vec3 p = random.uniform(0.9, 1.0) * random.direction();
        obj += "v " + decimal(p.x) + ' ' + decimal(p.y) + ' ' + decimal(p.z) + '\n';
    }
    for (int i = 0; i < kTriangles; ++i) {
        obj += "f";
        for (int k = 1; k <= 3; ++k) obj += ' ' + std::to_string(3 * i + k);
        obj += '\n';
    }
    ScratchFolder folder;
    folder.write("heap.obj", obj);
    Session session;
    test::expect_done(session, command::Open{.path = folder.path("heap.obj")});
    test::expect_done(session, command::Adapt{.floor = Setting::of(10.0)});
    test::expect_done(session, command::Brush{.radius = 4.0});
    const Vec3 from = session.mesh().position(VertexId{0});
    test::expect_done(session,
                      command::Drag{.moves = {{from, from + Vec3{0.2, 0, 0}}}, .fold_free = true});
    const std::string& remark = session.remark();
    EXPECT_NE(remark.find("intersects itself in at least "), remark.npos) << remark;
}

Subject model(const std::string& name) {
    return {name, command::Open{.path = test::model_path(name)}};
}

INSTANTIATE_TEST_SUITE_P(
    Subjects, ReportedIntersections,
    testing::Values(model("suzanne"), model("beetle"), model("spot"),
                    Subject{"torus", command::Shape{command::Shape::Kind::torus, 8}},
                    Subject{"sphere", command::Shape{command::Shape::Kind::sphere, 3}}),
    [](const testing::TestParamInfo<Subject>& subject) { return subject.param.name; });

}  // namespace
}  // namespace pectin
