// The faces that a drag moves, and the vertices at its handles.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "geometry/decimal.h"
#include "mesh/connected_part.h"
#include "mesh/sort_ids.h"
#include "session/session_state.h"

namespace pectin {
namespace {

// A vertex whose distance from a handle is at most this fraction of its largest coordinate is that
// handle. Mirror images differ by rounding, some units in the last place for each drag.
constexpr double kSamePoint = 0x1p-40;

double largest_component(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

// With symmetry, the mirror image of a zone may differ from the other zone by rounding. Both are
// searched, so that the mirror image of a face that just meets a zone is found, too.
std::vector<Box> Session::State::zones_on_both_sides(const Warp& warp) const {
    std::vector<Box> zones = warp.zones();
    if (!symmetry) return zones;
    const std::size_t count = zones.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Box image = symmetry->image(zones[i]);
        if (std::ranges::find(zones, image) == zones.end()) zones.push_back(image);
    }
    return zones;
}

// The zones, and beyond them as far as the exact surface may be from a face that lies outside. It
// is moved where it reaches into a zone, and may then be somewhat farther away.
Box Session::State::with_error_margin(Box zone) const {
    if (adapt_settings.trigger != command::Adapt::Trigger::certified) return zone;
    const double margin = 2.0 * outcome.error.total.value_or(0.0);
    return {.min = zone.min - margin, .max = zone.max + margin};
}

// Sorted.
std::vector<FaceId> Session::State::faces_meeting(std::span<const Box> zones) {
    std::vector<FaceId> faces;
    for (const Box& zone : zones) {
        const std::vector<FaceId> there = face_tree().faces_meeting(zone, *mesh);
        faces.insert(faces.end(), there.begin(), there.end());
    }
    if (zones.size() > 1) {
        sort_ids(std::span(faces));
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    return faces;
}

// Those of a fold-free drag. The mesh is in its rest state.
Surroundings Session::State::surroundings() {
    const ActiveGesture& gesture = *active_gesture;
    if (!gesture.drag.fold_free || !adapt_settings.enabled) return {};
    return {.tree = &face_tree(),
            .zones = zones_on_both_sides(gesture.gesture->warp()),
            .are_empty = active->faces().size() == mesh->face_count()};
}

// The faces that a connected drag with these displacements leaves alone and may pass through. The
// mesh is in its rest state. A fold-free drag moves nothing out of its zones, and refinement keeps
// the triangles there small.
std::vector<FaceId> Session::State::staying_faces(std::span<const Vec3> displacements) {
    std::vector<FaceId> staying;
    const ActiveGesture& gesture = *active_gesture;
    if (!gesture.drag.connected || active->faces().size() == mesh->face_count()) return staying;
    if (gesture.drag.fold_free && adapt_settings.enabled) return gesture.staying;
    std::vector<Box> boxes = gesture.gesture->zones_with_reach(displacements);
    Box box_of_part;
    for (const Vec3& rest : active->rest_positions()) box_of_part.include(rest);
    boxes.push_back(box_of_part);
    const std::vector<FaceId> near = faces_meeting(boxes);
    std::ranges::set_difference(near, active->faces(), std::back_inserter(staying));
    return staying;
}

// All faces that meet the zones; with `connected` only the part of them moves that is connected to
// the handles.
Result<GestureFaces> Session::State::faces_of(const command::Drag& drag,
                                              std::span<const Box> zones) {
    if (!drag.connected) {
        std::vector<Box> reached;
        for (const Box& zone : zones) reached.push_back(with_error_margin(zone));
        return GestureFaces{.moving = faces_meeting(reached)};
    }
    const std::vector<FaceId> faces = faces_meeting(zones);
    std::vector<FaceId> seeds;
    for (const Move& move : drag.moves) {
        if (const auto face = face_tree().nearest(move.from, *mesh)) seeds.push_back(*face);
        if (!symmetry) continue;
        const auto opposite = face_tree().nearest(symmetry->image(move.from), *mesh);
        if (opposite) seeds.push_back(*opposite);
    }
    ConnectedPart part = connected_part(*mesh, faces, seeds, zones);
    if (part.faces.empty()) {
        return Refusal{
            "the surface nearest to " + decimal(drag.moves.front().from) +
                " does not reach into the influenced zone; drag a point of the surface, or without "
                "connected",
            "moves"};
    }
    return GestureFaces{.moving = std::move(part.faces), .staying = std::move(part.others)};
}

// The vertices at handles and pins, with symmetry on both sides of the plane. A point between
// vertices has none.
std::vector<VertexId> Session::State::vertices_at_handles(const command::Drag& drag) {
    std::vector<Vec3> points = drag.pins;
    for (const Move& move : drag.moves) points.push_back(move.from);
    if (symmetry) {
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i) points.push_back(symmetry->image(points[i]));
    }
    std::vector<VertexId> vertices;
    for (const Vec3& point : points) {
        const auto face = face_tree().nearest(point, *mesh);
        for (int corner = 0; face && corner < 3; ++corner) {
            const VertexId v = mesh->origin(TriMesh::half_edge(*face, corner));
            const double most = kSamePoint * largest_component(point);
            if (glm::distance(mesh->position(v), point) <= most) vertices.push_back(v);
        }
    }
    return vertices;
}

}  // namespace pectin
