// Faces that meet along an edge without sharing its vertices, joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

struct JoinedSeams {
    std::vector<VertexId> representatives;  // as in UnsharedSeams
    std::vector<VertexId> corner_vertices;
    std::vector<HalfEdgeId> half_edges;  // along seams, ascending
    std::uint32_t seams = 0, edges = 0;  // connected runs of coinciding edges, and those edges
    // Half-edges that are siblings, run by run: those that share both ends with another and have no
    // twin, along seams and elsewhere.
    std::vector<HalfEdgeId> cut;
    std::vector<std::size_t> cut_ends;
};

// Edges coincide where both their ends have equal positions. Where a boundary edge coincides with
// others, their ends are joined, except vertices of a triangle that has two corners at one
// position. half_edges (3 n_faces) are those of a mesh whose twins share both vertices; their
// origins become the representatives, which are the lowest of the joined vertices. Two boundary
// edges that run in opposite directions become twins; of more, or with an inner edge among them,
// all half-edges become siblings without a twin.
// Nothing if there is no seam. Cost: O(n log b), with b boundary edges; O(n) if there are none.
std::optional<JoinedSeams> join_seams(std::span<const Vec3> positions,
                                      std::span<HalfEdge> half_edges);

}  // namespace pectin
