// What a gesture has changed, compared with the rest state.
#include "geometry/two_groups.h"
#include "mesh/array_bytes.h"
#include "mesh/rest_state.h"

namespace pectin {

void RestState::record(MeshChange& change) const {
    record_vertices(change);
    record_wedges(change);
    const std::size_t first = change.before.wedges.size();
    change.before.grow_wedges(kept_wedges_.size());
    for (std::size_t i = 0; i < kept_wedges_.size(); ++i) {
        change.before.set(first + i, kept_wedges_[i], kept_normals_[i]);
    }
}

void RestState::record_vertices(MeshChange& change) const {
    const auto is_as_before = [&](std::uint32_t i) {
        const VertexId v = vertices_.ids[i];
        return exists(v) && same_bytes(mesh_.position(v), vertices_.positions[i]) &&
               mesh_.is_deformed(v) == (vertices_.was_deformed[i] != 0);
    };
    const TwoGroups changed(original_vertices_, [&](std::uint32_t i) {
        return is_as_before(i) ? Group::none : Group::first;
    });
    change.before.grow_vertices(changed.size());
    changed.for_each([&](std::uint32_t i, std::uint32_t number) {
        change.before.set(number, original_vertex_ids_[i], vertices_.positions[i],
                          vertices_.was_deformed[i] != 0);
    });
    const TwoGroups changed_or_new(vertices_.slots(), [&](std::uint32_t i) {
        const bool is_recorded = i >= original_vertices_ || !is_as_before(i);
        return is_recorded && exists(vertices_.ids[i]) ? Group::first : Group::none;
    });
    change.after.grow_vertices(changed_or_new.size());
    changed_or_new.for_each([&](std::uint32_t i, std::uint32_t number) {
        const VertexId v = vertices_.ids[i];
        change.after.set(number, v, mesh_.position(v), mesh_.is_deformed(v));
    });
}

void RestState::record_wedges(MeshChange& change) const {
    const auto is_as_before = [&](std::uint32_t i) {
        const WedgeId w = wedges_.ids[i];
        return exists(w) && same_bytes(mesh_.normal(w), wedges_.normals[i]);
    };
    const TwoGroups changed(original_wedges_, [&](std::uint32_t i) {
        return is_as_before(i) ? Group::none : Group::first;
    });
    change.before.grow_wedges(changed.size());
    changed.for_each([&](std::uint32_t i, std::uint32_t number) {
        change.before.set(number, original_wedge_ids_[i], wedges_.normals[i]);
    });
    const TwoGroups changed_or_new(wedges_.slots(), [&](std::uint32_t i) {
        const bool is_recorded = i >= original_wedges_ || !is_as_before(i);
        return is_recorded && exists(wedges_.ids[i]) ? Group::first : Group::none;
    });
    change.after.grow_wedges(changed_or_new.size());
    changed_or_new.for_each([&](std::uint32_t i, std::uint32_t number) {
        const WedgeId w = wedges_.ids[i];
        change.after.set(number, w, mesh_.normal(w));
    });
}

bool RestState::has_changed(FaceId f) const {
    if (!mesh_.is_live(f)) return true;
    for (int corner = 0; corner < 3; ++corner) {
        const HalfEdge& h = mesh_.half_edge(TriMesh::half_edge(f, corner));
        if (!same_bytes(mesh_.position(h.origin), position(h.origin)) ||
            !same_bytes(mesh_.normal(h.wedge), normal(h.wedge))) {
            return true;
        }
    }
    return false;
}

}  // namespace pectin
