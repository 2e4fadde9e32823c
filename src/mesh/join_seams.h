// Joins faces that meet along an edge without sharing its vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

struct JoinedSeams {
    std::vector<VertexId> representatives;  // see UnsharedSeams
    std::vector<VertexId> corner_vertices;
    std::vector<HalfEdgeId> half_edges;  // along seams, ascending
    std::uint32_t seams = 0, edges = 0;  // connected runs of coinciding edges, and those edges
    // Half-edges that become siblings, one run after another: those without a twin that share both
    // ends with another half-edge, along seams and elsewhere.
    std::vector<HalfEdgeId> cut;
    std::vector<std::size_t> cut_ends;
};

// Edges coincide if both their ends have equal positions. The ends of a boundary edge are joined
// with those of the edges that coincide with it, except vertices of a triangle that has two corners
// at one position. half_edges: 3 n_faces, with twins that share both vertices; their origins become
// the representatives, which are the lowest of the joined vertices. Two boundary edges that run in
// opposite directions become twins. If there are more, or an inner edge is among them, all their
// half-edges become siblings without a twin. Returns none if there is no seam. Cost: O(n log b),
// with b boundary edges; O(n) if there are none.
std::optional<JoinedSeams> join_seams(std::span<const Vec3> positions,
                                      std::span<HalfEdge> half_edges);

}  // namespace pectin
