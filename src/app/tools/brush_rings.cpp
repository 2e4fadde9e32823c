#include "app/tools/brush_rings.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace pectin {
namespace {

constexpr Colour kImage{255, 255, 255, 80};
constexpr std::size_t kSides = 96;

// The normals of the face's corners, interpolated at the pick, so that the rings move smoothly from
// face to face.
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

constexpr float kOuterWidth = 1.6f, kInnerWidth = 1.0f;  // pixels

Colour faded(Colour colour) {
    colour.alpha = static_cast<std::uint8_t>(colour.alpha * 3 / 5);
    return colour;
}

using RingPoints = std::array<Vec3, kSides>;

// The points around the centre, in the plane across the normal, where the weight of the brush is
// `level`.
RingPoints ring(const BrushProfile& profile, const Vec3& centre, const Vec3& normal, double radius,
                double level) {
    const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 u = glm::normalize(glm::cross(normal, axis)), v = glm::cross(normal, u);
    RingPoints points;
    for (std::size_t i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kSides;
        const Vec3 direction = std::cos(angle) * u + std::sin(angle) * v;
        points[i] = centre + radius * profile.distance_at(level, direction) * direction;
    }
    return points;
}

void add_line(Overlay& overlay, const RingPoints& points, const Colour& colour, float width) {
    for (std::size_t i = 0; i < kSides; ++i) {
        overlay.lines.push_back({points[i], points[(i + 1) % kSides], colour, width});
    }
}

RingPoints image(const MirrorPlane& plane, RingPoints points) {
    for (Vec3& point : points) point = plane.image(point);
    return points;
}

// Adds both rings, and with a plane their images.
void add_rings(Overlay& overlay, const RingPoints& outer, const RingPoints& inner,
               const std::optional<MirrorPlane>& plane, const Colour& colour) {
    add_line(overlay, outer, colour, kOuterWidth);
    add_line(overlay, inner, faded(colour), kInnerWidth);
    if (!plane) return;
    add_line(overlay, image(*plane, outer), kImage, kOuterWidth);
    add_line(overlay, image(*plane, inner), faded(kImage), kInnerWidth);
}

}  // namespace

void add_brush_rings(Overlay& overlay, const ToolContext& context, const Colour& colour) {
    if (!context.hover() || context.sets_pins || context.has_cage()) return;
    const Vec3 centre = context.hover()->point;
    const Vec3 normal = smooth_normal(context.session().mesh(), *context.hover());
    const BrushProfile& profile = context.brush_profile();
    const auto ring_at = [&](double level) {
        return ring(profile, centre, normal, context.radius(), level);
    };
    const auto& plane = context.session().symmetry();
    add_rings(overlay, ring_at(kEndOfMotion), ring_at(0.5), plane, colour);
    overlay.points.push_back({centre, colour, 6.0f});
    if (plane) overlay.points.push_back({plane->image(centre), kImage, 6.0f});
}

void add_drag_rings(Overlay& overlay, const ToolContext& context, const Vec3& normal,
                    const Vec3& to, const Colour& colour) {
    if (context.is_working() || context.has_cage()) return;
    const std::optional<Lattice> lattice = context.session().lattice_in_use();
    if (!lattice) return;
    const Box zone = lattice->influenced_zone();
    const Vec3 centre = zone.centre();
    const auto ring_at = [&](double level) {
        return ring(context.brush_profile(), centre, normal, 0.5 * zone.extent().x, level);
    };
    RingPoints inner = ring_at(0.5);
    for (Vec3& point : inner) point += 0.5 * (to - centre);
    std::optional<MirrorPlane> plane = context.session().symmetry();
    if (plane && plane->offset(centre) == 0.0) plane.reset();
    add_rings(overlay, ring_at(kEndOfMotion), inner, plane, colour);
}

}  // namespace pectin
