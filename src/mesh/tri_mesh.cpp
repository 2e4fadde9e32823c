#include "mesh/tri_mesh.h"

#include <algorithm>

#include "mesh/array_bytes.h"

namespace pectin {

EdgeId TriMesh::representative(EdgeId e) const {
    EdgeId lowest = e;
    for (EdgeId s = sibling(e); s != e; s = sibling(s)) lowest = std::min(lowest, s);
    return lowest;
}

bool TriMesh::is_smooth(EdgeId e) const {
    const HalfEdgeId h = half_edge(e), back = twin(h);
    return exists(back) && wedge(h) == wedge(next(back)) && wedge(back) == wedge(next(h));
}

Box TriMesh::bounding_box() const {
    Box box;
    for (std::uint32_t v = 0; v < vertex_slots(); ++v) {
        if (exists(half_edge(VertexId{v}))) box.include(position(VertexId{v}));
    }
    return box;
}

Vec3 TriMesh::area_normal(FaceId f) const {
    const Vec3& a = position(origin(half_edge(f, 0)));
    const Vec3& b = position(origin(half_edge(f, 1)));
    const Vec3& c = position(origin(half_edge(f, 2)));
    return glm::cross(b - a, c - a);
}

void TriMesh::set_kept_slots(const SlotCounts& counts) {
    vertices_.set_kept_slots(counts.vertices);
    wedges_.set_kept_slots(counts.wedges);
    edges_.set_kept_slots(counts.edges);
    faces_.set_kept_slots(counts.faces);
}

bool TriMesh::operator==(const TriMesh& o) const {
    return base_vertices_ == o.base_vertices_ && base_faces_ == o.base_faces_ && form_ == o.form_ &&
           vertices_.has_same_bytes(o.vertices_) && wedges_.has_same_bytes(o.wedges_) &&
           edges_.has_same_bytes(o.edges_) && faces_.has_same_bytes(o.faces_);
}

std::size_t TriMesh::memory_bytes() const {
    return vertices_.memory_bytes() + wedges_.memory_bytes() + edges_.memory_bytes() +
           faces_.memory_bytes() + capacity_bytes(base_faces_) + form_.memory_bytes();
}

}  // namespace pectin
