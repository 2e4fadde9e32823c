// The vertices of a mesh as its input shares them: each side of an unshared seam has its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin {

// The mesh as it is when this is made. Where it has no unshared seams each corner's vertex is its
// own; where it has, corners at base vertices have those that the input gave them, and corners at
// a vertex that was inserted on a seam have one for each pair of input vertices that its base edge
// runs between on their side.
class UnsharedVertices {
  public:
    explicit UnsharedVertices(const TriMesh& mesh);  // O(1) without seams, else O(n log n)

    // Below vertex_slots() a vertex of the mesh, from there on an added one.
    std::uint32_t of(HalfEdgeId corner) const;
    // The vertex of the mesh that each added one lies at.
    std::span<const VertexId> added() const { return added_; }
    // Where a vertex lies: at its representative.
    const Vec3& position(VertexId v) const;
    // All edges along seams.
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
