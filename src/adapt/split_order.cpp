#include "adapt/split_order.h"

#include <array>
#include <type_traits>

namespace pectin {

HalfEdgeId SplitOrder::first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const {
    return symmetry_ ? first_edge<RestEdge>(active, h, floor)
                     : first_edge<double>(active, h, floor);
}

// Edge: RestEdge with symmetry. Without it the length is enough and is much faster.
template <typename Edge>
HalfEdgeId SplitOrder::first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const {
    const TriMesh& mesh = active.mesh();
    const FaceId face = TriMesh::face(h);
    std::array<Edge, 3> at_rest;
    for (int corner = 0; corner < 3; ++corner) {
        const EdgeId e = mesh.edge(TriMesh::half_edge(face, corner));
        const auto length = static_cast<double>(active.uncached_rest_length(e));
        if constexpr (std::is_same_v<Edge, RestEdge>) {
            at_rest[static_cast<std::size_t>(corner)] = rest_edge(active, e, length);
        } else {
            at_rest[static_cast<std::size_t>(corner)] = length;
        }
    }
    // The squared length by the corners of this face, which are at hand. It is that of the edge,
    // bit for bit, since the order of the ends only changes signs.
    const auto is_below_floor = [&](int corner) {
        const HalfEdgeId side = TriMesh::half_edge(face, corner);
        const Vec3 along = mesh.position(mesh.target(side)) - mesh.position(mesh.origin(side));
        return floor.forbids_split(glm::dot(along, along));
    };
    const auto first_of = [&](auto counts) {
        int first = -1;
        for (int corner = 0; corner < 3; ++corner) {
            if (!counts(corner)) continue;
            if (first < 0 || precedes(at_rest[static_cast<std::size_t>(corner)],
                                      at_rest[static_cast<std::size_t>(first)])) {
                first = corner;
            }
        }
        return first;
    };
    const int first = first_of([](int) { return true; });
    if (!is_below_floor(first)) return TriMesh::half_edge(face, first);
    const int first_above = first_of([&](int corner) { return !is_below_floor(corner); });
    return TriMesh::half_edge(face, first_above < 0 ? first : first_above);
}

}  // namespace pectin
