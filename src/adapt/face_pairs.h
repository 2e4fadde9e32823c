// Tests of pairs of faces, and of an edge and a face, for intersections.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/piercing.h"
#include "mesh/active_set.h"
#include "mesh/sort_ids.h"

namespace pectin::face_pairs {

// An edge and a face closer than this at rest, as a fraction of the edge's length, touch.
// Boundaries may lie along each other without sharing vertices, and rounding must not count as
// distance.
inline constexpr double kTouchingFraction = 1e-9;

using Corners = std::array<VertexId, 3>;

inline Corners corners_of(const TriMesh& mesh, FaceId f) {
    const HalfEdgeId h = TriMesh::half_edge(f, 0);
    return {mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h))};
}

inline bool has(const Corners& corners, VertexId v) {
    return corners[0] == v || corners[1] == v || corners[2] == v;
}

inline bool is_live(const TriMesh& mesh, FaceId f) {
    return index(f) < mesh.face_slots() && mesh.is_live(f);
}

// The live ones among the faces, sorted, each once.
inline std::vector<FaceId> live(const TriMesh& mesh, std::vector<FaceId> faces) {
    std::erase_if(faces, [&](FaceId f) { return !is_live(mesh, f); });
    sort_ids(std::span(faces));
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

inline Box box_of(const TriMesh& mesh, const Corners& face) {
    Box box;
    for (VertexId v : face) box.include(mesh.position(v));
    return box;
}

inline bool has_moved(const ActiveSet& active, FaceId f) {
    return std::ranges::any_of(corners_of(active.mesh(), f), [&](VertexId v) {
        return active.mesh().position(v) != active.rest_position(v);
    });
}

inline double rest_distance(const ActiveSet& active, VertexId p, VertexId q, const Corners& face) {
    return std::sqrt(squared_distance(active.rest_position(p), active.rest_position(q),
                                      active.rest_position(face[0]), active.rest_position(face[1]),
                                      active.rest_position(face[2])));
}

inline bool were_disjoint(const ActiveSet& active, VertexId p, VertexId q, const Corners& face) {
    const double length = glm::distance(active.rest_position(p), active.rest_position(q));
    return rest_distance(active, p, q, face) > kTouchingFraction * length;
}

inline bool passes_through(const TriMesh& mesh, VertexId p, VertexId q, const Corners& face) {
    return !has(face, p) && !has(face, q) &&
           pierces(mesh.position(p), mesh.position(q), mesh.position(face[0]),
                   mesh.position(face[1]), mesh.position(face[2]));
}

// Whether all corners of g lie on one side of the plane of f, or on it.
inline bool is_on_one_side(const TriMesh& mesh, const Corners& f, const Corners& g) {
    const Vec3& at = mesh.position(f[0]);
    const Vec3 normal = glm::cross(mesh.position(f[1]) - at, mesh.position(f[2]) - at);
    double least = 0.0, greatest = 0.0;
    for (VertexId v : g) {
        // A shared corner lies in the plane, whatever rounding says.
        const double height = has(f, v) ? 0.0 : glm::dot(normal, mesh.position(v) - at);
        least = std::min(least, height);
        greatest = std::max(greatest, height);
    }
    return least >= 0.0 || greatest <= 0.0;
}

inline bool may_intersect(const TriMesh& mesh, const Corners& f, const Corners& g) {
    return !is_on_one_side(mesh, f, g) && !is_on_one_side(mesh, g, f);
}

}  // namespace pectin::face_pairs
