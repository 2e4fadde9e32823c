#include "adapt/decimate.h"

#include <algorithm>
#include <span>
#include <vector>

#include "adapt/concurrent/unsplits.h"
#include "adapt/self_intersections.h"

namespace pectin {
namespace {

using Levels = std::vector<std::vector<VertexId>>;

// Of entries in the order of their ids base vertices come first; none of them is ever removed.
void add_inserted(const TriMesh& mesh, std::span<const VertexId> entries, Levels& levels) {
    for (VertexId v : entries) {
        if (!exists(v) || mesh.is_base(v)) continue;
        const std::size_t level = mesh.level(v);
        if (level >= levels.size()) levels.resize(level + 1);
        levels[level].push_back(v);
    }
}

std::span<const VertexId> without_base(const TriMesh& mesh, std::span<const VertexId> by_id) {
    const auto first = std::partition_point(by_id.begin(), by_id.end(),
                                            [&](VertexId v) { return mesh.is_base(v); });
    return by_id.subspan(static_cast<std::size_t>(first - by_id.begin()));
}

// Inserted vertices of the active set, by level.
Levels candidates_by_level(const ActiveSet& active) {
    const TriMesh& mesh = active.mesh();
    const std::uint32_t influenced = active.influenced_at_begin();
    const std::uint32_t original = active.vertices_at_begin();
    Levels levels;
    add_inserted(mesh, without_base(mesh, active.vertices().first(influenced)), levels);
    add_inserted(mesh,
                 without_base(mesh, active.vertices().subspan(influenced, original - influenced)),
                 levels);
    add_inserted(mesh, active.vertices().subspan(original), levels);
    return levels;
}

// Whether any was kept for the cuts alone.
bool decimate_once(ActiveSet& active, const Criteria& criteria,
                   SelfIntersections* self_intersections, Decimation& result) {
    bool any_kept = false;
    const auto levels = candidates_by_level(active);
    ConcurrentUnsplits concurrent_unsplits(active, criteria);
    for (std::size_t level = levels.size(); level-- > 1;) {
        if (!self_intersections &&
            are_worth_partitioning(levels[level].size(), criteria.limits().partition_batch)) {
            const std::uint64_t removed = concurrent_unsplits.unsplit(levels[level]);
            result.unsplits += removed;
            result.concurrent_unsplits += removed;
            continue;
        }
        for (VertexId m : levels[level]) {
            const auto star = active.mesh().removable(m);
            if (!star || !criteria.may_unsplit(active, *star)) continue;
            if (self_intersections && self_intersections->would_intersect(*star)) {
                any_kept = true;
                continue;
            }
            active.unsplit(*star);
            ++result.unsplits;
        }
    }
    return any_kept;
}

}  // namespace

Decimation decimate(ActiveSet& active, const Criteria& criteria,
                    SelfIntersections* self_intersections) {
    Decimation result;
    std::uint64_t before = 0;
    do {
        before = result.unsplits;
    } while (decimate_once(active, criteria, self_intersections, result) &&
             result.unsplits > before);
    return result;
}

}  // namespace pectin
