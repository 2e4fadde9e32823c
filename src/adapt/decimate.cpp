#include "adapt/decimate.h"

#include <algorithm>
#include <span>
#include <vector>

#include "adapt/cuts.h"
#include "adapt/lane_unsplits.h"

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
bool thin(ActiveSet& active, const Criteria& criteria, Cuts* cuts, Decimation& result) {
    bool any_kept = false;
    const auto levels = candidates_by_level(active);
    LaneUnsplits lanes(active, criteria);
    for (std::size_t level = levels.size(); level-- > 1;) {
        if (!cuts && are_worth_lanes(levels[level].size(), criteria.limits().lane_length)) {
            const std::uint64_t removed = lanes.unsplit(levels[level]);
            result.unsplits += removed;
            result.unsplits_in_lanes += removed;
            continue;
        }
        for (VertexId m : levels[level]) {
            const auto star = active.mesh().removable(m);
            if (!star || !criteria.may_unsplit(active, *star)) continue;
            if (cuts && cuts->would_cut(*star)) {
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

Decimation decimate(ActiveSet& active, const Criteria& criteria, Cuts* cuts) {
    Decimation result;
    std::uint64_t before = 0;
    do {
        before = result.unsplits;
    } while (thin(active, criteria, cuts, result) && result.unsplits > before);
    return result;
}

}  // namespace pectin
