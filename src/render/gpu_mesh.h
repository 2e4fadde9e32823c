// The mesh in graphics memory, updated by uploading only what changed.
//
// There is a vertex for each wedge slot (position relative to the object's centre, normal, level)
// and an index triple for each face slot, so that an edit of the mesh changes as few slots here as
// there. A deleted face has the triple 0, 0, 0, which covers no pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/tri_mesh.h"
#include "render/gl_object.h"

namespace pectin {

// The layout that mesh.vert reads.
struct GpuVertex {
    Vec3f position{0.0f};  // world space, relative to the centre
    Vec3f normal{0.0f};    // unit, or 0 if undefined
    std::uint16_t level = 0;
    std::uint16_t deformed = 0;  // 1 if a committed gesture has moved it
};
static_assert(sizeof(GpuVertex) == 28);

using GpuTriangle = glm::u32vec3;
static_assert(sizeof(GpuTriangle) == 12);

// A buffer that keeps its contents when it grows. It grows by at least half, so that repeated
// growth costs amortised O(1) per element.
class GrowingBuffer {
  public:
    GrowingBuffer(const Gl& gl, std::size_t element_bytes)
        : gl_(&gl), buffer_(gl), element_bytes_(element_bytes) {}

    // Returns whether the buffer was replaced, so that it must be bound again. Contents are copied
    // on the GPU.
    bool reserve(std::size_t elements);
    // Discards the contents.
    void clear(std::size_t elements);
    void write(std::size_t first, std::size_t count, const void* data);

    GLuint name() const { return buffer_.name(); }
    std::size_t capacity() const { return capacity_; }

  private:
    const Gl* gl_;
    GlBuffer buffer_;
    std::size_t element_bytes_, capacity_ = 0;
};

class GpuMesh {
  public:
    struct Upload {
        std::size_t bytes = 0;
        std::size_t ranges = 0;  // number of upload calls
    };

    explicit GpuMesh(const Gl& gl);

    // Uploads the whole mesh. Positions are relative to `centre` until the next upload; it should
    // be near the object for the precision of floats. Cost: O(mesh).
    Upload upload(const TriMesh& mesh, const Vec3& centre);
    // The same with the centre of the mesh's bounding box.
    Upload upload(const TriMesh& mesh);

    // Uploads what an edit changed. Both lists may be in any order and contain duplicates.
    // wedges: moved and inserted wedges; removed ones may be listed. faces: slots whose face was
    // inserted or removed or has other corners. Cost: O(k log k) for lists of length k.
    // Precondition: `mesh` is the uploaded mesh and has no other changes since then.
    Upload update(const TriMesh& mesh, std::span<const WedgeId> wedges,
                  std::span<const FaceId> faces);

    // Draws all face slots. The attributes are 0 position, 1 normal, 2 level and deformed.
    void draw() const;

    const Vec3& centre() const { return centre_; }
    // In world space. Contains everything uploaded since the last upload of the whole mesh, so it
    // grows at once but shrinks only then.
    const Box& bounds() const { return bounds_; }
    std::uint32_t face_slots() const { return face_slots_; }

  private:
    void record_corners(const TriMesh& mesh, FaceId f);
    void bind_buffers() const;
    GpuVertex vertex(const TriMesh& mesh, WedgeId w) const;
    void write_vertices(const TriMesh& mesh, std::uint32_t first, std::uint32_t end,
                        Upload& upload);
    void write_triangles(const TriMesh& mesh, std::uint32_t first, std::uint32_t end,
                         Upload& upload);

    const Gl* gl_;
    GlVertexArray vertex_array_;
    GrowingBuffer vertices_, triangles_;
    Vec3 centre_{0.0};
    Box bounds_;
    std::uint32_t face_slots_ = 0;
    // By wedge slot: the vertex as recorded from a face. Entries of removed wedges may be stale.
    std::vector<VertexId> wedge_vertices_;
    // Temporary arrays, kept for their capacity.
    std::vector<std::uint32_t> sorted_;
    std::vector<GpuVertex> staged_vertices_;
    std::vector<GpuTriangle> staged_triangles_;
};

}  // namespace pectin
