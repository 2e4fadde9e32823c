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

// Two or more boundary edges coincide where both their ends have equal positions; their ends are
// then joined, except vertices of a triangle that has two corners at one position. half_edges (3
// n_faces) are those of a mesh whose twins share both vertices; their origins become the
// representatives, which are the lowest of the joined vertices, and two that run in opposite
// directions along a seam become twins. Nothing if there is no seam. Cost: O(b log b) in the
// boundary edges, and O(n) if any coincide.
std::optional<JoinedSeams> join_seams(std::span<const Vec3> positions,
                                      std::span<HalfEdge> half_edges);

}  // namespace pectin
