#include "mesh/build_report.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

// All edges of triangles on the same three vertices are cut, so only such triangles are compared.
std::uint32_t count_duplicates(const TriMesh& mesh) {
    std::vector<std::array<VertexId, 3>> faces;
    for (std::uint32_t f = 0; f < mesh.base_face_count(); ++f) {
        std::array<VertexId, 3> corners;
        bool is_cut_off = true;
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, c);
            corners[static_cast<std::size_t>(c)] = mesh.origin(h);
            is_cut_off = is_cut_off && mesh.sibling(mesh.edge(h)) != mesh.edge(h);
        }
        if (!is_cut_off) continue;
        std::sort(corners.begin(), corners.end());
        faces.push_back(corners);
    }
    std::sort(faces.begin(), faces.end());
    const auto distinct = std::unique(faces.begin(), faces.end());
    return static_cast<std::uint32_t>(faces.end() - distinct);
}

// The number of corners that are connected with an outgoing half-edge of a vertex.
std::uint32_t corners_in_sheet(const TriMesh& mesh, HalfEdgeId first) {
    std::uint32_t count = 1;
    HalfEdgeId twin = mesh.twin(first);
    for (; exists(twin); twin = mesh.twin(TriMesh::next(twin))) {
        if (TriMesh::next(twin) == first) return count;
        ++count;
    }
    // The sheet is open, so walk in the other direction, too.
    for (twin = mesh.twin(TriMesh::prev(first)); exists(twin);
         twin = mesh.twin(TriMesh::prev(twin))) {
        ++count;
    }
    return count;
}

// Whether v represents other vertices of the input, so that sheets share it which do not share a
// vertex in the input; or whether v is one of the vertices that another represents.
std::vector<bool> joined_vertices(const TriMesh& mesh) {
    const std::vector<VertexId>& representatives = mesh.input_form().seams.representatives;
    std::vector<bool> is_joined(mesh.vertex_slots(), false);
    for (std::uint32_t v = 0; v < representatives.size(); ++v) {
        if (representatives[v] == VertexId{v}) continue;
        is_joined[v] = is_joined[index(representatives[v])] = true;
    }
    return is_joined;
}

std::uint32_t count_nonmanifold_vertices(const TriMesh& mesh, const std::vector<bool>& is_joined) {
    std::vector<std::uint32_t> corners(mesh.vertex_slots(), 0);
    for (std::uint32_t h = 0; h < 3 * mesh.face_slots(); ++h) {
        ++corners[index(mesh.origin(HalfEdgeId{h}))];
    }
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (corners[v] == 0 || is_joined[v]) continue;
        if (corners_in_sheet(mesh, mesh.half_edge(VertexId{v})) < corners[v]) ++count;
    }
    return count;
}

}  // namespace

void survey(const TriMesh& mesh, BuildReport& report) {
    for (std::uint32_t f = 0; f < mesh.base_face_count(); ++f) {
        report.zero_area_faces += mesh.area_normal(FaceId{f}) == Vec3{0.0} ? 1 : 0;
    }
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
        const bool is_boundary = !exists(mesh.twin(mesh.half_edge(EdgeId{e})));
        report.boundary_edges += is_boundary && mesh.sibling(EdgeId{e}) == EdgeId{e} ? 1 : 0;
    }
    const std::vector<bool> is_joined = joined_vertices(mesh);
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        const bool has_face = exists(mesh.half_edge(VertexId{v})) || is_joined[v];
        report.isolated_vertices += has_face ? 0 : 1;
    }
    report.duplicate_faces = count_duplicates(mesh);
    report.nonmanifold_vertices = count_nonmanifold_vertices(mesh, is_joined);
}

}  // namespace pectin
