// TriMesh::validate: checks the invariants of the class one by one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

// Normals are normalised in double and rounded to float once.
constexpr float kUnitTolerance = 1e-5f;
// More messages than these rarely help.
constexpr std::size_t kMostMessages = 20;

}  // namespace

class TriMesh::Validator {
  public:
    explicit Validator(const TriMesh& mesh)
        : mesh_(mesh),
          half_edges_of_edge_(mesh.edge_slots(), 0),
          has_sibling_before_(mesh.edge_slots(), false),
          vertex_of_wedge_(mesh.wedge_slots(), kNone<VertexId>) {}

    std::vector<std::string> run() {
        if (!half_edges_are_in_range()) return std::move(messages_);
        for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
            if (mesh_.is_live(FaceId{i})) check(FaceId{i});
        }
        for (std::uint32_t i = 0; i < mesh_.base_face_count(); ++i) {
            const FaceId f{i};
            expect(mesh_.is_live(f) && mesh_.base_face(f) == f, "7: base face not live", f);
        }
        for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) check(EdgeId{i});
        for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (mesh_.is_live(VertexId{i})) check(VertexId{i});
        }
        for (std::uint32_t i = 0; i < mesh_.wedge_slots(); ++i) {
            if (exists(vertex_of_wedge_[i])) check(WedgeId{i});
        }
        check_free_lists();
        if (messages_.empty()) check_free_list_order();
        return std::move(messages_);
    }

  private:
    template <typename Id>
    void expect(bool holds, const char* what, Id id) {
        if (holds || messages_.size() >= kMostMessages) return;
        messages_.push_back(std::string(what) + ' ' + std::to_string(index(id)));
    }

    // The other checks follow ids without testing their range.
    bool half_edges_are_in_range() {
        for (std::uint32_t i = 0; i < mesh_.faces_.half_edges.size(); ++i) {
            const HalfEdge& h = mesh_.faces_.half_edges[i];
            if (!mesh_.is_live(face(HalfEdgeId{i}))) continue;
            expect(index(h.origin) < mesh_.vertex_slots() && index(h.edge) < mesh_.edge_slots() &&
                       index(h.wedge) < mesh_.wedge_slots() &&
                       (!exists(h.twin) || index(h.twin) < mesh_.faces_.half_edges.size()),
                   "2: id out of range at half-edge", HalfEdgeId{i});
        }
        return messages_.empty();
    }

    void check(FaceId f) {
        for (int corner = 0; corner < 3; ++corner) check(half_edge(f, corner));
        const FaceId base = mesh_.base_face(f);
        expect(index(base) < mesh_.base_face_count(), "7: face without base face", f);
        expect(f != base || index(f) < mesh_.base_face_count(), "7: base face past the base", f);
    }

    void check(HalfEdgeId h) {
        const HalfEdge& half = mesh_.half_edge(h);
        expect(mesh_.is_live(half.origin), "2: dead vertex at half-edge", h);
        expect(half.origin != mesh_.target(h), "2: loop at half-edge", h);
        ++half_edges_of_edge_[index(half.edge)];
        if (exists(half.twin)) {
            const HalfEdge& twin = mesh_.half_edge(half.twin);
            expect(twin.twin == h, "3: twin not mutual at half-edge", h);
            expect(twin.edge == half.edge, "3: twins' edges differ at half-edge", h);
            expect(twin.origin == mesh_.target(h), "3: twins not opposite at half-edge", h);
        }
        VertexId& vertex = vertex_of_wedge_[index(half.wedge)];
        expect(!exists(vertex) || vertex == half.origin, "6: two vertices at wedge", half.wedge);
        vertex = half.origin;
    }

    void check(EdgeId e) {
        const int uses = half_edges_of_edge_[index(e)];
        if (!mesh_.is_live(e)) {
            expect(uses == 0, "4: half-edges at dead edge", e);
            return;
        }
        const HalfEdgeId h = mesh_.half_edge(e);
        expect(index(h) < mesh_.faces_.half_edges.size() && mesh_.edge(h) == e,
               "4: another's half-edge at edge", e);
        expect(uses == (exists(mesh_.twin(h)) ? 2 : 1), "4: wrong number of half-edges at edge", e);
        check_siblings(e);
    }

    void check_siblings(EdgeId e) {
        const EdgeId next = mesh_.sibling(e);
        if (next == e) return;
        if (index(next) >= mesh_.edge_slots() || !mesh_.is_live(next)) {
            expect(false, "10: dead sibling of edge", e);
            return;
        }
        const auto ends = [this](EdgeId edge) {
            const HalfEdgeId h = mesh_.half_edge(edge);
            return std::minmax({mesh_.origin(h), mesh_.target(h)});
        };
        expect(!exists(mesh_.twin(mesh_.half_edge(e))), "10: siblings of an inner edge", e);
        expect(ends(e) == ends(next), "10: sibling elsewhere than edge", e);
        expect(!std::exchange(has_sibling_before_[index(next)], char{1}),
               "10: ring not closed at edge", next);
    }

    void check(VertexId v) {
        const HalfEdgeId h = mesh_.half_edge(v);
        expect(exists(h) || mesh_.is_base(v), "5: no face at inserted vertex", v);
        expect(!exists(h) || mesh_.origin(h) == v, "5: another's half-edge at vertex", v);
        expect(mesh_.is_base(v) == (mesh_.level(v) == 0), "7: wrong level at vertex", v);
        expect(is_finite(mesh_.position(v)), "8: position not finite at vertex", v);
        expect(!mesh_.has_colors() || !glm::any(glm::isinf(mesh_.color(v))),
               "8: colour infinite at vertex", v);
        const auto& representatives = mesh_.input_form().seams.representatives;
        expect(index(v) >= representatives.size() || representatives[index(v)] == v || !exists(h),
               "11: face at joined vertex", v);
        const auto star = mesh_.removable(v);
        if (!star) return;
        expect(star->mc == half_edge(face(star->mc), 0) &&
                   star->bm == mesh_.half_edge(mesh_.edge(star->bm)),
               "9: wrong half-edge at removable vertex", v);
    }

    void check(WedgeId w) {
        const float length = glm::length(mesh_.normal(w));
        expect(length == 0.0f || std::abs(length - 1.0f) < kUnitTolerance,
               "8: normal not unit at wedge", w);
        expect(!mesh_.has_uvs() || (!std::isinf(mesh_.uv(w).x) && !std::isinf(mesh_.uv(w).y)),
               "8: texture coordinate infinite at wedge", w);
    }

    void check_free_lists() {
        check_free(mesh_.vertices_, "1: free list wrong at vertex", "1: not cleared at dead vertex",
                   [this](VertexId v) { return mesh_.is_live(v); });
        check_free(mesh_.wedges_, "1: free list wrong at wedge", "1: not cleared at dead wedge",
                   [this](WedgeId w) { return exists(vertex_of_wedge_[index(w)]); });
        check_free(mesh_.edges_, "1: free list wrong at edge", "1: not cleared at dead edge",
                   [this](EdgeId e) { return mesh_.is_live(e); });
        check_free(mesh_.faces_, "1: free list wrong at face", "1: not cleared at dead face",
                   [this](FaceId f) { return mesh_.is_live(f); });
    }

    // The free list names exactly the slots that are not live, each once, and they are cleared.
    template <typename Columns, typename IsLive>
    void check_free(const SlotTable<Columns>& table, const char* wrong_list,
                    const char* not_cleared, IsLive is_live) {
        using Id = typename Columns::Id;
        std::vector<bool> listed(table.slots(), false);
        for (Id id : table.free_slots()) {
            expect(index(id) < table.slots() && !listed[index(id)], wrong_list, id);
            if (index(id) < table.slots()) listed[index(id)] = true;
        }
        for (std::uint32_t i = 0; i < table.slots(); ++i) {
            const bool live = is_live(Id{i});
            expect(listed[i] != live, wrong_list, Id{i});
            if (!live) expect(table.is_cleared(Id{i}), not_cleared, Id{i});
        }
    }

    // Undoes and repeats every split that can be undone, in a copy. This must restore all ids,
    // half-edges and free lists. Precondition: invariants 1 to 11 hold.
    void check_free_list_order() {
        if (mesh_.highest_level_ == kMaxLevel) return;  // not every edge may be split
        TriMesh copy = mesh_;
        for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const std::optional<Star> star = copy.removable(VertexId{i});
            if (!star) continue;
            const SplitIds before = mesh_.ids_of(*star);
            const Split split = copy.insert_midpoint(copy.unsplit(*star));
            expect(split.m == before.m && split.left.m == before.wedge && split.mc == before.mc &&
                       split.am == before.am && split.dm == before.dm &&
                       split.face3 == before.face3 && split.face4 == before.face4,
                   "12: other ids after unsplit and split of vertex", before.m);
        }
        const auto lists_are_equal = [](const auto& x, const auto& y) {
            return std::ranges::equal(x.free_slots(), y.free_slots());
        };
        expect(lists_are_equal(copy.vertices_, mesh_.vertices_) &&
                   lists_are_equal(copy.wedges_, mesh_.wedges_) &&
                   lists_are_equal(copy.edges_, mesh_.edges_) &&
                   lists_are_equal(copy.faces_, mesh_.faces_) &&
                   same_bytes(copy.faces_.half_edges, mesh_.faces_.half_edges),
               "12: unsplit and split are not inverse, vertex slots", copy.vertex_slots());
    }

    const TriMesh& mesh_;
    std::vector<int> half_edges_of_edge_;
    std::vector<char> has_sibling_before_;
    std::vector<VertexId> vertex_of_wedge_;
    std::vector<std::string> messages_;
};

std::vector<std::string> TriMesh::validate() const { return Validator(*this).run(); }

}  // namespace pectin
