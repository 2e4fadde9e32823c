#include "adapt/split_order.h"

namespace pectin {

HalfEdgeId SplitOrder::first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const {
    const TriMesh& mesh = active.mesh();
    const FaceId face = TriMesh::face(h);
    // The squared length by the corners of this face, which are at hand. It is that of the edge,
    // bit for bit, since the order of the ends only changes signs.
    const auto is_below_floor = [&](HalfEdgeId side) {
        const Vec3 along = mesh.position(mesh.target(side)) - mesh.position(mesh.origin(side));
        return floor.forbids_split(glm::dot(along, along));
    };
    const auto first_of = [&](auto counts) {
        HalfEdgeId first = kNone<HalfEdgeId>;
        RestEdge longest;
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId side = TriMesh::half_edge(face, corner);
            if (!counts(side)) continue;
            const EdgeId e = mesh.edge(side);
            const RestEdge candidate =
                rest_edge(active, e, static_cast<double>(active.uncached_rest_length(e)));
            if (exists(first) && !precedes(candidate, longest)) continue;
            first = side;
            longest = candidate;
        }
        return first;
    };
    const HalfEdgeId first = first_of([](HalfEdgeId) { return true; });
    if (!is_below_floor(first)) return first;
    const HalfEdgeId first_above = first_of([&](HalfEdgeId side) { return !is_below_floor(side); });
    return exists(first_above) ? first_above : first;
}

}  // namespace pectin
