#include "adapt/deform_pass.h"

#include <algorithm>
#include <array>

#include "adapt/parallel.h"
#include "ffd/drag_stream.h"

namespace pectin {
namespace {

// Entries at a time: what stays in the innermost cache.
constexpr std::uint32_t kBlock = 256;

// Whether these are first, first + 1, first + 2, …; none is past the last id.
template <typename Id>
bool run_on(std::span<const Id> ids) {
    const auto first = static_cast<std::uint32_t>(ids.front());
    std::uint32_t differences = 0;
    for (std::uint32_t k = 0; k < ids.size(); ++k) {
        differences |= static_cast<std::uint32_t>(ids[k]) ^ (first + k);
    }
    return differences == 0 && static_cast<std::uint32_t>(ids.back()) != 0xffffffffu;
}

// Calls work(first, count) for blocks of [first, end), on all threads.
template <typename Work>
void for_blocks(std::uint32_t first, std::uint32_t end, const Work& work) {
    for_pieces(first, end, [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t i = from; i < to; i += kBlock) work(i, std::min(kBlock, to - i));
    });
}

}  // namespace

void deform_vertices(ActiveSet& active, std::span<const Vec3> starts,
                     std::span<const DragWeight> weights, const Vec3& d, std::uint32_t first,
                     std::uint32_t end) {
    TriMesh& mesh = active.mesh();
    // Elsewhere a drag may bring back what one before it has moved.
    const bool is_first = starts.data() == active.rest_positions().data();
    for_blocks(first, end, [&](std::uint32_t from, std::uint32_t count) {
        const std::span<const VertexId> ids = active.vertices().subspan(from, count);
        const bool all = from + count <= active.influenced_at_begin() && run_on(ids);
        std::array<Vec3, kBlock> positions;
        std::array<std::uint8_t, kBlock> marks;
        const std::span<Vec3> to =
            all ? mesh.positions(ids.front(), count) : std::span(positions).first(count);
        const std::span<std::uint8_t> moved =
            all ? mesh.deformed_marks(ids.front(), count) : std::span(marks).first(count);
        const bool all_move =
            displace(starts.subspan(from, count), weights.subspan(from, count), d, to);
        if (all_move && is_first) {
            std::fill(moved.begin(), moved.end(), std::uint8_t{1});
        } else {
            mark_moved(active.rest_positions().subspan(from, count), to,
                       active.were_deformed().subspan(from, count), moved);
        }
        if (all) return;
        for (std::uint32_t k = 0; k < count; ++k) {
            if (!exists(ids[k]) || !active.is_influenced_at(from + k)) continue;
            mesh.set_position(ids[k], to[k]);
            mesh.set_deformed(ids[k], moved[k] != 0);
        }
    });
}

void deform_wedges(ActiveSet& active, std::span<const Vec3f> starts,
                   std::span<const DragWeight> weights, const Vec3& d, std::uint32_t first,
                   std::uint32_t end) {
    TriMesh& mesh = active.mesh();
    for_blocks(first, end, [&](std::uint32_t from, std::uint32_t count) {
        const std::span<const WedgeId> ids = active.wedges().subspan(from, count);
        const std::span<const std::uint32_t> owners = active.wedge_owners().subspan(from, count);
        const auto turn_block = [&](std::span<const DragWeight> of_owners) {
            const bool all = from + count <= active.influenced_wedges_at_begin() && run_on(ids);
            std::array<Vec3f, kBlock> normals;
            const std::span<Vec3f> to =
                all ? mesh.normals(ids.front(), count) : std::span(normals).first(count);
            turn(starts.subspan(from, count), of_owners, d, to);
            if (all) return;
            for (std::uint32_t k = 0; k < count; ++k) {
                if (exists(ids[k]) && active.is_influenced_at(owners[k])) {
                    mesh.set_normal(ids[k], to[k]);
                }
            }
        };
        if (run_on(owners)) {
            turn_block(weights.subspan(owners.front(), count));
        } else {
            std::array<DragWeight, kBlock> gathered;
            for (std::uint32_t k = 0; k < count; ++k) gathered[k] = weights[owners[k]];
            turn_block(std::span(gathered).first(count));
        }
    });
}

}  // namespace pectin
