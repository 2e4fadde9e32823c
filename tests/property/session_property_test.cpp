// Tests long random sessions: the mesh is valid after every command, and all steps can be undone
// and redone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "io/obj_writer.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_commands.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Shape;
using test::execute;
using test::Random;
using test::random_command;
using test::undo_everything;

const std::vector<std::string> kValid;

struct Start {
    const char* name;
    Shape shape;
};

void operator<<(std::ostream& out, const Start& start) { out << start.name; }

class RandomSession : public testing::TestWithParam<Start> {};

TEST_P(RandomSession, IsValidThroughoutAndUndoesAndRedoesToTheByte) {
    const int cases = test::case_count(20);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(GetParam().shape));
        // The floor and the budget keep the mesh small. With the defaults, a long drag of a small
        // brush may create millions of faces.
        ASSERT_TRUE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
        const std::string first = format_obj(session.mesh());
        const TriMesh base = session.mesh();
        int done = 0;
        for (int k = 0; k < 100; ++k) {
            const Command command = random_command(session.mesh(), random);
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            done += execute(session, command, random) ? 1 : 0;
            ASSERT_EQ(session.mesh().validate(), kValid);
            if (HasFailure()) return;
        }
        EXPECT_GT(done, 30);
        while (session.execute(command::Redo{})) {
        }
        const std::string last = format_obj(session.mesh());
        const std::size_t steps = undo_everything(session);
        EXPECT_GT(steps, 0u);
        ASSERT_TRUE(session.mesh() == base);
        ASSERT_EQ(format_obj(session.mesh()), first);
        ASSERT_TRUE(session.execute(command::Redo{.count = static_cast<int>(steps)}));
        ASSERT_EQ(format_obj(session.mesh()), last);
        ASSERT_EQ(session.mesh().validate(), kValid);
    }
    std::printf("seeds 4000 to %d\n", 4000 + cases - 1);
}

INSTANTIATE_TEST_SUITE_P(OnEveryShape, RandomSession,
                         testing::Values(Start{"sphere", {Shape::Kind::sphere, 2}},
                                         Start{"coarse sphere", {Shape::Kind::sphere, 0}},
                                         Start{"cube", {Shape::Kind::cube, 3}},
                                         Start{"plane", {Shape::Kind::plane, 4}},
                                         Start{"two triangles", {Shape::Kind::plane, 1}},
                                         Start{"torus", {Shape::Kind::torus, 3}},
                                         Start{"cylinder", {Shape::Kind::cylinder, 2}}));

std::optional<std::size_t> random_limit(Random& random) {
    if (random.chance(0.1)) return std::nullopt;
    return static_cast<std::size_t>(random.scale(1e4, 2e7));
}

void set_limit(Session& session, const std::optional<std::size_t>& limit) {
    const auto setting =
        limit ? Setting::of(1e-6 * static_cast<double>(*limit) + 1e-9) : Setting::off();
    ASSERT_TRUE(session.execute(command::History{setting}));
    ASSERT_EQ(session.history().limit(), limit);
}

void expect_within_limit(const History& history) {
    // The newest step and those that can be redone are kept beyond the limit.
    const std::size_t steps = history.undo_count() + history.redo_count();
    EXPECT_TRUE(!history.limit() || history.memory_bytes() <= *history.limit() ||
                history.undo_count() == 0 || steps <= 1)
        << history.memory_bytes() << " bytes in " << steps << " steps, allowed are "
        << *history.limit();
}

// The test keeps the mesh after every step and compares it with the history, which keeps only the
// newest ones.
TEST(HistoryLimit, DropsTheOldestStepsAndKeepsTheOthersToTheByte) {
    const int cases = test::case_count(20);
    std::size_t lost = 0, kept = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4800 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(Shape{Shape::Kind::sphere, 2}));
        ASSERT_TRUE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
        set_limit(session, random_limit(random));
        const History& history = session.history();
        std::vector<TriMesh> after{session.mesh()};
        for (int k = 0; k < 60; ++k) {
            const Command command = random_command(session.mesh(), random);
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            const std::size_t step = history.step_number();
            execute(session, command, random);
            const bool moves_along_steps = std::holds_alternative<command::Undo>(command) ||
                                           std::holds_alternative<command::Redo>(command);
            if (!moves_along_steps && history.step_number() != step) {
                ASSERT_EQ(history.step_number(), step + 1);
                after.resize(step + 1);
                after.push_back(session.mesh());
            }
            ASSERT_TRUE(session.mesh() == after[history.step_number()]);
            expect_within_limit(history);
            if (random.chance(0.1)) {
                set_limit(session, random_limit(random));
                expect_within_limit(history);
            }
            ASSERT_FALSE(HasFailure());
        }
        while (session.execute(command::Redo{})) {
        }
        const std::size_t last = history.step_number();
        const std::size_t steps = undo_everything(session);
        // Undoing a bake may increase the memory of the history, so that the oldest steps are
        // dropped.
        const std::size_t first = history.lost_undo_count();
        ASSERT_EQ(steps, last - first);
        ASSERT_TRUE(session.mesh() == after[first]);
        ASSERT_EQ(format_obj(session.mesh()), format_obj(after[first]));
        while (session.execute(command::Redo{})) {
        }
        ASSERT_TRUE(session.mesh() == after[history.step_number()]);
        lost += first;
        kept += steps;
    }
    // Even a few seeds must test both cases.
    EXPECT_GT(lost, kept / 10);
    EXPECT_GT(kept, lost / 10);
    std::printf("seeds 4800 to %d, %zu steps dropped, %zu kept\n", 4800 + cases - 1, lost, kept);
}

