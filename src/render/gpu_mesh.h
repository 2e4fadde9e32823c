// The mesh in graphics memory, kept up to date by uploading what changed.
//
// A vertex for each wedge slot (position relative to the object's centre, normal, level) and an
// index triple for each face slot, so that an edit of the mesh touches the same few places here;
// a dead face is the triple 0, 0, 0 and covers nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/tri_mesh.h"
#include "render/gl_object.h"

namespace pectin {

// As mesh.vert reads it.
struct GpuVertex {
    Vec3f position{0.0f};  // world, relative to the centre
    Vec3f normal{0.0f};    // unit, or 0: undefined
    std::uint16_t level = 0;
    std::uint16_t deformed = 0;  // 1 where a committed gesture has moved it
};
static_assert(sizeof(GpuVertex) == 28);

using GpuTriangle = glm::u32vec3;
static_assert(sizeof(GpuTriangle) == 12);

// A buffer of elements that keeps its contents when it grows; growth is by half at least, so that
// many small ones cost little.
class GrowingBuffer {
  public:
    GrowingBuffer(const Gl& gl, std::size_t element_bytes)
        : gl_(&gl), buffer_(gl), element_bytes_(element_bytes) {}

    // Returns whether the buffer is another one now, to be bound anew. The copy stays on the GPU.
    bool reserve(std::size_t elements);
    // Forgets the contents.
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
        std::size_t ranges = 0;  // calls it took
    };

    explicit GpuMesh(const Gl& gl);

    // All of the mesh. `centre`: that positions are relative to from now on; near the object, for
    // floats to be fine enough. Cost: O(mesh).
    Upload upload(const TriMesh& mesh, const Vec3& centre);
    // Relative to the centre of its box.
    Upload upload(const TriMesh& mesh);

    // What an edit changed, in any order, repeats allowed. `wedges`: those that moved or came, live
    // or not (what went needs no mention). `faces`: slots whose face came, went or has other
    // corners. Cost: O(answer log answer), whatever the size of the mesh.
    // Precondition: `mesh` is the one uploaded, changed by nothing else since.
    Upload update(const TriMesh& mesh, std::span<const WedgeId> wedges,
                  std::span<const FaceId> faces);

    // Draws every face slot with attributes 0 position, 1 normal, 2 level and deformed.
    void draw() const;

    const Vec3& centre() const { return centre_; }
    // World; of all that was uploaded since the whole mesh was: it grows at once and shrinks later.
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
    // n_wedge_slots; what a face last said of the wedge. A wedge that went may keep its vertex.
    std::vector<VertexId> wedge_vertices_;
    // Scratch, kept for its capacity.
    std::vector<std::uint32_t> sorted_;
    std::vector<GpuVertex> staged_vertices_;
    std::vector<GpuTriangle> staged_triangles_;
};

}  // namespace pectin
