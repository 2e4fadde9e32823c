#include "app/tools/brush_circle.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

constexpr Colour kImage{255, 255, 255, 80};
constexpr int kSides = 96;

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

void add_circle(Overlay& overlay, const Vec3& centre, const Vec3& normal, double radius,
                const Colour& colour) {
    const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 u = glm::normalize(glm::cross(normal, axis)), v = glm::cross(normal, u);
    const auto on_circle = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < kSides; ++i) {
        overlay.lines.push_back({on_circle(i), on_circle(i + 1), colour, 1.6f});
    }
    overlay.points.push_back({centre, colour, 6.0f});
}

}  // namespace

void add_brush_circle(Overlay& overlay, const ToolContext& context, const Colour& colour) {
    const bool has_cage = context.session().lattice_settings().cage.has_value();
    if (!context.hover() || context.sets_pins || has_cage) return;
    const Pick& hover = *context.hover();
    const Vec3 normal = smooth_normal(context.session().mesh(), hover);
    add_circle(overlay, hover.point, normal, context.radius(), colour);
    const auto& plane = context.session().symmetry();
    if (!plane) return;
    add_circle(overlay, plane->image(hover.point), plane->image_of_vector(normal), context.radius(),
               kImage);
}

}  // namespace pectin
