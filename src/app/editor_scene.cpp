#include "app/editor_scene.h"

#include <array>
#include <cmath>
#include <numbers>

#include "ffd/drag_solver.h"

namespace pectin {
namespace {

constexpr Colour kCircle{255, 255, 255, 190};
constexpr Colour kCircleBeingSet{255, 214, 64, 255};
constexpr int kCircleSides = 96;

// The surface's normal where the pick is: that of its corners, weighed, so that the circle glides
// from face to face.
Vec3 smooth_normal(const TriMesh& mesh, const Pick& pick) {
    const std::array<HalfEdgeId, 3> corners{TriMesh::half_edge(pick.face, 0),
                                            TriMesh::half_edge(pick.face, 1),
                                            TriMesh::half_edge(pick.face, 2)};
    const auto position = [&](std::size_t i) { return mesh.position(mesh.origin(corners[i % 3])); };
    Vec3 sum{0.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 opposite =
            glm::cross(position(i + 1) - pick.point, position(i + 2) - pick.point);
        sum += glm::length(opposite) * Vec3(mesh.normal(mesh.wedge(corners[i])));
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : pick.normal;
}

// About a point of the surface, in its tangent plane.
void add_circle(Overlay& overlay, const Vec3& centre, const Vec3& normal, double radius,
                const Colour& colour) {
    const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 u = glm::normalize(glm::cross(normal, axis)), v = glm::cross(normal, u);
    const auto on_circle = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * i / kCircleSides;
        return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < kCircleSides; ++i) {
        overlay.lines.push_back({on_circle(i), on_circle(i + 1), colour, 1.6f});
    }
    overlay.points.push_back({centre, colour, 6.0f});
}

void add_dragged_lattice(Overlay& overlay, const Lattice& lattice, const Sculptor& sculptor) {
    const Vec3 from = sculptor.from(), move = sculptor.to() - from;
    const auto solved = DragSolver::create(lattice, std::array{from}, {});
    const auto* solver = std::get_if<DragSolver>(&solved);
    if (!solver) return add_lattice(overlay, lattice, {});
    add_lattice(overlay, lattice, solver->control_displacements(std::array{move}));
}

// The lattice that a drag would use, as far as that is known; else the last one's.
std::optional<Lattice> lattice_at_hand(const Editor& editor) {
    const LatticeSettings& settings = editor.session().lattice_settings();
    if (settings.cage) return settings.cage;
    if (editor.hover()) return brush_lattice(editor.hover()->point, editor.radius(), settings.span);
    return editor.session().lattice_in_use();
}

}  // namespace

Scene editor_scene(const Editor& editor, float pixel_scale) {
    Scene scene{.camera = editor.camera(),
                .wireframe = editor.display.wireframe,
                .levels = editor.display.levels,
                .pixel_scale = pixel_scale};
    const Sculptor& sculptor = editor.sculptor();
    if (sculptor.is_dragging()) {
        if (const auto lattice = editor.session().lattice_in_use()) {
            add_dragged_lattice(scene.overlay, *lattice, sculptor);
        }
        add_drag(scene.overlay, sculptor.from(), sculptor.to());
        return scene;
    }
    if (editor.display.lattice) {
        if (const auto lattice = lattice_at_hand(editor)) add_lattice(scene.overlay, *lattice, {});
    }
    const bool has_brush = !editor.session().lattice_settings().cage;
    if (const auto& hover = editor.hover(); hover && has_brush) {
        add_circle(scene.overlay, hover->point, smooth_normal(editor.session().mesh(), *hover),
                   editor.radius(), editor.is_setting_radius() ? kCircleBeingSet : kCircle);
    }
    return scene;
}

}  // namespace pectin
