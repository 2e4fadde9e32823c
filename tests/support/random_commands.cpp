#include "support/random_commands.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace pectin::test {

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

namespace {

command::Drag random_drag(const TriMesh& mesh, Random& random, double size) {
    command::Drag drag;
    const int moves = random.chance(0.2) ? 2 : 1;
    for (int i = 0; i < moves; ++i) {
        const Vec3 from = random_surface_point(mesh, random);
        const double length = random.chance(0.1) ? 0.0 : size * random.scale(1e-3, 0.5);
        drag.moves.push_back({from, from + length * random.direction()});
    }
    if (random.chance(0.3)) drag.pins.push_back(random_surface_point(mesh, random));
    drag.connected = random.chance(0.3);
    drag.fold_free = random.chance(0.5);
    if (random.chance(0.1)) {
        drag.via.push_back(drag.moves[0].from + 0.1 * size * random.direction());
    }
    if (random.chance(0.1)) {
        drag.moves[0].twist = {random.direction(), random.uniform(-60.0, 60.0)};
        drag.moves[0].scale = random.scale(0.7, 1.4);
    }
    return drag;
}

command::Control random_control(Random& random, double size) {
    command::Control control;
    for (int i = random.integer(1, 3); i > 0; --i) {
        const IVec3 index{random.integer(0, 3), random.integer(0, 3), random.integer(0, 3)};
        control.points.push_back({index, 1.5 * size * random.direction()});
    }
    return control;
}

command::Adapt random_adapt(Random& random, double size, std::uint64_t budget) {
    command::Adapt adapt;
    const double theta = random.scale(4.0, 60.0);
    adapt.theta_max = random.chance(0.1) ? Setting::off() : Setting::of(theta);
    adapt.theta_min =
        random.chance(0.7) ? Setting::automatic() : Setting::of(theta * random.uniform(0.1, 1.05));
    if (random.chance(0.3)) adapt.l_max = Setting::off();
    if (random.chance(0.3)) adapt.l_max = Setting::automatic();
    if (random.chance(0.2)) adapt.l_max = Setting::of(size * random.scale(0.1, 1.0));
    if (random.chance(0.2)) adapt.flatness = Setting::off();
    if (random.chance(0.3)) adapt.flatness = Setting::automatic();
    if (random.chance(0.3)) adapt.propagation = random.uniform(1.0, 1.49);
    if (random.chance(0.3)) adapt.enabled = random.chance(0.7);
    adapt.floor = Setting::of(size * random.scale(0.02, 0.1));
    adapt.budget = random.chance(0.15) ? 600u : budget;
    if (random.chance(0.2)) adapt.drag_budget = Setting::of(300);
    // A copy of the generator, so that later random numbers stay the same.
    if (Random copy = random; copy.chance(0.5)) {
        using Trigger = command::Adapt::Trigger;
        constexpr Trigger kTriggers[] = {Trigger::normals, Trigger::midpoint, Trigger::certified};
        adapt.trigger = kTriggers[copy.integer(0, 2)];
        adapt.tolerance = Setting::of(size * copy.scale(3e-4, 3e-2));
    }
    return adapt;
}

}  // namespace

Command random_command(const TriMesh& mesh, Random& random, double size, std::uint64_t budget) {
    const double which = random.uniform(0.0, 1.0);
    if (which < 0.42) return random_drag(mesh, random, size);
    if (which < 0.44) return random_control(random, size);
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
    if (which < 0.88) return random_adapt(random, size, budget);
    if (which < 0.96) {
        command::Brush brush{.radius = size * random.scale(0.1, 2.0), .span = random.integer(1, 6)};
        // Takes no further random number, so that the other commands stay the same.
        brush.falloff = *brush.span % 2 == 0 ? Falloff::plateau : Falloff::sharp;
        return brush;
    }
    return command::Cage{
        .fit = IVec3{random.integer(1, 5), random.integer(1, 5), random.integer(1, 5)}};
}

bool execute(Session& session, const Command& command, Random& random,
             const std::function<void()>& each_frame) {
    const auto* drag = std::get_if<command::Drag>(&command);
    if (!drag || random.chance(0.6)) return bool{session.execute(command)};
    std::vector<Vec3> points, targets;
    for (const auto& move : drag->moves) points.push_back(move.from);
    const TriMesh before = session.mesh();
    const bool rotates = drag->moves[0].twist.has_value();
    if (!session.begin_drag(points, drag->pins, {drag->connected, drag->fold_free})) return false;
    const int frames = random.integer(0, 3);
    for (int i = 0; i < frames; ++i) {
        const double fraction = random.uniform(-0.5, 1.5);
        targets.clear();
        for (const auto& move : drag->moves)
            targets.push_back(glm::mix(move.from, move.to, fraction));
        std::ignore = session.drag_to(targets);
        EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
        if (each_frame) each_frame();
    }
    targets.clear();
    for (const auto& move : drag->moves) targets.push_back(move.to);
    bool is_done{session.drag_to(targets)};
    if (rotates && is_done && drag->moves.size() == 1) {
        is_done = bool{session.drag_to(std::span(drag->moves))};
    }
    if (!is_done || random.chance(0.2)) {
        session.cancel_drag();
        EXPECT_TRUE(session.mesh() == before) << "cancelled";
        return false;
    }
    session.end_drag();
    return true;
}

std::size_t undo_everything(Session& session) {
    std::size_t steps = 0;
    while (session.execute(command::Undo{})) ++steps;
    return steps;
}

}  // namespace pectin::test
