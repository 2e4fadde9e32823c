#include "mesh/tri_mesh.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "mesh/array_bytes.h"

namespace pectin {
namespace {

// Drops the ids past `count`. They lie below all others: slots are only added while the free
// list is empty.
template <typename Id>
void drop_past(GrowingArray<Id>& free, std::uint32_t count) {
    auto* const kept =
        std::find_if(free.begin(), free.end(), [count](Id id) { return index(id) < count; });
    assert(std::none_of(kept, free.end(), [count](Id id) { return index(id) >= count; }));
    free.resize(static_cast<std::size_t>(std::move(kept, free.end(), free.begin()) - free.begin()));
}

}  // namespace

std::uint32_t TriMesh::vertex_count() const {
    return vertex_slots() - static_cast<std::uint32_t>(free_vertices_.size());
}

std::uint32_t TriMesh::edge_count() const {
    return edge_slots() - static_cast<std::uint32_t>(free_edges_.size());
}

std::uint32_t TriMesh::face_count() const {
    return face_slots() - static_cast<std::uint32_t>(free_faces_.size());
}

Box TriMesh::bounding_box() const {
    Box box;
    for (std::uint32_t v = 0; v < vertex_slots(); ++v) {
        if (exists(vertex_half_edges_[v])) box.include(positions_[v]);
    }
    return box;
}

Vec3 TriMesh::area_normal(FaceId f) const {
    const Vec3& a = position(origin(half_edge(f, 0)));
    const Vec3& b = position(origin(half_edge(f, 1)));
    const Vec3& c = position(origin(half_edge(f, 2)));
    return glm::cross(b - a, c - a);
}

void TriMesh::shrink(const SlotCounts& counts) {
    drop_past(free_vertices_, counts.vertices);
    drop_past(free_wedges_, counts.wedges);
    drop_past(free_edges_, counts.edges);
    drop_past(free_faces_, counts.faces);
    for_each_array_of_vertices([&](auto& slots) { slots.resize(counts.vertices); });
    for_each_array_of_wedges([&](auto& slots) { slots.resize(counts.wedges); });
    for_each_array_of_edges([&](auto& slots) { slots.resize(counts.edges); });
    half_edges_.resize(3 * std::size_t{counts.faces});
    face_bases_.resize(counts.faces);
}

bool TriMesh::operator==(const TriMesh& o) const {
    return base_vertices_ == o.base_vertices_ && base_faces_ == o.base_faces_ && form_ == o.form_ &&
           same_bytes(colors_, o.colors_) && same_bytes(positions_, o.positions_) &&
           same_bytes(vertex_half_edges_, o.vertex_half_edges_) &&
           same_bytes(vertex_levels_, o.vertex_levels_) && same_bytes(deformed_, o.deformed_) &&
           same_bytes(normals_, o.normals_) && same_bytes(uvs_, o.uvs_) &&
           same_bytes(edge_half_edges_, o.edge_half_edges_) &&
           same_bytes(edge_levels_, o.edge_levels_) && same_bytes(siblings_, o.siblings_) &&
           half_edges_ == o.half_edges_ && same_bytes(face_bases_, o.face_bases_) &&
           free_vertices_ == o.free_vertices_ && free_wedges_ == o.free_wedges_ &&
           free_edges_ == o.free_edges_ && free_faces_ == o.free_faces_;
}

std::size_t TriMesh::memory_bytes() const {
    return capacity_bytes(positions_) + capacity_bytes(vertex_half_edges_) +
           capacity_bytes(vertex_levels_) + capacity_bytes(deformed_) + capacity_bytes(colors_) +
           capacity_bytes(normals_) + capacity_bytes(uvs_) + capacity_bytes(edge_half_edges_) +
           capacity_bytes(edge_levels_) + capacity_bytes(siblings_) + capacity_bytes(half_edges_) +
           capacity_bytes(face_bases_) + capacity_bytes(base_faces_) + form_.memory_bytes() +
           capacity_bytes(free_vertices_) + capacity_bytes(free_wedges_) +
           capacity_bytes(free_edges_) + capacity_bytes(free_faces_);
}

}  // namespace pectin
