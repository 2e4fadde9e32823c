// TriMesh::validate: the invariants of the class, checked one by one.
#include <algorithm>
#include <cmath>

#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

// float normals are normalised in double and rounded once.
constexpr float kUnitTolerance = 1e-5f;
// Enough to tell what is wrong without flooding the reader.
constexpr std::size_t kMostMessages = 20;

bool all_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

class Messages {
  public:
    template <typename Id>
    void expect(bool holds, const char* what, Id id) {
        if (!holds && lines_.size() < kMostMessages) {
            lines_.push_back(std::string(what) + ' ' + std::to_string(index(id)));
        }
    }
    std::vector<std::string> take() { return std::move(lines_); }

  private:
    std::vector<std::string> lines_;
};

// Invariant 1: the free list names exactly the slots that are not live, each once.
template <typename Id, typename IsLive>
void check_free(const std::vector<Id>& free, std::uint32_t slots, IsLive is_live, const char* what,
                Messages& messages) {
    std::vector<bool> listed(slots, false);
    for (Id id : free) {
        if (index(id) >= slots) {
            messages.expect(false, what, id);
            continue;
        }
        messages.expect(!listed[index(id)], what, id);
        listed[index(id)] = true;
    }
    for (std::uint32_t i = 0; i < slots; ++i)
        messages.expect(listed[i] != is_live(Id{i}), what, Id{i});
}

}  // namespace

std::vector<std::string> TriMesh::validate() const {
    Messages messages;
    std::vector<std::uint8_t> edge_uses(edge_slots(), 0);
    std::vector<VertexId> wedge_vertices(wedge_slots(), kNone<VertexId>);

    for (std::uint32_t i = 0; i < face_slots(); ++i) {
        const FaceId f{i};
        if (!is_live(f)) continue;
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = half_edge(f, corner);
            const HalfEdge& half = half_edge(h);
            if (index(half.origin) >= vertex_slots() || index(half.edge) >= edge_slots() ||
                index(half.wedge) >= wedge_slots()) {
                messages.expect(false, "2: half-edge out of range", h);
                return messages.take();
            }
            messages.expect(is_live(half.origin), "2: dead vertex at half-edge", h);
            messages.expect(half.origin != target(h), "2: loop at half-edge", h);
            ++edge_uses[index(half.edge)];
            if (exists(half.twin)) {
                const HalfEdge& other = half_edge(half.twin);
                messages.expect(other.twin == h, "3: twin not mutual at half-edge", h);
                messages.expect(other.edge == half.edge, "3: twins' edges differ at half-edge", h);
                messages.expect(other.origin == target(h), "3: twins not opposite at half-edge", h);
            }
            VertexId& at = wedge_vertices[index(half.wedge)];
            messages.expect(!exists(at) || at == half.origin, "6: wedge at two vertices",
                            half.wedge);
            at = half.origin;
        }
        const FaceId base = base_face(f);
        messages.expect(index(base) < base_face_count(), "7: face without base face", f);
        messages.expect(f != base || i < base_face_count(), "7: base face past the base", f);
    }
    for (std::uint32_t i = 0; i < base_face_count(); ++i) {
        messages.expect(is_live(FaceId{i}) && base_face(FaceId{i}) == FaceId{i},
                        "7: base face not live", FaceId{i});
    }
    for (std::uint32_t i = 0; i < edge_slots(); ++i) {
        const EdgeId e{i};
        const bool live = is_live(e);
        messages.expect(live ? edge_uses[i] == 1 || edge_uses[i] == 2 : edge_uses[i] == 0,
                        "4: wrong number of half-edges at edge", e);
        if (!live) continue;
        messages.expect(index(half_edge(e)) < half_edges_.size() && edge(half_edge(e)) == e,
                        "4: edge names another's half-edge", e);
        messages.expect(edge_uses[i] == (exists(twin(half_edge(e))) ? 2 : 1),
                        "4: edge's half-edges and twin disagree", e);
    }
    for (std::uint32_t i = 0; i < vertex_slots(); ++i) {
        const VertexId v{i};
        if (!is_live(v)) continue;
        const HalfEdgeId h = half_edge(v);
        messages.expect(exists(h) || is_base(v), "5: inserted vertex without face", v);
        messages.expect(!exists(h) || origin(h) == v, "5: half-edge of another vertex", v);
        messages.expect(is_base(v) == (level(v) == 0), "7: wrong level at vertex", v);
        messages.expect(all_finite(position(v)), "8: position not finite at vertex", v);
        if (const auto star = removable(v)) {
            messages.expect(
                star->mc == half_edge(face(star->mc), 0) && star->bm == half_edge(edge(star->bm)),
                "9: wrong half-edge at removable vertex", v);
        }
    }
    for (std::uint32_t i = 0; i < wedge_slots(); ++i) {
        if (!exists(wedge_vertices[i])) continue;
        const float length = glm::length(normals_[i]);
        messages.expect(length == 0.0f || std::abs(length - 1.0f) < kUnitTolerance,
                        "8: normal not unit at wedge", WedgeId{i});
        if (has_uvs()) {
            messages.expect(!std::isinf(uvs_[i].x) && !std::isinf(uvs_[i].y),
                            "8: texture coordinate not finite at wedge", WedgeId{i});
        }
    }
    check_free(
        free_vertices_, vertex_slots(), [this](VertexId v) { return is_live(v); },
        "1: free list and slot disagree at vertex", messages);
    check_free(
        free_wedges_, wedge_slots(), [&](WedgeId w) { return exists(wedge_vertices[index(w)]); },
        "1: free list and slot disagree at wedge", messages);
    check_free(
        free_edges_, edge_slots(), [this](EdgeId e) { return is_live(e); },
        "1: free list and slot disagree at edge", messages);
    check_free(
        free_faces_, face_slots(), [this](FaceId f) { return is_live(f); },
        "1: free list and slot disagree at face", messages);
    return messages.take();
}

}  // namespace pectin
