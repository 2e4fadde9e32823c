#include "session/gesture.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <iterator>
#include <new>
#include <utility>

#include "adapt/accumulated_error.h"
#include "geometry/stop_token.h"

namespace pectin {
namespace {

// The number of edits for each vertex of the active set beyond which the frames are rolled back.
constexpr std::uint64_t kMostEdits = 4;

}  // namespace

Gesture::Gesture(ActiveSet& active, const GestureFaces& faces, Warp warp,
                 std::optional<Adaptivity> adaptivity, const StopToken& stop)
    : active_(active), warp_(std::move(warp)), embedding_(active_, warp_) {
    assert(!warp_.steps.empty());
    const Box zone = warp_.zone();
    if (adaptivity) {
        AdaptLimits& limits = adaptivity->limits;
        const std::uint64_t faces_now = active_.mesh().face_count();
        is_drag_budget_less_ =
            limits.budget > faces_now && adaptivity->drag_budget < limits.budget - faces_now;
        if (is_drag_budget_less_) limits.budget = faces_now + adaptivity->drag_budget;
        criteria_.emplace(limits, warp_.zones(), std::optional(warp_.zones()), &embedding_);
        criteria_->keep(std::move(adaptivity->kept));
    }
    try {
        if (criteria_ && criteria_->certified_error()) active_.mesh().track_errors();
        active_.begin(faces.moving, zone, faces.staying);
        stop.throw_if_requested();
        embedding_.embed(stop);
    } catch (...) {  // stopped, or out of memory: nothing has been edited yet
        active_.abandon();
        throw;
    }
    influenced_ = active_.influenced_at_begin();
}

Gesture::~Gesture() {
    if (active_.is_begun()) active_.cancel();
}

const Frame& Gesture::frame(std::span<const Vec3> displacements, std::optional<Duration> time) {
    // Once a budget is used up, refinement rests until the drag changes. Decimation would free
    // some triangles for a few splits, and the next frame would remove these again.
    const bool rests = has_frames_ && last_.is_budget_used_up() &&
                       std::ranges::equal(displacements_of(warp_.steps.back()), displacements);
    if (rests && last_.is_complete) return last_;
    const bool was_budget_hit = last_.budget_hit, was_drag_budget_hit = last_.drag_budget_hit;
    apply(displacements, [&](ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
        const StopToken stop = time ? StopToken::after(*time) : StopToken{};
        if (!rests) return pectin::adapt(active, embedding, criteria, stop);
        return Adaptation{.refinement = {},
                          .decimation = decimate(active, criteria, nullptr, stop)};
    });
    if (rests && has_frames_) {
        last_.budget_hit = was_budget_hit;
        last_.drag_budget_hit = was_drag_budget_hit;
    }
    return last_;
}

template <typename Adapt>
const Frame& Gesture::apply(std::span<const Vec3> displacements, Adapt adapt) {
    // A long drag undoes most of its edits again. Rolling back to the rest state frees their
    // memory.
    if (active_.edit_count() > kMostEdits * (active_.vertex_entries() + 1000)) roll_back();
    set_displacements(displacements);
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
        const bool is_used_up_now = adaptation.refinement.budget_hit;
        last_.budget_hit = is_used_up_now && !is_drag_budget_less_;
        last_.drag_budget_hit = is_used_up_now && is_drag_budget_less_;
        last_.self_intersections = adaptation.refinement.self_intersections;
        last_.intersection_limit = adaptation.refinement.intersection_limit;
        last_.blocked = std::move(adaptation.refinement.blocked);
        last_.is_complete = !adaptation.was_stopped();
        last_.refine_seconds = adaptation.refine_seconds;
        last_.decimate_seconds = adaptation.decimate_seconds;
    }
    has_frames_ = true;
    return last_;
}

Assessment Gesture::assessment() const {
    return criteria_ ? assess(active_, *criteria_, last_.blocked) : Assessment{};
}

std::vector<Box> Gesture::zones_with_reach(std::span<const Vec3> displacements) {
    set_displacements(displacements);
    std::vector<Box> boxes;
    for (const Deformation& step : warp_.steps) {
        const Vec3 reach{reach_bound(step)};
        for (const Box& zone : zones_of(step)) {
            boxes.push_back({.min = zone.min - reach, .max = zone.max + reach});
        }
    }
    return boxes;
}

void Gesture::return_to_rest() {
    if (has_frames_) roll_back();
}

void Gesture::set_displacements(std::span<const Vec3> displacements) {
    const std::span<Vec3> d = displacements_of(warp_.steps.back());
    assert(displacements.size() == d.size());
    std::ranges::copy(displacements, d.begin());
}

MeshChange Gesture::commit(std::span<const Vec3> displacements, const SearchedFaces& searched,
                           const StopToken& stop) {
    return_to_rest();
    apply(displacements, [&](ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
        const Adaptation adaptation =
            criteria.limits().without_self_intersections
                ? adapt_without_self_intersections(active, embedding, criteria,
                                                   searched.surroundings, stop)
                : pectin::adapt(active, embedding, criteria, stop);
        stop.throw_if_requested();
        return adaptation;
    });
    last_.assessment = assessment();
    if (criteria_) last_.error = accumulate_errors(active_, *criteria_);
    folded_ = embedding_.folded_vertices();
    last_.passed = find_passed_faces(active_, searched.staying, stop);
    return active_.finish();
}

std::optional<std::vector<FaceId>> Gesture::cancel() noexcept {
    std::optional<std::vector<FaceId>> faces;
    try {
        faces.emplace(active_.faces().begin(), active_.faces().end());
        faces->insert(faces->end(), rolled_back_faces_.begin(), rolled_back_faces_.end());
    } catch (const std::bad_alloc&) {
        faces.reset();
    }
    active_.cancel();
    return faces;
}

void Gesture::roll_back() {
    const auto edited = active_.edited_faces();
    rolled_back_faces_.insert(rolled_back_faces_.end(), edited.begin(), edited.end());
    taken_faces_ = 0;
    has_frames_ = false;
    active_.roll_back();
}

std::vector<FaceId> Gesture::take_edited_faces() {
    std::vector<FaceId> faces = std::exchange(rolled_back_faces_, {});
    if (!active_.is_begun()) return faces;
    const auto edited = active_.edited_faces();
    faces.insert(faces.end(), edited.begin() + static_cast<std::ptrdiff_t>(taken_faces_),
                 edited.end());
    taken_faces_ = edited.size();
    return faces;
}

void Gesture::append_moved_wedges(std::vector<WedgeId>& wedges) const {
    const std::span<const WedgeId> all = active_.wedges();
    const std::uint32_t moved = active_.influenced_wedges_at_begin();
    if (wedges.empty()) wedges.reserve(all.size());
    const auto is_there = [](WedgeId w) { return exists(w); };
    if (active_.unsplits() == 0) {  // none was removed
        wedges.insert(wedges.end(), all.begin(), all.begin() + moved);
    } else {
        std::copy_if(all.begin(), all.begin() + moved, std::back_inserter(wedges), is_there);
    }
    for (std::uint32_t i = moved; i < all.size(); ++i) {
        if (is_there(all[i]) && active_.is_influenced_at(active_.wedge_owner(i))) {
            wedges.push_back(all[i]);
        }
    }
}

}  // namespace pectin
