// Undoing the split of an edge exactly.
// Source: Gain & Dodgson 1999, section 4, figure 3.
#include <algorithm>
#include <array>
#include <cassert>

#include "mesh/tri_mesh.h"

namespace pectin {

// Released slots are cleared, so that a slot's bytes do not depend on what it once held.
void TriMesh::clear(VertexId v) {
    positions_[index(v)] = Vec3{0.0};
    vertex_half_edges_[index(v)] = kNone<HalfEdgeId>;
    vertex_levels_[index(v)] = 0;
    deformed_[index(v)] = 0;
    if (has_colors()) colors_[index(v)] = Vec3f{0.0f};
}

void TriMesh::clear(WedgeId w) {
    normals_[index(w)] = Vec3f{0.0f};
    if (has_uvs()) uvs_[index(w)] = Vec2f{0.0f};
}

void TriMesh::clear(EdgeId e) {
    edge_half_edges_[index(e)] = kNone<HalfEdgeId>;
    edge_levels_[index(e)] = 0;
    if (!siblings_.empty()) siblings_[index(e)] = e;
}

void TriMesh::clear(FaceId f) {
    for (int corner = 0; corner < 3; ++corner) {
        half_edges_[index(half_edge(f, corner))] = HalfEdge{};
    }
    face_bases_[index(f)] = kNone<FaceId>;
}

// While edits are taken back, the last slot is removed where no other of its kind is free.
// Allocating then adds it again, so this makes no difference to which slots later allocations give.
bool TriMesh::removes(std::uint32_t slot, std::uint32_t slots, std::uint32_t kept,
                      std::size_t free) {
    return slot >= kept && slot + 1 == slots && free == 0;
}

void TriMesh::release(VertexId v) {
    clear(v);
    if (removes(index(v), vertex_slots(), kept_slots_.vertices, free_vertices_.size())) {
        for_each_array_of_vertices([](auto& slots) { slots.pop_back(); });
    } else {
        free_vertices_.push_back(v);
    }
}

void TriMesh::release(WedgeId w) {
    clear(w);
    if (removes(index(w), wedge_slots(), kept_slots_.wedges, free_wedges_.size())) {
        for_each_array_of_wedges([](auto& slots) { slots.pop_back(); });
    } else {
        free_wedges_.push_back(w);
    }
}

void TriMesh::release(EdgeId e) {
    clear(e);
    if (removes(index(e), edge_slots(), kept_slots_.edges, free_edges_.size())) {
        for_each_array_of_edges([](auto& slots) { slots.pop_back(); });
    } else {
        free_edges_.push_back(e);
    }
}

void TriMesh::release(FaceId f) {
    clear(f);
    if (removes(index(f), face_slots(), kept_slots_.faces, free_faces_.size())) {
        half_edges_.resize(half_edges_.size() - 3);
        face_bases_.pop_back();
    } else {
        free_faces_.push_back(f);
    }
}

std::optional<Star> TriMesh::removable(VertexId m) const {
    if (is_base(m) || !is_live(m)) return std::nullopt;
    const std::optional<Star> star = star_from(half_edge(m));
    if (!star || !star->on_boundary()) return star;
    const EdgeId first = edge(star->mc);
    for (EdgeId e = sibling(first); e != first; e = sibling(e)) {
        if (!sheet(m, e)) return std::nullopt;
    }
    return star;
}

// The star that has m->c in its face 3, if it is closed with four edges, or has three and lies on
// the boundary, and all neighbours are at m's level or lower.
std::optional<Star> TriMesh::star_from(HalfEdgeId mc) const {
    Star star;
    star.m = origin(mc);
    star.mc = mc;
    const HalfEdgeId am = prev(mc), ma = twin(am);
    if (!exists(ma)) return std::nullopt;
    star.bm = prev(ma);
    star.a = origin(am);
    star.b = origin(star.bm);
    star.c = target(mc);
    std::uint16_t highest = std::max({level(star.a), level(star.b), level(star.c)});
    star.mb = twin(star.bm);
    star.cm = twin(mc);
    if (exists(star.mb) != exists(star.cm)) return std::nullopt;
    if (exists(star.mb)) {
        const HalfEdgeId dm = prev(star.mb);
        // A fourth edge closes the star; with a fifth, md lies in another face than cm.
        if (twin(dm) != next(star.cm)) return std::nullopt;
        star.d = origin(dm);
        highest = std::max(highest, level(star.d));
    }
    if (highest > level(star.m)) return std::nullopt;
    return star;
}

// The star in the sheet that has this boundary edge at m: its m->c, or its b->m where the sheet
// runs the other way.
std::optional<Star> TriMesh::sheet(VertexId m, EdgeId along_cut) const {
    const HalfEdgeId h = half_edge(along_cut);
    if (origin(h) == m) return star_from(h);
    const HalfEdgeId am = twin(next(h));
    return exists(am) ? star_from(next(am)) : std::nullopt;
}

// The reverse of insert_midpoint, statement by statement.
EdgeId TriMesh::unsplit(const Star& star) {
    if (star.on_boundary() && sibling(edge(star.mc)) != edge(star.mc)) unsplit_siblings(star);
    const EdgeId e = unsplit_sheet(star);
    release(star.m);
    return e;
}

void TriMesh::unsplit_siblings(const Star& representative) {
    sheets_.clear();
    for_each_sheet(representative, [&](const Star& star) { sheets_.push_back(star); });
    for (std::size_t i = sheets_.size(); i-- > 0;) {
        const EdgeId e = edge(sheets_[i].bm);
        assert(e >= edge(representative.bm));
        siblings_[index(e)] = edge(sheets_[(i + 1) % sheets_.size()].bm);
        if (i > 0) unsplit_sheet(sheets_[i]);
    }
}

EdgeId TriMesh::unsplit_sheet(const Star& star) {
    const SplitIds ids = ids_of(star);
    const EdgeId e = edge(star.bm);
    if (!star.on_boundary()) {
        const WedgeId right_m = wedge(star.mb);
        disconnect_right(star, ids);
        disconnect_left(star, ids);
        release(ids.face4);
        release(ids.face3);
        release(ids.dm);
        release(ids.am);
        release(ids.mc);
        if (right_m != ids.wedge) release(right_m);
    } else {
        disconnect_left(star, ids);
        release(ids.face3);
        release(ids.am);
        release(ids.mc);
    }
    release(ids.wedge);
    return e;
}

SplitIds TriMesh::remove_midpoint(const Star& star) {
    assert(!star.on_boundary() && wedge(star.mb) == wedge(star.mc));
    const SplitIds ids = ids_of(star);
    disconnect_right(star, ids);
    disconnect_left(star, ids);
    clear(ids.face4);
    clear(ids.face3);
    clear(ids.dm);
    clear(ids.am);
    clear(ids.mc);
    clear(ids.wedge);
    clear(ids.m);
    return ids;
}

void TriMesh::reserve_unsplits(std::size_t count) {
    free_vertices_.reserve_additional(count);
    free_wedges_.reserve_additional(2 * count);
    free_edges_.reserve_additional(3 * count);
    free_faces_.reserve_additional(2 * count);
}

FreedSlots TriMesh::allocate_freed(std::size_t splits) {
    const FreedSlots first{free_vertices_.size(), free_wedges_.size(), free_edges_.size(),
                           free_faces_.size()};
    free_vertices_.grow_unchecked(splits);
    free_wedges_.grow_unchecked(splits);
    free_edges_.grow_unchecked(3 * splits);
    free_faces_.grow_unchecked(2 * splits);
    return first;
}

// In the order that unsplit would.
void TriMesh::free_split(const SplitIds& ids, const FreedSlots& first, std::size_t i) {
    std::ranges::copy(std::array{ids.face4, ids.face3}, &free_faces_[first.face + 2 * i]);
    std::ranges::copy(std::array{ids.dm, ids.am, ids.mc}, &free_edges_[first.edge + 3 * i]);
    free_wedges_[first.wedge + i] = ids.wedge;
    free_vertices_[first.vertex + i] = ids.m;
}

// What the split took; on a boundary there is no dm and no face4. Of a crease only the left wedge.
SplitIds TriMesh::ids_of(const Star& star) const {
    SplitIds ids;
    ids.m = star.m;
    ids.wedge = wedge(star.mc);
    ids.mc = edge(star.mc);
    ids.am = edge(prev(star.mc));
    ids.face3 = face(star.mc);
    if (star.on_boundary()) return ids;
    ids.dm = edge(prev(star.mb));
    ids.face4 = face(star.cm);
    return ids;
}

// The reverse of connect_left and connect_right.
void TriMesh::disconnect_left(const Star& star, [[maybe_unused]] const SplitIds& ids) {
    const HalfEdgeId ma = next(star.bm), ca = next(star.mc);
    assert(ca == half_edge(ids.face3, 1) && level(ids.am) == level(star.m));
    move_half_edge(ca, ma);
}

void TriMesh::disconnect_right(const Star& star, const SplitIds& ids) {
    const HalfEdgeId mb = star.mb, dm = prev(mb);
    assert(star.cm == half_edge(ids.face4, 0) && level(ids.dm) == level(star.m));
    half_edges_[index(star.cm)].edge = edge(star.bm);
    move_half_edge(half_edge(ids.face4, 2), dm);
    move_half_edge(star.cm, mb);
    link(star.bm, mb);
}

}  // namespace pectin
