#include "mesh/connected_part.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/disjoint_sets.h"

namespace pectin {
namespace {

// What connects faces: a vertex in a zone (named twice), or the two ends of an edge.
struct SharedElement {
    VertexId first, second;
    std::size_t face;  // index into the faces
};

bool meets_any(const Vec3& a, const Vec3& b, std::span<const Box> zones) {
    return std::any_of(zones.begin(), zones.end(),
                       [&](const Box& zone) { return triangle_meets_box(a, b, b, zone); });
}

bool is_inside_any(const Vec3& p, std::span<const Box> zones) {
    return std::any_of(zones.begin(), zones.end(),
                       [&](const Box& zone) { return zone.contains_strictly(p); });
}

std::vector<SharedElement> shared_elements(const TriMesh& mesh, std::span<const FaceId> faces,
                                           std::span<const Box> zones) {
    std::vector<SharedElement> elements;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(faces[f], corner);
            const VertexId v = mesh.origin(h), w = mesh.target(h);
            if (is_inside_any(mesh.position(v), zones)) {
                elements.push_back({v, v, f});
            } else if (!is_inside_any(mesh.position(w), zones) &&
                       meets_any(mesh.position(v), mesh.position(w), zones)) {
                elements.push_back({std::min(v, w), std::max(v, w), f});
            }
        }
    }
    std::sort(elements.begin(), elements.end(), [](const SharedElement& a, const SharedElement& b) {
        return std::tie(a.first, a.second, a.face) < std::tie(b.first, b.second, b.face);
    });
    return elements;
}

}  // namespace

std::vector<FaceId> connected_part(const TriMesh& mesh, std::span<const FaceId> faces,
                                   std::span<const FaceId> seeds, std::span<const Box> zones) {
    DisjointSets parts(faces.size());
    const std::vector<SharedElement> elements = shared_elements(mesh, faces, zones);
    for (std::size_t i = 1; i < elements.size(); ++i) {
        if (elements[i].first == elements[i - 1].first &&
            elements[i].second == elements[i - 1].second) {
            parts.join(elements[i].face, elements[i - 1].face);
        }
    }
    std::vector<bool> is_reached(faces.size(), false);
    for (const FaceId seed : seeds) {
        const auto at = std::lower_bound(faces.begin(), faces.end(), seed);
        if (at == faces.end() || *at != seed) continue;
        is_reached[parts.find(static_cast<std::size_t>(at - faces.begin()))] = true;
    }
    std::vector<FaceId> part;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (is_reached[parts.find(f)]) part.push_back(faces[f]);
    }
    return part;
}

}  // namespace pectin
