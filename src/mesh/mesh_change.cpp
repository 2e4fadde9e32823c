#include "mesh/mesh_change.h"

#include <cassert>

namespace pectin {

void AttributeState::grow_vertices(std::size_t count) {
    const std::size_t size = vertices.size() + count;
    vertices.reserve(size);
    positions.reserve(size);
    deformed.reserve(size);
    vertices.grow(count);
    positions.grow(count);
    deformed.grow(count);
}

void AttributeState::grow_wedges(std::size_t count) {
    const std::size_t size = wedges.size() + count;
    wedges.reserve(size);
    normals.reserve(size);
    wedges.grow(count);
    normals.grow(count);
}

void AttributeState::grow_faces(std::size_t count) {
    const std::size_t size = faces.size() + count;
    faces.reserve(size);
    errors.reserve(size);
    faces.grow(count);
    errors.grow(count);
}

void AttributeState::write_to(TriMesh& mesh) const {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        mesh.set_position(vertices[i], positions[i]);
        mesh.set_deformed(vertices[i], deformed[i] != 0);
    }
    for (std::size_t i = 0; i < wedges.size(); ++i) mesh.set_normal(wedges[i], normals[i]);
    if (!mesh.tracks_errors()) return;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool is_there = index(faces[i]) < mesh.face_slots() && mesh.is_live(faces[i]);
        if (is_there) mesh.set_error(faces[i], errors[i]);
    }
}

std::size_t AttributeState::memory_bytes() const {
    return vertices.capacity() * sizeof(VertexId) + positions.capacity() * sizeof(Vec3) +
           deformed.capacity() + wedges.capacity() * sizeof(WedgeId) +
           normals.capacity() * sizeof(Vec3f) + faces.capacity() * sizeof(FaceId) +
           errors.capacity() * sizeof(ErrorEllipsoid);
}

std::size_t MeshChange::memory_bytes() const {
    return edits.capacity() * sizeof(TopologyEdit) + before.memory_bytes() + after.memory_bytes() +
           faces.capacity() * sizeof(FaceId);
}

VertexId inserted_vertex(const TriMesh& mesh, EdgeId bc) { return mesh.target(mesh.half_edge(bc)); }

namespace {

constexpr std::size_t kEditsBetweenQuestions = 4096;  // whether to stop

void unsplit_edge(TriMesh& mesh, EdgeId bc) {
    const auto star = mesh.removable(inserted_vertex(mesh, bc));
    assert(star);
    [[maybe_unused]] const EdgeId restored = mesh.unsplit(*star);
    assert(restored == bc);
}

}  // namespace

void take_back(std::span<const TopologyEdit> edits, const SlotCounts& slots_before,
               TriMesh& mesh) noexcept {
    const TriMesh::RollbackScope rollback_scope(mesh, slots_before);
    for (std::size_t i = edits.size(); i-- > 0;) {
        if (edits[i].is_split()) {
            unsplit_edge(mesh, edits[i].edge());
        } else {
            mesh.insert_midpoint(edits[i].edge());
        }
    }
}

void undo(const MeshChange& change, TriMesh& mesh) noexcept {
    take_back(change.edits, change.slots_before, mesh);
    change.before.write_to(mesh);
}

void redo(const MeshChange& change, TriMesh& mesh, const StopToken& stop) {
    const std::span<const TopologyEdit> edits = change.edits;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        try {
            if (i % kEditsBetweenQuestions == 0) stop.throw_if_requested();
            if (edits[i].is_split()) {
                mesh.insert_midpoint(edits[i].edge());
            } else {
                unsplit_edge(mesh, edits[i].edge());
            }
        } catch (...) {
            take_back(edits.first(i), change.slots_before, mesh);
            change.before.write_to(mesh);
            throw;
        }
    }
    change.after.write_to(mesh);
}

}  // namespace pectin
