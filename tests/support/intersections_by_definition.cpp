#include "support/intersections_by_definition.h"

#include <algorithm>
#include <vector>

#include "geometry/box.h"
#include "geometry/piercing.h"
#include "support/mesh_figures.h"

namespace pectin::test {
namespace {

// An edge and a face closer than this at rest, as a fraction of the edge's length, touch.
constexpr double kTouching = 1e-9;

struct Element {  // an edge (two corners) or a face (three)
    std::vector<VertexId> corners;
    Box box;
    bool moves = false;
};

struct Precise {
    long double x, y, z;
};

Precise difference(const Vec3& a, const Vec3& b) {
    return {static_cast<long double>(a.x) - static_cast<long double>(b.x),
            static_cast<long double>(a.y) - static_cast<long double>(b.y),
            static_cast<long double>(a.z) - static_cast<long double>(b.z)};
}

// The sign of the determinant |b - a, c - a, d - a|: on which side of the triangle abc d lies.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Precise u = difference(b, a), v = difference(c, a), w = difference(d, a);
    const long double determinant = u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) +
                                    u.z * (v.x * w.y - v.y * w.x);
    return (determinant > 0) - (determinant < 0);
}

bool intersect(const TriMesh& mesh, const Element& edge, const Element& face) {
    const Vec3 &p = mesh.position(edge.corners[0]), &q = mesh.position(edge.corners[1]);
    const Vec3 &a = mesh.position(face.corners[0]), &b = mesh.position(face.corners[1]),
               &c = mesh.position(face.corners[2]);
    if (side(a, b, c, p) * side(a, b, c, q) != -1) return false;
    const int around = side(p, q, a, b);
    return around != 0 && side(p, q, b, c) == around && side(p, q, c, a) == around;
}

bool were_apart(const TriMesh& rest, const Element& edge, const Element& face) {
    const Vec3 &p = rest.position(edge.corners[0]), &q = rest.position(edge.corners[1]);
    const double touching = kTouching * glm::distance(p, q);
    return squared_distance(p, q, rest.position(face.corners[0]), rest.position(face.corners[1]),
                            rest.position(face.corners[2])) > touching * touching;
}

Element element(std::vector<VertexId> corners, const TriMesh& now, const TriMesh& rest) {
    Element result{std::move(corners), {}, false};
    for (VertexId v : result.corners) {
        result.box.include(now.position(v));
        result.moves |= now.position(v) != rest.position(v);
    }
    return result;
}

void sort_along_x(std::vector<Element>& elements) {
    std::ranges::sort(elements, {}, [](const Element& element) { return element.box.min.x; });
}

bool share_a_corner(const Element& edge, const Element& face) {
    return std::ranges::find_first_of(edge.corners, face.corners) != edge.corners.end();
}

}  // namespace

std::size_t new_intersections(const TriMesh& now, const TriMesh& rest) {
    std::vector<Element> edges, faces;
    for (EdgeId e : live_edges(now)) {
        const HalfEdgeId h = now.half_edge(e);
        edges.push_back(element({now.origin(h), now.target(h)}, now, rest));
    }
    for (FaceId f : live_faces(now)) {
        const HalfEdgeId h = TriMesh::half_edge(f, 0);
        faces.push_back(
            element({now.origin(h), now.target(h), now.origin(TriMesh::prev(h))}, now, rest));
    }
    sort_along_x(edges);
    sort_along_x(faces);
    std::size_t count = 0;
    std::vector<const Element*> swept;  // faces that begin before the edge and may reach it
    auto next = faces.begin();
    for (const Element& edge : edges) {
        for (; next != faces.end() && next->box.min.x <= edge.box.max.x; ++next) {
            swept.push_back(&*next);
        }
        std::erase_if(swept, [&](const Element* face) { return face->box.max.x < edge.box.min.x; });
        for (const Element* face : swept) {
            if ((edge.moves || face->moves) && face->box.meets(edge.box) &&
                !share_a_corner(edge, *face) && intersect(now, edge, *face) &&
                were_apart(rest, edge, *face)) {
                ++count;
            }
        }
    }
    return count;
}

}  // namespace pectin::test
