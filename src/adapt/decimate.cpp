#include "adapt/decimate.h"

#include <vector>

namespace pectin {
namespace {

// Inserted vertices of the active set, by level.
std::vector<std::vector<VertexId>> candidates_by_level(const ActiveSet& active) {
    std::vector<std::vector<VertexId>> levels;
    for (std::uint32_t i = 0; i < active.vertex_entries(); ++i) {
        const VertexId v = active.vertex(i);
        if (!exists(v) || active.mesh().is_base(v)) continue;
        const std::size_t level = active.mesh().level(v);
        if (level >= levels.size()) levels.resize(level + 1);
        levels[level].push_back(v);
    }
    return levels;
}

}  // namespace

Decimation decimate(ActiveSet& active, const Criteria& criteria) {
    Decimation result;
    const auto levels = candidates_by_level(active);
    for (std::size_t level = levels.size(); level-- > 1;) {
        for (VertexId m : levels[level]) {
            const auto star = active.mesh().removable(m);
            if (!star || !criteria.may_unsplit(active, *star)) continue;
            active.unsplit(*star);
            ++result.unsplits;
        }
    }
    return result;
}

}  // namespace pectin
