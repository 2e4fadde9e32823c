// Long random sessions: whatever is done is valid, and all of it can be undone and redone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "io/obj_writer.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using command::Shape;
using test::Random;

const std::vector<std::string> kValid;

struct Start {
    const char* name;
    Shape shape;
};

void operator<<(std::ostream& out, const Start& start) { out << start.name; }

Vec3 random_surface_point(const TriMesh& mesh, Random& random) {
    while (true) {
        const FaceId f{
            static_cast<std::uint32_t>(random.integer(0, static_cast<int>(mesh.face_slots()) - 1))};
        if (!mesh.is_live(f)) continue;
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const Vec3& a = mesh.position(mesh.origin(TriMesh::half_edge(f, 0)));
        const Vec3& b = mesh.position(mesh.origin(TriMesh::half_edge(f, 1)));
        const Vec3& c = mesh.position(mesh.origin(TriMesh::half_edge(f, 2)));
        return random.chance(0.5) ? a : (1 - u - v) * a + u * b + v * c;
    }
}

command::Drag random_drag(const TriMesh& mesh, Random& random) {
    command::Drag drag;
    const int moves = random.chance(0.2) ? 2 : 1;
    for (int i = 0; i < moves; ++i) {
        const Vec3 from = random_surface_point(mesh, random);
        const double length = random.chance(0.1) ? 0.0 : random.scale(1e-3, 0.5);
        drag.moves.push_back({from, from + length * random.direction()});
    }
    if (random.chance(0.3)) drag.pins.push_back(random_surface_point(mesh, random));
    drag.connected = random.chance(0.3);
    drag.fold_free = random.chance(0.5);
    if (random.chance(0.1)) {
        drag.via.push_back(drag.moves[0].from + 0.1 * random.direction());
    }
    if (random.chance(0.1)) {
        drag.moves[0].twist = {random.direction(), random.uniform(-60.0, 60.0)};
        drag.moves[0].scale = random.scale(0.7, 1.4);
    }
    return drag;
}

command::Control random_control(Random& random) {
    command::Control control;
    for (int i = random.integer(1, 3); i > 0; --i) {
        const IVec3 index{random.integer(0, 3), random.integer(0, 3), random.integer(0, 3)};
        control.points.push_back({index, 1.5 * random.direction()});
    }
    return control;
}

command::Adapt random_adapt(Random& random) {
    command::Adapt adapt;
    const double theta = random.scale(4.0, 60.0);
    adapt.theta_max = random.chance(0.1) ? Setting::off() : Setting::of(theta);
    adapt.theta_min =
        random.chance(0.7) ? Setting::automatic() : Setting::of(theta * random.uniform(0.1, 1.05));
    if (random.chance(0.3)) adapt.l_max = Setting::off();
    if (random.chance(0.3)) adapt.l_max = Setting::automatic();
    if (random.chance(0.2)) adapt.l_max = Setting::of(random.scale(0.1, 1.0));
    if (random.chance(0.2)) adapt.flatness = Setting::off();
    if (random.chance(0.3)) adapt.flatness = Setting::automatic();
    if (random.chance(0.3)) adapt.propagation = random.uniform(1.0, 1.49);
    if (random.chance(0.3)) adapt.enabled = random.chance(0.7);
    adapt.floor = Setting::of(random.scale(0.02, 0.1));
    adapt.budget = random.chance(0.15) ? 600u : 5'000u;
    return adapt;
}

Command random_command(const TriMesh& mesh, Random& random) {
    const double which = random.uniform(0.0, 1.0);
    if (which < 0.42) return random_drag(mesh, random);
    if (which < 0.44) return random_control(random);
    if (which < 0.45) {
        const bool is_on = random.chance(0.5);
        command::Symmetry symmetry;
        if (is_on) symmetry.plane = command::Symmetry::Plane::x;
        return symmetry;
    }
    if (which < 0.58) return command::Undo{.count = random.integer(1, 3)};
    if (which < 0.68) return command::Redo{.count = random.integer(1, 3)};
    if (which < 0.75) return command::Readapt{};
    if (which < 0.77) return command::Bake{};
    if (which < 0.88) return random_adapt(random);
    if (which < 0.96) {
        return command::Brush{.radius = random.scale(0.1, 2.0), .span = random.integer(1, 6)};
    }
    return command::Cage{
        command::Cage::Fit{{random.integer(1, 5), random.integer(1, 5), random.integer(1, 5)}}};
}

// Now and then frame by frame, as a mouse does it; each_frame() is called after every frame.
template <typename EachFrame>
bool execute(Session& session, const Command& command, Random& random, EachFrame each_frame) {
    const auto* drag = std::get_if<command::Drag>(&command);
    if (!drag || random.chance(0.6)) return !session.execute(command).has_value();
    std::vector<Vec3> points, targets;
    for (const auto& move : drag->moves) points.push_back(move.from);
    const TriMesh before = session.mesh();
    const bool turns = drag->moves[0].twist.has_value();
    if (session.begin_drag(points, drag->pins, {drag->connected, drag->fold_free})) return false;
    const int frames = random.integer(0, 3);
    for (int i = 0; i < frames; ++i) {
        const double share = random.uniform(-0.5, 1.5);
        targets.clear();
        for (const auto& move : drag->moves) targets.push_back(glm::mix(move.from, move.to, share));
        session.drag_to(targets);
        EXPECT_EQ(session.mesh().validate(), kValid);
        each_frame();
    }
    targets.clear();
    for (const auto& move : drag->moves) targets.push_back(move.to);
    bool refused = session.drag_to(targets).has_value();
    if (turns && !refused && drag->moves.size() == 1) {
        const DragTarget target{drag->moves[0].to, drag->moves[0].twist, drag->moves[0].scale};
        refused = session.drag_to(std::span(&target, 1)).has_value();
    }
    if (refused || random.chance(0.2)) {
        session.cancel_drag();
        EXPECT_TRUE(session.mesh() == before) << "cancelled";
        return false;
    }
    session.end_drag();
    return true;
}

