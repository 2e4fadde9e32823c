#include "adapt/adapt.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <span>

#include "adapt/edge_classifier.h"
#include "adapt/face_pairs.h"
#include "adapt/self_intersections.h"
#include "geometry/parallel.h"
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
    if (self_intersections.is_exhausted()) return IntersectionLimit::search;  // more may be left
    if (found.empty()) return IntersectionLimit::none;
    if (round == kMostRounds) return IntersectionLimit::search;
    return refinement.budget_hit ? IntersectionLimit::budget : IntersectionLimit::none;
}

Refinement refine_without_self_intersections(ActiveSet& active, Embedding& embedding,
                                             const Criteria& criteria,
                                             SelfIntersections& self_intersections,
                                             const StopToken& stop) {
    Refinement result = refine(active, embedding, criteria, stop);
    if (embedding.is_identity()) return result;
    for (int round = 0;; ++round) {
        stop.throw_if_requested();
        const std::vector<SelfIntersection>& found = self_intersections.find();
        result.self_intersections = found.size();
        result.intersection_limit = limit_after(self_intersections, found, result, round);
        if (result.intersection_limit != IntersectionLimit::none || found.empty()) break;
        const Refinement more =
            refine_at(active, embedding, criteria,
                      edges_to_resolve(active, embedding, criteria, found), stop);
        add(result, more);
        if (more.splits > 0) continue;
        result.intersection_limit =
            result.budget_hit ? IntersectionLimit::budget : IntersectionLimit::floor;
        break;
    }
    return result;
}

// Decimation changes the number of those that refinement has left. Only edited faces are searched.
void count_after_decimation(SelfIntersections& self_intersections, Refinement& result) {
    if (self_intersections.is_exhausted()) return;  // what is known is the best there is
    result.self_intersections = self_intersections.find().size();
    if (self_intersections.is_exhausted()) {
        result.intersection_limit = IntersectionLimit::search;
    } else if (result.self_intersections == 0) {
        result.intersection_limit = IntersectionLimit::none;
    } else if (result.intersection_limit == IntersectionLimit::none) {
        result.intersection_limit = IntersectionLimit::decimation;
    }
}

// The same where condition (a) is one for faces and (b) is off.
std::vector<EdgeId> edges_of_curved_faces(const ActiveSet& active, const Criteria& criteria) {
    const TriMesh& mesh = active.mesh();
    const std::vector<FaceId> faces =
        face_pairs::live(mesh, {active.faces().begin(), active.faces().end()});
    const EdgeClassifier classifier(active, criteria);
    std::vector<EdgeId> all;
    std::mutex mutex;
    for_pieces(
        0, static_cast<std::uint32_t>(faces.size()), [&](std::uint32_t first, std::uint32_t end) {
            std::vector<EdgeId> found;
            for (std::uint32_t i = first; i < end; ++i) {
                classifier.visit_curved(
                    TriMesh::half_edge(faces[i], 0),
                    [&](EdgeId e, std::uint16_t) { found.push_back(mesh.representative(e)); });
            }
            const std::scoped_lock lock(mutex);
            all.insert(all.end(), found.begin(), found.end());
        });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// The active edges that need refinement, and those that would if sides with opposed normals
// counted. Of siblings the representative. Sorted, each once.
std::vector<EdgeId> edges_in_need(const ActiveSet& active, const Criteria& criteria) {
    criteria.update();
    if (criteria.curvature_tests_faces() && !criteria.length().is_on()) {
        return edges_of_curved_faces(active, criteria);
    }
    const TriMesh& mesh = active.mesh();
    const EdgeClassifier classifier(active, criteria);
    const auto test = [&](EdgeId e, std::vector<EdgeId>& found) {
        const SplitNeed need = criteria.need(active, e);
        if (need == SplitNeed::itself || criteria.diverges_on_any_side(active, e)) {
            found.push_back(mesh.representative(e));
        }
        if (need != SplitNeed::neighbour) return;
        classifier.for_each_needed_neighbour(
            e, [&](EdgeId first, std::uint16_t) { found.push_back(mesh.representative(first)); });
    };
    const std::span<const EdgeId> edges = active.edges();
    const std::span<const std::uint8_t> smooth = active.smooth_edges();
    std::vector<EdgeId> all;
    std::mutex mutex;
    for_pieces(0, static_cast<std::uint32_t>(edges.size()),
               [&](std::uint32_t first, std::uint32_t end) {
                   std::vector<EdgeId> found;
                   for (std::uint32_t i = first; i < end; ++i) {
                       const EdgeId e = edges[i];
                       if (!mesh.is_live(e) || mesh.sibling(e) != e) continue;
                       const bool is_fine =
                           smooth[i] != 0 && criteria.satisfies_criteria_fast(mesh, e, true);
                       if (!is_fine) test(e, found);
                   }
                   const std::scoped_lock lock(mutex);
                   all.insert(all.end(), found.begin(), found.end());
               });
    FirstOfSiblings is_first(mesh);
    for (const EdgeId e : edges) {
        if (mesh.is_live(e) && mesh.sibling(e) != e && is_first(e)) test(e, all);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
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
                                            const Surroundings& surroundings,
                                            const StopToken& stop) {
    const bool is_guarded = criteria.limits_removal();
    SelfIntersections self_intersections(active, surroundings, stop);
    Adaptation result = timed(
        [&] {
            return refine_without_self_intersections(active, embedding, criteria,
                                                     self_intersections, stop);
        },
        [&] {
            stop.throw_if_requested();
            return decimate(active, criteria, is_guarded ? &self_intersections : nullptr, stop);
        });
    stop.throw_if_requested();
    if (!embedding.is_identity()) count_after_decimation(self_intersections, result.refinement);
    return result;
}

Assessment assess(const ActiveSet& active, const Criteria& criteria, std::vector<EdgeId> blocked) {
    std::ranges::sort(blocked);
    const TriMesh& mesh = active.mesh();
    Assessment result;
    for (const EdgeId e : edges_in_need(active, criteria)) {
        const bool is_held = criteria.is_below_floor(mesh, e) || !mesh.may_split(e) ||
                             std::ranges::binary_search(blocked, e);
        if (is_held) {
            ++result.held_back;
        } else if (criteria.needs_refinement(active, e)) {
            ++result.needing_refinement;
        }
    }
    return result;
}

double largest_divergence_degrees(const TriMesh& mesh) {
    double greatest = 0.0;
    FirstOfSiblings is_first(mesh);
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
        const EdgeId e{i};
        if (!mesh.is_live(e) || !is_first(e)) continue;
        const HalfEdgeId h = mesh.half_edge(e);
        if (!mesh.is_deformed(mesh.origin(h)) && !mesh.is_deformed(mesh.target(h))) continue;
        greatest = std::max(greatest, NormalDivergence::largest_on_any_side(mesh, e));
    }
    // greatest = 1 - cos(angle) = 2 sin^2(angle / 2)
    return 2.0 * std::asin(std::sqrt(std::min(1.0, 0.5 * greatest))) * 180.0 / std::numbers::pi;
}

}  // namespace pectin
