#include "app/editor_scene.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

constexpr Colour kCircle{255, 255, 255, 190};
constexpr Colour kCircleBeingSet{255, 214, 64, 255};
constexpr Colour kCircleImage{255, 255, 255, 80};
constexpr int kCircleSides = 96;
// Distance from the object to the border of the drawn plane, in diagonals of the object's box.
constexpr double kPlaneMargin = 0.03;

// The normals of the face's corners, interpolated at the pick, so that the circle moves smoothly
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

// Adds a circle about a point of the surface, in the tangent plane.
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

void add_active_drag(Overlay& overlay, const Editor& editor) {
    const Sculptor& sculptor = editor.sculptor();
    // After several steps, these are the lattices of the last step. While the drag is being
    // applied in the background, the session may not be asked for them.
    if (!editor.is_working()) {
        for (const LatticeField& field : editor.session().active_lattices()) {
            add_lattice(overlay, field.lattice(), field.displacements());
        }
    }
    add_drag(overlay, sculptor.from(), sculptor.to());
    const auto& plane = editor.session().symmetry();
    if (plane && plane->offset(sculptor.from()) != 0.0) {
        add_drag(overlay, plane->image(sculptor.from()), plane->image(sculptor.to()), true);
    }
}

void add_pins(Overlay& overlay, const Editor& editor) {
    const auto& plane = editor.session().symmetry();
    for (const Vec3& pin : editor.pins().points()) {
        add_pin(overlay, pin);
        if (plane && plane->offset(pin) != 0.0) add_pin(overlay, plane->image(pin), true);
    }
}

// The drawn part of the plane is a little larger than the object.
void add_symmetry_plane(Overlay& overlay, const Editor& editor) {
    const auto& plane = editor.session().symmetry();
    if (!plane || !editor.display.symmetry_plane) return;
    const Vec3 margin{kPlaneMargin * editor.workspace().diagonal()};
    const Box& box = editor.workspace().box();
    add_mirror_plane(overlay, *plane, {.min = box.min - margin, .max = box.max + margin});
}

void add_cage(Overlay& overlay, const Editor& editor, const Lattice& cage) {
    const CagePoints& points = editor.cage_points();
    std::vector<Vec3> displacements;
    if (points.is_dragging()) displacements = points.displacements(editor.session());
    add_lattice(overlay, cage, displacements);
    const auto position = [&](const IVec3& index) {
        const Vec3 rest = cage.rest(index);
        return displacements.empty() ? rest : rest + displacements[cage.control_index(index)];
    };
    for (const IVec3& index : points.selected()) {
        add_control_point(overlay, position(index), true, false);
    }
    if (points.hovered() && !points.is_dragging()) {
        add_control_point(overlay, position(*points.hovered()), false, true);
    }
}

// Adds the circle of the brush at the cursor, and with symmetry also its image.
void add_brush(Overlay& overlay, const Editor& editor, const Pick& hover) {
    const Vec3 normal = smooth_normal(editor.session().mesh(), hover);
    const Colour& colour = editor.is_setting_radius() ? kCircleBeingSet : kCircle;
    add_circle(overlay, hover.point, normal, editor.radius(), colour);
    const auto& plane = editor.session().symmetry();
    if (!plane) return;
    add_circle(overlay, plane->image(hover.point), plane->image_of_vector(normal), editor.radius(),
               kCircleImage);
}

// Returns the lattice that a drag from here would use; without a point under the cursor, the one
// that was used last.
std::optional<Lattice> preview_lattice(const Editor& editor) {
    const int span = editor.session().lattice_settings().span;
    if (editor.hover()) return brush_lattice(editor.hover()->point, editor.radius(), span);
    return editor.is_working() ? std::nullopt : editor.session().lattice_in_use();
}

}  // namespace

Scene editor_scene(const Editor& editor, float pixel_scale) {
    Scene scene{.camera = editor.camera(),
                .wireframe = editor.display.wireframe,
                .levels = editor.display.levels,
                .pixel_scale = pixel_scale};
    Overlay& overlay = scene.overlay;
    add_symmetry_plane(overlay, editor);
    const bool is_dragging = editor.sculptor().is_dragging();
    const bool has_cage = editor.session().lattice_settings().cage.has_value();
    if (is_dragging) {
        add_active_drag(overlay, editor);
    } else if (const auto cage = editor.editable_cage()) {
        add_cage(overlay, editor, *cage);
    } else if (editor.display.lattice) {
        if (const auto lattice = preview_lattice(editor)) add_lattice(overlay, *lattice, {});
    }
    add_pins(overlay, editor);
    if (is_dragging || !editor.hover()) return scene;
    if (editor.sets_pins) {
        add_pin(overlay, editor.hover()->point, true);
    } else if (!has_cage) {
        add_brush(overlay, editor, *editor.hover());
    }
    return scene;
}

}  // namespace pectin