bool execute(Session& session, const Command& command, Random& random) {
    return execute(session, command, random, [] {});
}

std::size_t undo_everything(Session& session) {
    std::size_t steps = 0;
    while (!session.execute(command::Undo{})) ++steps;
    return steps;
}

class RandomSession : public testing::TestWithParam<Start> {};

TEST_P(RandomSession, IsValidThroughoutAndUndoesAndRedoesToTheByte) {
    const int cases = test::case_count(20);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_FALSE(session.execute(GetParam().shape).has_value());
        // Small from the start: by default a small brush dragged far folds into millions.
        ASSERT_FALSE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
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
        while (!session.execute(command::Redo{})) {
        }
        const std::string last = format_obj(session.mesh());
        const std::size_t steps = undo_everything(session);
        EXPECT_GT(steps, 0u);
        ASSERT_TRUE(session.mesh() == base);
        ASSERT_EQ(format_obj(session.mesh()), first);
        ASSERT_FALSE(session.execute(command::Redo{.count = static_cast<int>(steps)}).has_value());
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
    ASSERT_FALSE(session.execute(command::History{setting}));
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

// The mesh after each step, from the beginning on, beside a history that may not keep them all.
TEST(HistoryLimit, DropsTheOldestStepsAndKeepsTheOthersToTheByte) {
    const int cases = test::case_count(20);
    std::size_t lost = 0, kept = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4800 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_FALSE(session.execute(Shape{Shape::Kind::sphere, 2}).has_value());
        ASSERT_FALSE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
        set_limit(session, random_limit(random));
        const History& history = session.history();
        std::vector<TriMesh> after{session.mesh()};
        for (int k = 0; k < 60; ++k) {
            const Command command = random_command(session.mesh(), random);
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            const std::size_t step = history.step_number();
            execute(session, command, random);
            const bool goes_along_steps = std::holds_alternative<command::Undo>(command) ||
                                          std::holds_alternative<command::Redo>(command);
            if (!goes_along_steps && history.step_number() != step) {
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
        while (!session.execute(command::Redo{})) {
        }
        const std::size_t last = history.step_number();
        const std::size_t steps = undo_everything(session);
        // Undoing a bake may take more memory, and then cost the oldest steps.
        const std::size_t first = history.lost_undo_count();
        ASSERT_EQ(steps, last - first);
        ASSERT_TRUE(session.mesh() == after[first]);
        ASSERT_EQ(format_obj(session.mesh()), format_obj(after[first]));
        while (!session.execute(command::Redo{})) {
        }
        ASSERT_TRUE(session.mesh() == after[history.step_number()]);
        lost += first;
        kept += steps;
    }
    // Both happen, however few the seeds.
    EXPECT_GT(lost, kept / 10);
    EXPECT_GT(kept, lost / 10);
    std::printf("seeds 4800 to %d, %zu steps dropped, %zu kept\n", 4800 + cases - 1, lost, kept);
}

TEST(HistoryLimit, LeavesWhatWasUndoneToBeRedoneWithAnyLimit) {
    const int cases = test::case_count(20);
    std::size_t redone = 0, dropped = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4900 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_FALSE(session.execute(Shape{Shape::Kind::sphere, 2}).has_value());
        ASSERT_FALSE(session.execute(command::Adapt{.floor = Setting::of(0.05), .budget = 5'000}));
        const History& history = session.history();
        for (int round = 0; round < 4; ++round) {
            for (int k = 0; k < 8; ++k) {
                execute(session, random_command(session.mesh(), random), random);
                if (random.chance(0.2)) session.execute(command::Bake{});
            }
            while (!session.execute(command::Redo{})) {
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
                ASSERT_FALSE(session.execute(all).has_value());
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

// What a picture shows of each wedge.
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

// What has changed since `seen` is named dirty; `seen` is then the present.
void expect_all_named(Session& session, TriMesh& seen) {
    const DirtyElements dirty = session.take_dirty();
    const TriMesh& mesh = session.mesh();
    if (!dirty.everything) {
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
            if (index(f) >= mesh.face_slots()) continue;  // cut off: nothing to show
            ASSERT_TRUE(mesh.is_live(f) || has(dirty.faces, f));
        }
    }
    seen = mesh;
}

TEST(DirtyElements, NameEverythingAPictureHasToLearn) {
    const int cases = test::case_count(20);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4500 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_FALSE(session.execute(Shape{Shape::Kind::sphere, 2}).has_value());
        EXPECT_TRUE(session.take_dirty().everything);
        TriMesh seen = session.mesh();
        for (int k = 0; k < 40; ++k) {
            const Command command = random_command(session.mesh(), random);
            SCOPED_TRACE("command " + std::to_string(k) + ": " + name(command));
            execute(session, command, random, [&] { expect_all_named(session, seen); });
            expect_all_named(session, seen);
            if (HasFatalFailure()) return;
        }
    }
}

}  // namespace
}  // namespace pectin