TEST(HistoryLimit, KeepsEveryUndoneStepForRedoWithAnyLimit) {
    const int cases = test::case_count(20);
    std::size_t redone = 0, dropped = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4900 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(Shape{Shape::Kind::sphere, 2}));
        ASSERT_TRUE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
        const History& history = session.history();
        for (int round = 0; round < 4; ++round) {
            for (int k = 0; k < 8; ++k) {
                execute(session, random_command(session.mesh(), random), random);
                if (random.chance(0.2)) test::expect_done(session, command::Bake{});
            }
            while (session.execute(command::Redo{})) {
            }
            set_limit(session, static_cast<std::size_t>(random.scale(1e4, 5e5)));
            const TriMesh newest = session.mesh();
            const std::size_t number = history.step_number();
            const std::size_t steps = undo_everything(session);
            ASSERT_EQ(history.redo_count(), steps);
            if (random.chance(0.5)) set_limit(session, 1000);
            ASSERT_EQ(history.redo_count(), steps) << "a smaller limit";
            if (steps > 0) {
                const command::Redo all{.count = static_cast<int>(steps)};
                ASSERT_TRUE(session.execute(all));
            }
            ASSERT_TRUE(session.mesh() == newest);
            ASSERT_EQ(history.step_number(), number);
            expect_within_limit(history);
            redone += steps;
        }
        dropped += history.lost_undo_count();
    }
    EXPECT_GT(redone, 0u);
    EXPECT_GT(dropped, 0u);
    std::printf("seeds 4900 to %d, %zu steps redone, %zu dropped\n", 4900 + cases - 1, redone,
                dropped);
}

// The position and normal of each wedge in use, which determine a picture.
std::map<WedgeId, std::pair<Vec3, Vec3f>> shown_wedges(const TriMesh& mesh) {
    std::map<WedgeId, std::pair<Vec3, Vec3f>> wedges;
    for (FaceId f : test::live_faces(mesh)) {
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(f, c);
            wedges[mesh.wedge(h)] = {mesh.position(mesh.origin(h)), mesh.normal(mesh.wedge(h))};
        }
    }
    return wedges;
}

// Expects that everything that has changed since `seen` is listed as dirty. Then sets `seen` to the
// present mesh. listed: counts the lists that name elements.
void expect_all_named(Session& session, TriMesh& seen, int& listed) {
    const DirtyElements dirty = session.take_dirty();
    const TriMesh& mesh = session.mesh();
    if (!dirty.everything) {
        listed += dirty.faces.empty() ? 0 : 1;
        ASSERT_TRUE(std::is_sorted(dirty.faces.begin(), dirty.faces.end()));
        ASSERT_TRUE(std::is_sorted(dirty.wedges.begin(), dirty.wedges.end()));
        const auto has = [](const auto& ids, auto id) {
            return std::binary_search(ids.begin(), ids.end(), id);
        };
        const auto shown = shown_wedges(seen);
        for (const auto& [w, seen_as] : shown_wedges(mesh)) {
            const auto before = shown.find(w);
            const bool same = before != shown.end() && before->second == seen_as;
            ASSERT_TRUE(same || has(dirty.wedges, w)) << "wedge " << index(w);
        }
        for (FaceId f : test::live_faces(mesh)) {
            bool same = index(f) < seen.face_slots() && seen.is_live(f);
            for (int c = 0; same && c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                same = seen.wedge(h) == mesh.wedge(h);
            }
            ASSERT_TRUE(same || has(dirty.faces, f)) << "face " << index(f);
        }
        for (FaceId f : test::live_faces(seen)) {
            if (index(f) >= mesh.face_slots()) continue;  // the slot no longer exists
            ASSERT_TRUE(mesh.is_live(f) || has(dirty.faces, f));
        }
    }
    seen = mesh;
}

TEST(DirtyElements, NameEverythingThatARendererMustUpdate) {
    const int cases = test::case_count(20);
    int listed = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4500 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(Shape{Shape::Kind::sphere, 3}));
        EXPECT_TRUE(session.take_dirty().everything);
        TriMesh seen = session.mesh();
        for (int k = 0; k < 40; ++k) {
            const Command command = random_command(session.mesh(), random);
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            execute(session, command, random, [&] { expect_all_named(session, seen, listed); });
            expect_all_named(session, seen, listed);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(listed, cases);
}

}  // namespace
}  // namespace pectin
