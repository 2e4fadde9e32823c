#include "adapt/adapt.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "adapt/self_intersections.h"
#include "mesh/first_of_siblings.h"

namespace pectin {

namespace {

template <typename Refine, typename Decimate>
Adaptation timed(Refine refine, Decimate decimate) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    };
    Adaptation result;
    const auto begin = Clock::now();
    result.refinement = refine();
    const auto refined = Clock::now();
    result.decimation = decimate();
    result.refine_seconds = seconds(begin, refined);
    result.decimate_seconds = seconds(refined, Clock::now());
    return result;
}

// An edge cannot be halved more often than this: doubles have 53 binary digits.
constexpr int kMostRounds = 64;

void add(Refinement& result, const Refinement& more) {
    result.splits += more.splits;
    result.concurrent_splits += more.concurrent_splits;
    result.chain_steps += more.chain_steps;
    result.floor_hit |= more.floor_hit;
    result.budget_hit |= more.budget_hit;
    result.blocked.insert(result.blocked.end(), more.blocked.begin(), more.blocked.end());
}

// Why the search ends after this round with these intersections left; `none` if it goes on.
IntersectionLimit limit_after(const SelfIntersections& self_intersections,
                              const std::vector<SelfIntersection>& found,
                              const Refinement& refinement, int round) {
    if (found.empty()) return IntersectionLimit::none;
    if (self_intersections.is_exhausted() || round == kMostRounds) return IntersectionLimit::search;
    return refinement.budget_hit ? IntersectionLimit::budget : IntersectionLimit::none;
}

Refinement refine_without_self_intersections(ActiveSet& active, Embedding& embedding,
                                             const Criteria& criteria,
                                             const Surroundings& surroundings) {
    Refinement result = refine(active, embedding, criteria);
    if (embedding.is_identity()) return result;
    SelfIntersections self_intersections(active, surroundings);
    for (int round = 0;; ++round) {
        const std::vector<SelfIntersection>& found = self_intersections.find();
        result.self_intersections = found.size();
        result.intersection_limit = limit_after(self_intersections, found, result, round);
        if (result.intersection_limit != IntersectionLimit::none || found.empty()) break;
        const Refinement more = refine_at(active, embedding, criteria,
                                          edges_to_resolve(active, embedding, criteria, found));
        add(result, more);
        if (more.splits > 0) continue;
        result.intersection_limit =
            result.budget_hit ? IntersectionLimit::budget : IntersectionLimit::floor;
        break;
    }
    return result;
}

}  // namespace

Adaptation adapt(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                 const StopToken& stop) {
    bool is_refined = false;
    return timed(
        [&] {
            Refinement refinement = refine(active, embedding, criteria, stop);
            is_refined = !refinement.was_stopped;
            return refinement;
        },
        [&] { return is_refined ? decimate(active, criteria, nullptr, stop) : Decimation{}; });
}

Adaptation adapt_without_self_intersections(ActiveSet& active, Embedding& embedding,
                                            const Criteria& criteria,
                                            const Surroundings& surroundings) {
    const bool is_guarded = criteria.limits().flatness != kOff;
    Adaptation result = timed(
        [&] {
            return refine_without_self_intersections(active, embedding, criteria, surroundings);
        },
        [&] {
            SelfIntersections self_intersections(active, surroundings);
            return decimate(active, criteria, is_guarded ? &self_intersections : nullptr);
        });
    if (!is_guarded && !embedding.is_identity()) {
        Refinement& refinement = result.refinement;
        refinement.self_intersections = SelfIntersections(active, surroundings).find().size();
        if (refinement.self_intersections == 0)
            refinement.intersection_limit = IntersectionLimit::none;
        if (refinement.self_intersections > 0 &&
            refinement.intersection_limit == IntersectionLimit::none) {
            refinement.intersection_limit = IntersectionLimit::decimation;
        }
    }
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
            greatest = std::max(greatest, criteria.largest_divergence(mesh, e));
        }
        const bool needs = criteria.needs_refinement(active, e);
        if (!needs && !criteria.diverges_on_any_side(mesh, e)) continue;
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
