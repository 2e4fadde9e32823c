// The vertices of a mesh with separate vertices on each side of an unshared seam, as in the input.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

// Describes the mesh at the time of construction. Without unshared seams every corner has the
// vertex that it has in the mesh. With seams, a corner at a base vertex has the vertex of the
// input; at a vertex that was inserted on a seam, corners have a common vertex if the base edge
// runs between the same two input vertices on their sides.
class UnsharedVertices {
  public:
    explicit UnsharedVertices(const TriMesh& mesh);  // O(1) without seams, otherwise O(n log n)

    // A vertex of the mesh if below vertex_slots(); otherwise vertex_slots() plus an index into
    // added().
    std::uint32_t of(HalfEdgeId corner) const;
    // For each added vertex the vertex of the mesh at the same position.
    std::span<const VertexId> added() const { return added_; }
    // The position of v's representative.
    const Vec3& position(VertexId v) const;
    // All edges along seams, including pieces of base edges.
    std::span<const EdgeId> edges() const { return edges_; }

  private:
    class Walk;
    VertexId base_corner(HalfEdgeId corner) const;

    const TriMesh& mesh_;
    std::vector<std::uint32_t> vertices_;  // 3 n_face_slots, or empty; none: as in the mesh
    std::vector<VertexId> added_;
    std::vector<EdgeId> edges_;
};

}  // namespace pectin
