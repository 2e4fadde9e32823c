#include "embedding/deform_pass.h"

#include <algorithm>
#include <array>

#include "ffd/drag_stream.h"
#include "geometry/parallel.h"

namespace pectin {
namespace {

// Entries in a block. All that the passes over vertices and wedges read and write fits into the
// innermost cache with room to spare for prefetching, so that normals find the weights there.
constexpr std::uint32_t kBlock = 64;

// Whether the ids are consecutive and exist.
template <typename Id>
bool run_on(std::span<const Id> ids) {
    const auto first = static_cast<std::uint32_t>(ids.front());
    std::uint32_t differences = 0;
    for (std::uint32_t k = 0; k < ids.size(); ++k) {
        differences |= static_cast<std::uint32_t>(ids[k]) ^ (first + k);
    }
    return differences == 0 && static_cast<std::uint32_t>(ids.back()) != 0xffffffffu;
}

// Bits in the result of lasting_runs().
constexpr std::uint8_t kVerticesRun = 1, kWedgesRun = 2;

// Whether the vertices of a block have consecutive ids for the whole gesture. Base vertices are
// never removed.
bool vertices_stay(const ActiveSet& active, std::uint32_t first) {
    if (first + kBlock > active.influenced_at_begin()) return false;
    const std::span<const VertexId> ids = active.vertices().subspan(first, kBlock);
    return run_on(ids) && active.mesh().is_base(ids.back());
}

// The same for wedges. The wedges of base vertices are never removed either.
bool wedges_stay(const ActiveSet& active, std::uint32_t first) {
    if (first + kBlock > active.influenced_wedges_at_begin()) return false;
    const std::span<const std::uint32_t> owners = active.wedge_owners().subspan(first, kBlock);
    return run_on(active.wedges().subspan(first, kBlock)) && run_on(owners) &&
           std::ranges::all_of(owners, [&](std::uint32_t owner) {
               return active.mesh().is_base(active.vertex(owner));
           });
}

// Moves the vertices and wedges of an active set by one drag.
class DeformPass {
  public:
    DeformPass(ActiveSet& active, std::span<const Vec3> starts, std::span<const Vec3f> normals,
               std::span<const DragWeight> weights, std::span<const std::uint8_t> runs,
               const Vec3& d)
        : active_(active),
          mesh_(active.mesh()),
          starts_(starts),
          normals_(normals),
          weights_(weights),
          runs_(runs),
          d_(d),
          is_first_(starts.data() == active.rest_positions().data()) {}

    void move_vertices(std::uint32_t first, std::uint32_t count) {
        const std::span<const VertexId> ids = active_.vertices().subspan(first, count);
        if (stays(first, count, kVerticesRun) ||
            (first + count <= active_.influenced_at_begin() && run_on(ids))) {
            displace_and_mark(first, mesh_.positions(ids.front(), count),
                              mesh_.deformed_marks(ids.front(), count));
            return;
        }
        std::array<Vec3, kBlock> to;
        std::array<std::uint8_t, kBlock> moved;
        displace_and_mark(first, std::span(to).first(count), std::span(moved).first(count));
        for (std::uint32_t k = 0; k < count; ++k) {
            if (!exists(ids[k]) || !active_.is_influenced_at(first + k)) continue;
            mesh_.set_position(ids[k], to[k]);
            mesh_.set_deformed(ids[k], moved[k] != 0);
        }
    }

    void transform_wedges(std::uint32_t first, std::uint32_t count) {
        const std::span<const std::uint32_t> owners = active_.wedge_owners().subspan(first, count);
        if (stays(first, count, kWedgesRun) || run_on(owners)) {
            transform_wedges(first, weights_.subspan(owners.front(), count));
            return;
        }
        std::array<DragWeight, kBlock> gathered;
        for (std::uint32_t k = 0; k < count; ++k) gathered[k] = weights_[owners[k]];
        transform_wedges(first, std::span(gathered).first(count));
    }

  private:
    bool stays(std::uint32_t first, std::uint32_t count, std::uint8_t run) const {
        return count == kBlock && first / kBlock < runs_.size() &&
               (runs_[first / kBlock] & run) != 0;
    }

    void displace_and_mark(std::uint32_t first, std::span<Vec3> to,
                           std::span<std::uint8_t> moved) const {
        const std::size_t count = to.size();
        const bool all_move =
            displace(starts_.subspan(first, count), weights_.subspan(first, count), d_, to);
        if (all_move && is_first_) {
            std::fill(moved.begin(), moved.end(), std::uint8_t{1});
        } else {
            mark_moved(active_.rest_positions().subspan(first, count), to,
                       active_.were_deformed().subspan(first, count), moved);
        }
    }

    void transform_wedges(std::uint32_t first, std::span<const DragWeight> of_owners) {
        const auto count = static_cast<std::uint32_t>(of_owners.size());
        const std::span<const WedgeId> ids = active_.wedges().subspan(first, count);
        const std::span<const Vec3f> from = normals_.subspan(first, count);
        if (stays(first, count, kWedgesRun) ||
            (first + count <= active_.influenced_wedges_at_begin() && run_on(ids))) {
            transform_normals(from, of_owners, d_, mesh_.normals(ids.front(), count));
            return;
        }
        std::array<Vec3f, kBlock> to;
        transform_normals(from, of_owners, d_, std::span(to).first(count));
        for (std::uint32_t k = 0; k < count; ++k) {
            if (exists(ids[k]) && active_.is_influenced_at(active_.wedge_owner(first + k))) {
                mesh_.set_normal(ids[k], to[k]);
            }
        }
    }

    ActiveSet& active_;
    TriMesh& mesh_;
    std::span<const Vec3> starts_;
    std::span<const Vec3f> normals_;
    std::span<const DragWeight> weights_;
    std::span<const std::uint8_t> runs_;
    Vec3 d_;
    bool is_first_;  // the first step of its warp; a later one may move vertices back to rest
};

}  // namespace

std::vector<std::uint8_t> lasting_runs(const ActiveSet& active) {
    const std::uint32_t most =
        std::max(active.influenced_at_begin(), active.influenced_wedges_at_begin());
    std::vector<std::uint8_t> runs(most / kBlock);
    for (std::uint32_t block = 0; block < runs.size(); ++block) {
        const int vertices = vertices_stay(active, block * kBlock) ? kVerticesRun : 0;
        const int wedges = wedges_stay(active, block * kBlock) ? kWedgesRun : 0;
        runs[block] = static_cast<std::uint8_t>(vertices | wedges);
    }
    return runs;
}

void deform(ActiveSet& active, std::span<const Vec3> starts, std::span<const Vec3f> normals,
            std::span<const DragWeight> weights, std::span<const std::uint8_t> runs,
            const Vec3& d) {
    DeformPass pass(active, starts, normals, weights, runs, d);
    const std::uint32_t vertices = active.vertex_entries(), wedges = active.wedge_entries();
    for_pieces(0, std::max(vertices, wedges), [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end;) {
            const std::uint32_t next = std::min(end, i / kBlock * kBlock + kBlock);
            if (i < vertices) pass.move_vertices(i, std::min(next, vertices) - i);
            if (i < wedges) pass.transform_wedges(i, std::min(next, wedges) - i);
            i = next;
        }
    });
}

}  // namespace pectin
