#include "session/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

double smallest_angle(const TriMesh& mesh, FaceId f) {
    double smallest = std::numbers::pi;
    for (int corner = 0; corner < 3; ++corner) {
        const HalfEdgeId h = TriMesh::half_edge(f, corner);
        const Vec3& p = mesh.position(mesh.origin(h));
        const Vec3 u = mesh.position(mesh.target(h)) - p;
        const Vec3 v = mesh.position(mesh.origin(TriMesh::prev(h))) - p;
        smallest = std::min(smallest, std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
    }
    return smallest;
}

}  // namespace

void measure(const TriMesh& mesh, Statistics& statistics) {
    statistics.vertices = mesh.vertex_count();
    statistics.faces = mesh.face_count();
    statistics.base_vertices = mesh.base_vertex_count();
    statistics.base_faces = mesh.base_face_count();
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        statistics.max_level = std::max(statistics.max_level, int{mesh.level(VertexId{i})});
    }
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (!mesh.is_live(EdgeId{i})) continue;
        statistics.edge_max = std::max(statistics.edge_max, mesh.length(EdgeId{i}));
    }
    double smallest = mesh.face_count() > 0 ? std::numbers::pi : 0.0;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_live(FaceId{i})) smallest = std::min(smallest, smallest_angle(mesh, FaceId{i}));
    }
    statistics.angle_min_deg = smallest * 180.0 / std::numbers::pi;
}

}  // namespace pectin
