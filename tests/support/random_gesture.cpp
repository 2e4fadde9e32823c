#include "support/random_gesture.h"

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "ffd/drag_plan.h"
#include "ffd/lattice_field.h"

namespace pectin::test {
namespace {

Vec3 random_vertex(const TriMesh& mesh, Random& random) {
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (mesh.is_live(v)) return mesh.position(v);
    }
}

Lattice random_cage(const Box& box, Random& random) {
    const IVec3 counts{random.integer(2, 5), random.integer(2, 5), random.integer(2, 5)};
    return fit_lattice(box, counts);
}

std::optional<RandomGesture> random_drag(const TriMesh& mesh, Random& random) {
    const Box box = mesh.bounding_box();
    const double size = box.diagonal();
    DragPlan plan;
    std::string description = "drag";
    const double length = size * random.scale(0.01, 0.4);
    plan.fold_free = random.chance(0.4);
    const int count = random.chance(0.4) ? random.integer(2, 4) : 1;
    for (int i = 0; i < count; ++i) {
        Move move{.from = random_vertex(mesh, random)};
        move.to = move.from + length * random.direction();
        if (random.chance(0.3)) {
            const Vec3 axis = random.direction();
            move.twist = Twist{axis, random.uniform(-60.0, plan.fold_free ? 180.0 : 60.0)};
        }
        if (random.chance(0.1)) move.scale = random.scale(0.7, 1.4);
        plan.moves.push_back(move);
    }
    if (random.chance(0.2)) plan.pins.push_back(random_vertex(mesh, random));
    if (random.chance(0.2)) plan.plane = MirrorPlane{random.integer(0, 2), box.centre()[0]};
    if (random.chance(0.7)) {
        plan.lattice = brush_lattice(plan.moves.front().from, size * random.scale(0.2, 1.0),
                                     random.integer(1, 5));
        plan.is_centred_on_point = true;
        if (random.chance(0.3)) plan.falloff = Falloff::plateau;
    } else {
        plan.lattice = random_cage(box, random);
        description += " in a cage";
    }
    auto planned = plan_drag(plan);
    auto* const drag = std::get_if<PlannedDrag>(&planned);
    if (!drag || drag->warp.steps.size() > 30) return std::nullopt;
    description += " of " + std::to_string(count) + " handles in " +
                   std::to_string(drag->warp.steps.size()) + " steps";
    if (plan.plane) description += ", symmetric";
    return RandomGesture{std::move(drag->warp), std::move(description)};
}

RandomGesture random_control(const TriMesh& mesh, Random& random) {
    const Box box = mesh.bounding_box();
    const Lattice lattice = random_cage(box, random);
    std::vector<Vec3> displacements(lattice.control_count(), Vec3{0.0});
    const double length = box.diagonal() * random.scale(0.01, 0.3);
    const int count = random.integer(1, 6);
    for (int i = 0; i < count; ++i) {
        const int k = random.integer(0, static_cast<int>(displacements.size()) - 1);
        displacements[static_cast<std::size_t>(k)] = length * random.direction();
    }
    return {Warp{{LatticeField(lattice, std::move(displacements))}},
            std::to_string(count) + " control points"};
}

}  // namespace

RandomGesture random_gesture(const TriMesh& mesh, Random& random) {
    if (random.chance(0.2)) return {random_warp(mesh, random), "random warp"};
    if (random.chance(0.25)) return random_control(mesh, random);
    while (true) {
        if (auto drag = random_drag(mesh, random)) return *std::move(drag);
    }
}

}  // namespace pectin::test
