#include "adapt/adapt.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "adapt/cuts.h"
#include "mesh/first_of_siblings.h"

namespace pectin {

namespace {

template <typename Refine, typename Thin>
Adaptation timed(Refine refine, Thin thin) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    };
    Adaptation result;
    const auto begin = Clock::now();
    result.refinement = refine();
    const auto refined = Clock::now();
    result.decimation = thin();
    result.refine_seconds = seconds(begin, refined);
    result.decimate_seconds = seconds(refined, Clock::now());
    return result;
}

// More rounds halve an edge more often than numbers have digits.
constexpr int kMostRounds = 64;

void add(Refinement& result, const Refinement& more) {
    result.splits += more.splits;
    result.splits_in_lanes += more.splits_in_lanes;
    result.chain_steps += more.chain_steps;
    result.floor_hit |= more.floor_hit;
    result.budget_hit |= more.budget_hit;
    result.blocked.insert(result.blocked.end(), more.blocked.begin(), more.blocked.end());
}

// What ends the search after a round, with these cuts left.
CutLimit limit_after(const Cuts& cuts, const std::vector<Cut>& found, const Refinement& refinement,
                     int round) {
    if (found.empty()) return CutLimit::none;
    if (cuts.is_exhausted() || round == kMostRounds) return CutLimit::search;
    return refinement.budget_hit ? CutLimit::budget : CutLimit::none;
}

Refinement refine_without_cuts(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    Refinement result = refine(active, embedding, criteria);
    if (embedding.is_at_rest()) return result;
    Cuts cuts(active);
    for (int round = 0;; ++round) {
        const std::vector<Cut>& found = cuts.find();
        result.cuts = found.size();
        result.cut_limit = limit_after(cuts, found, result, round);
        if (result.cut_limit != CutLimit::none || found.empty()) break;
        const Refinement more = refine_at(active, embedding, criteria,
                                          edges_to_mend(active, embedding, criteria, found));
        add(result, more);
        if (more.splits > 0) continue;
        result.cut_limit = result.budget_hit ? CutLimit::budget : CutLimit::floor;
        break;
    }
    return result;
}

}  // namespace

Adaptation adapt(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    return timed([&] { return refine(active, embedding, criteria); },
                 [&] { return decimate(active, criteria); });
}

Adaptation adapt_without_cuts(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    const bool is_guarded = criteria.limits().flatness != kOff;
    Adaptation result = timed([&] { return refine_without_cuts(active, embedding, criteria); },
                              [&] {
                                  Cuts cuts(active);
                                  return decimate(active, criteria, is_guarded ? &cuts : nullptr);
                              });
    if (!is_guarded && !embedding.is_at_rest()) {
        Refinement& refinement = result.refinement;
        refinement.cuts = Cuts(active).find().size();
        if (refinement.cuts == 0) refinement.cut_limit = CutLimit::none;
        if (refinement.cuts > 0 && refinement.cut_limit == CutLimit::none) {
            refinement.cut_limit = CutLimit::thinning;
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
