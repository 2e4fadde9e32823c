// The record of one committed edit of a mesh, from which it can be undone and redone exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/stop_token.h"
#include "mesh/growing_array.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// A split of an edge, or the unsplit that restored it.
class TopologyEdit {
  public:
    static TopologyEdit split(EdgeId bc) { return TopologyEdit{index(bc)}; }
    static TopologyEdit unsplit(EdgeId bc) { return TopologyEdit{index(bc) | kUnsplit}; }

    bool is_split() const { return (bits_ & kUnsplit) == 0; }
    EdgeId edge() const { return EdgeId{bits_ & ~kUnsplit}; }
    bool operator==(const TopologyEdit&) const = default;

  private:
    static constexpr std::uint32_t kUnsplit = 0x80000000u;
    explicit TopologyEdit(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

// The attributes that a gesture may change, for the elements that it has changed. Levels and
// texture coordinates follow from the edits.
struct AttributeState {
    GrowingArray<VertexId> vertices;
    GrowingArray<Vec3> positions;         // n_vertices
    GrowingArray<std::uint8_t> deformed;  // n_vertices
    GrowingArray<WedgeId> wedges;
    GrowingArray<Vec3f> normals;          // n_wedges
    GrowingArray<FaceId> faces;           // those that are not live in this state do not count
    GrowingArray<ErrorEllipsoid> errors;  // n_faces

    // Adds elements that set() then writes. Throws std::bad_alloc.
    void grow_vertices(std::size_t count);
    void grow_wedges(std::size_t count);
    void grow_faces(std::size_t count);
    void set(std::size_t i, VertexId v, const Vec3& position, bool is_deformed) {
        vertices[i] = v;
        positions[i] = position;
        deformed[i] = is_deformed ? 1 : 0;
    }
    void set(std::size_t i, WedgeId w, const Vec3f& normal) {
        wedges[i] = w;
        normals[i] = normal;
    }
    void set(std::size_t i, FaceId f, const ErrorEllipsoid& error) {
        faces[i] = f;
        errors[i] = error;
    }
    void write_to(TriMesh& mesh) const;
    std::size_t memory_bytes() const;
};

struct MeshChange {
    SlotCounts slots_before;
    std::vector<TopologyEdit> edits;  // in the order they were made
    AttributeState before;      // elements that existed before and have changed or been removed
    AttributeState after;       // elements that exist afterwards and have changed or been added
    std::vector<FaceId> faces;  // slots whose face has changed, been added or removed; sorted

    // Wedges are tested, too: the normal of a pinned vertex may change while its position does not.
    // So are the errors of faces: a drag may move the exact surface between the vertices alone.
    bool is_empty() const {
        return edits.empty() && before.vertices.empty() && before.wedges.empty() &&
               before.faces.empty();
    }
    std::size_t memory_bytes() const;
};

// Precondition: `mesh` is in the state after the change (undo) or before it (redo). Both restore
// ids, attributes and free lists to the byte. Cost: O(size of the change). undo() allocates
// nothing. redo() may throw std::bad_alloc, and Stopped where `stop` asks for it; the mesh is then
// unchanged.
void undo(const MeshChange& change, TriMesh& mesh) noexcept;
void redo(const MeshChange& change, TriMesh& mesh, const StopToken& stop = {});

// The vertex that the split of bc inserted. Precondition: it is removable.
VertexId inserted_vertex(const TriMesh& mesh, EdgeId bc);
// Takes back edits, last first, without restoring attributes. slots_before: the slots of the mesh
// before the edits. Allocates nothing.
void take_back(std::span<const TopologyEdit> edits, const SlotCounts& slots_before,
               TriMesh& mesh) noexcept;

}  // namespace pectin
