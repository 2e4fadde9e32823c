// Which edges other settings would refine, for a preview of them.
#include <algorithm>

#include "session/session_state.h"

namespace pectin {

std::vector<EdgeId> Session::State::edges_to_refine(const command::Adapt& change,
                                                    std::uint32_t first,
                                                    std::uint32_t count) const {
    std::vector<EdgeId> found;
    const Result<AdaptSettings> settings = adapt_settings.with(change);
    if (active_gesture || !settings || !has_object()) return found;
    const Criteria criteria(limits_of(*settings), zones_of_readapt(*settings), {});
    const std::uint32_t slots = mesh->edge_slots();
    const std::uint32_t begin = std::min(first, slots);
    const std::uint32_t end = begin + std::min(count, slots - begin);
    for (std::uint32_t i = begin; i < end; ++i) {
        const EdgeId e{i};
        if (!mesh->is_live(e) || criteria.is_below_floor(*mesh, e)) continue;
        if (criteria.needs_refinement(*active, e)) found.push_back(e);
    }
    return found;
}

std::vector<EdgeId> Session::edges_to_refine(const command::Adapt& change, std::uint32_t first,
                                             std::uint32_t count) const {
    return state_->edges_to_refine(change, first, count);
}

}  // namespace pectin
