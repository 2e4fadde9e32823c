#include "embedding/lattice_pass.h"

#include <algorithm>
#include <array>

#include "geometry/parallel.h"

namespace pectin {
namespace {

// Entries in a block, which stays in the innermost cache.
constexpr std::uint32_t kBlock = 256;

// Calls work(first, count) for the blocks of [first, end) on all threads, in no order.
template <typename Work>
void for_blocks(std::uint32_t first, std::uint32_t end, const Work& work) {
    for_pieces(first, end, [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t i = from; i < to; i += kBlock) work(i, std::min(kBlock, to - i));
    });
}

// The number of leading wedge entries that belong to the vertex entry with the same index.
std::uint32_t corresponding_entries(const ActiveSet& active) {
    const std::span<const std::uint32_t> owners = active.wedge_owners();
    std::uint32_t corresponding = 0;
    while (corresponding < owners.size() && owners[corresponding] == corresponding) ++corresponding;
    return corresponding;
}

void set_vertices(ActiveSet& active, std::span<const Vec3> positions, std::uint32_t first) {
    TriMesh& mesh = active.mesh();
    for (std::uint32_t k = 0; k < positions.size(); ++k) {
        const std::uint32_t i = first + k;
        const VertexId v = active.vertex(i);
        if (!exists(v) || !active.is_influenced_at(i)) continue;
        mesh.set_position(v, positions[k]);
        mesh.set_deformed(v,
                          active.was_deformed_at(i) || positions[k] != active.rest_position_at(i));
    }
}

void set_wedges(ActiveSet& active, std::span<const Vec3f> normals, std::uint32_t first) {
    TriMesh& mesh = active.mesh();
    for (std::uint32_t k = 0; k < normals.size(); ++k) {
        const WedgeId w = active.wedge(first + k);
        if (exists(w) && active.is_influenced_at(active.wedge_owner(first + k))) {
            mesh.set_normal(w, normals[k]);
        }
    }
}

}  // namespace

void deform(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
            std::span<const Vec3f> normals) {
    const std::uint32_t corresponding = corresponding_entries(active);
    for_blocks(0, corresponding, [&](std::uint32_t first, std::uint32_t count) {
        std::array<Vec3, kBlock> to;
        std::array<Vec3f, kBlock> transformed;
        field.transform(starts.subspan(first, count), normals.subspan(first, count),
                        std::span(to).first(count), std::span(transformed).first(count));
        set_vertices(active, std::span(to).first(count), first);
        set_wedges(active, std::span(transformed).first(count), first);
    });
    deform_vertices(active, field, starts, corresponding, active.vertex_entries());
    deform_wedges(active, field, starts, normals, corresponding, active.wedge_entries());
}

void deform_vertices(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                     std::uint32_t first, std::uint32_t end) {
    for_blocks(first, end, [&](std::uint32_t from, std::uint32_t count) {
        std::array<Vec3, kBlock> to;
        field.displace(starts.subspan(from, count), std::span(to).first(count));
        set_vertices(active, std::span(to).first(count), from);
    });
}

void deform_wedges(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                   std::span<const Vec3f> normals, std::uint32_t first, std::uint32_t end) {
    for_blocks(first, end, [&](std::uint32_t from, std::uint32_t count) {
        std::array<Vec3, kBlock> at, to;
        std::array<Vec3f, kBlock> transformed;
        for (std::uint32_t k = 0; k < count; ++k) at[k] = starts[active.wedge_owner(from + k)];
        field.transform(std::span(at).first(count), normals.subspan(from, count),
                        std::span(to).first(count), std::span(transformed).first(count));
        set_wedges(active, std::span(transformed).first(count), from);
    });
}

}  // namespace pectin
