#include "adapt/adapt.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "mesh/first_of_siblings.h"

namespace pectin {

Adaptation adapt(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    };
    Adaptation result;
    const auto begin = Clock::now();
    result.refinement = refine(active, embedding, criteria);
    const auto refined = Clock::now();
    result.decimation = decimate(active, criteria);
    const auto decimated = Clock::now();
    result.refine_seconds = seconds(begin, refined);
    result.decimate_seconds = seconds(refined, decimated);
    return result;
}

Assessment assess(const ActiveSet& active, const Criteria& criteria,
                  std::span<const EdgeId> blocked) {
    Assessment result;
    const TriMesh& mesh = active.mesh();
    FirstOfSiblings is_first(mesh);
    double greatest = 0.0;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
        const EdgeId e{i};
        if (!mesh.is_live(e) || !is_first(e)) continue;
        const HalfEdgeId h = mesh.half_edge(e);
        if (mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h))) {
            greatest = std::max(greatest, Criteria::full_divergence(mesh, e));
        }
        const bool needs = criteria.needs_refinement(active, e);
        if (!needs && !criteria.diverges(mesh, e)) continue;
        const bool held = criteria.is_below_floor(mesh, e) || !mesh.may_split(e) ||
                          std::binary_search(blocked.begin(), blocked.end(), e);
        if (held) {
            ++result.held_back;
        } else if (needs) {
            ++result.needing_refinement;
        }
    }
    // greatest = 1 - cos(angle) = 2 sin^2(angle / 2)
    result.divergence_max_deg =
        2.0 * std::asin(std::sqrt(std::min(1.0, 0.5 * greatest))) * 180.0 / std::numbers::pi;
    return result;
}

}  // namespace pectin
