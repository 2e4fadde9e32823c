// Counts what build_mesh had to change to get a mesh of manifold triangles.
#pragma once

#include <cstdint>

namespace pectin {

class TriMesh;

// Nothing is lost: a save writes cut, triangulated and degenerate polygons as they were.
struct BuildReport {
    std::uint32_t triangulated_polygons = 0;  // polygons with more than three corners
    std::uint32_t crossing_polygons = 0;      // no triangles found that cover them exactly
    std::uint32_t degenerate_polygons = 0;    // fewer than three different vertices; not shown
    std::uint32_t repeated_corners = 0;       // other polygons that name a vertex more than once
    std::uint32_t zero_area_faces = 0;        // triangles whose corners lie on a line
    std::uint32_t duplicate_faces = 0;        // triangles on the same vertices as an earlier one
    std::uint32_t nonmanifold_edges = 0;      // more than two faces; cut into sheets
    std::uint32_t misoriented_edges = 0;      // two faces that disagree on direction; cut
    std::uint32_t nonmanifold_vertices = 0;   // shared by several sheets
    std::uint32_t seams = 0;                  // runs of edges whose faces share no vertices
    std::uint32_t seam_edges = 0;             // edges of these seams; their faces are joined
    std::uint32_t boundary_edges = 0;         // one face
    std::uint32_t isolated_vertices = 0;      // no face
    std::uint32_t lines = 0, points = 0;      // elements; kept as they are

    bool operator==(const BuildReport&) const = default;
};

// Counts zero-area and duplicate faces, boundary edges, and non-manifold and isolated vertices.
// Precondition: the mesh has no splits. Cost: O(n).
void survey(const TriMesh& mesh, BuildReport& report);

}  // namespace pectin
