#include "adapt/split_order.h"

namespace pectin {

HalfEdgeId SplitOrder::first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const {
    const TriMesh& mesh = active.mesh();
    const auto rest_edge_of = [&](HalfEdgeId side) {
        const EdgeId e = mesh.edge(side);
        return rest_edge(active, e, static_cast<double>(active.uncached_rest_length(e)));
    };
    // The squared length by the corners of this face, which are at hand. It is that of the edge,
    // bit for bit, since the order of the ends only changes signs.
    const auto is_below_floor = [&](HalfEdgeId side) {
        const Vec3 along = mesh.position(mesh.target(side)) - mesh.position(mesh.origin(side));
        return floor.forbids_split(glm::dot(along, along));
    };
    HalfEdgeId first = TriMesh::half_edge(TriMesh::face(h), 0);
    RestEdge longest = rest_edge_of(first);
    bool is_first_below = is_below_floor(first);
    for (int corner = 1; corner < 3; ++corner) {
        const HalfEdgeId side = TriMesh::half_edge(TriMesh::face(h), corner);
        const bool is_below = is_below_floor(side);
        const RestEdge candidate = rest_edge_of(side);
        const bool is_better =
            is_below == is_first_below ? precedes(candidate, longest) : is_first_below;
        if (!is_better) continue;
        first = side;
        longest = candidate;
        is_first_below = is_below;
    }
    return first;
}

}  // namespace pectin
