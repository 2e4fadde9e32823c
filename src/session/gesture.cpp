#include "session/gesture.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace pectin {

Gesture::Gesture(ActiveSet& active, Warp warp, const std::optional<AdaptLimits>& limits)
    : active_(active), warp_(std::move(warp)), embedding_(active_, warp_) {
    assert(active_.is_begun() && !warp_.steps.empty());
    const Box zone = warp_.zone();
    if (limits) criteria_.emplace(*limits, zone, zone);
    influenced_ = active_.influenced_at_begin();
    embedding_.embed();
}

Gesture::~Gesture() {
    if (active_.is_begun()) cancel();
}

const Frame& Gesture::frame(std::span<const Vec3> displacements) {
    std::vector<Vec3>& d = warp_.steps.back().displacements;
    assert(displacements.size() == d.size());
    // At the budget, refinement rests until the drag changes: thinning would make room for a few
    // splits, and the next frame would thin those.
    if (has_frames_ && last_.budget_hit && std::ranges::equal(d, displacements)) return last_;
    std::ranges::copy(displacements, d.begin());
    const auto begin = std::chrono::steady_clock::now();
    embedding_.deform();
    const std::chrono::duration<double> deforming = std::chrono::steady_clock::now() - begin;
    last_ = {};
    last_.deform_seconds = deforming.count();
    if (criteria_) {
        Adaptation adaptation = adapt(active_, embedding_, *criteria_);
        last_.splits = adaptation.refinement.splits;
        last_.unsplits = adaptation.decimation.unsplits;
        last_.floor_hit = adaptation.refinement.floor_hit;
        last_.budget_hit = adaptation.refinement.budget_hit;
        last_.blocked = std::move(adaptation.refinement.blocked);
        last_.refine_seconds = adaptation.refine_seconds;
        last_.decimate_seconds = adaptation.decimate_seconds;
    }
    has_frames_ = true;
    return last_;
}

MeshChange Gesture::commit(std::span<const Vec3> displacements) {
    if (has_frames_) active_.roll_back();
    has_frames_ = false;
    frame(displacements);
    folded_ = embedding_.folded_vertices();
    return active_.finish();
}

std::vector<FaceId> Gesture::cancel() {
    std::vector<FaceId> faces = active_.faces();
    active_.roll_back();
    active_.finish();
    return faces;
}

std::vector<WedgeId> Gesture::moved_wedges() const {
    std::vector<WedgeId> wedges;
    wedges.reserve(active_.influenced_wedges_at_begin());
    for (std::uint32_t i = 0; i < active_.wedge_entries(); ++i) {
        if (exists(active_.wedge(i)) && active_.is_influenced_at(active_.wedge_owner(i))) {
            wedges.push_back(active_.wedge(i));
        }
    }
    return wedges;
}

}  // namespace pectin
