#include "adapt/due_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "adapt/face_pairs.h"
#include "geometry/parallel.h"
#include "mesh/sort_ids.h"

namespace pectin {
namespace {

// A float that is no less than the value.
float rounded_up(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) >= value
               ? rounded
               : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

// In the order in which CertifiedError asks for the bound.
DueFaces::Corners rest_corners(const ActiveSet& active, FaceId f) {
    auto corners = face_pairs::corners_of(active.mesh(), f);
    std::ranges::sort(corners);
    return {active.rest_position(corners[0]), active.rest_position(corners[1]),
            active.rest_position(corners[2])};
}

}  // namespace

DueFaces::Waiting DueFaces::estimated(const ActiveSet& active, const InterpolationError& error,
                                      FaceId f) const {
    const double slope = active.stays(f) ? 0.0 : error.slope_estimate(rest_corners(active, f));
    return {rounded_up(slope), f, edits_[index(f)]};
}

bool DueFaces::is_up_to_date(const ActiveSet& active, const Waiting& waiting) const {
    return edits_[index(waiting.face)] == waiting.edits &&
           face_pairs::is_live(active.mesh(), waiting.face);
}

void DueFaces::push(const Waiting& waiting) {
    heap_.push_back(waiting);
    std::push_heap(heap_.begin(), heap_.end());
}

void DueFaces::begin(const ActiveSet& active, const InterpolationError& error) {
    active_ = &active;
    roll_backs_ = active.roll_backs();
    synced_upto_ = active.edited_faces().size();
    const std::vector<FaceId> faces =
        face_pairs::live(active.mesh(), {active.faces().begin(), active.faces().end()});
    edits_.assign(active.mesh().face_slots(), 0);
    heap_.resize(faces.size());
    for_pieces(0, static_cast<std::uint32_t>(faces.size()),
               [&](std::uint32_t first, std::uint32_t end) {
                   for (std::uint32_t i = first; i < end; ++i) {
                       heap_[i] = estimated(active, error, faces[i]);
                   }
               });
    // No coordinate of an inserted vertex is larger.
    Corners farthest{};
    for (const Vec3& rest : active.rest_positions()) {
        farthest[0] = glm::max(farthest[0], glm::abs(rest));
    }
    rounding_ = error.rounding(farthest);
    std::make_heap(heap_.begin(), heap_.end());
    examined_ += faces.size();
}

void DueFaces::add_edited(const ActiveSet& active, const InterpolationError& error) {
    const std::span<const FaceId> edited = active.edited_faces().subspan(synced_upto_);
    synced_upto_ += edited.size();
    edits_.resize(std::max<std::size_t>(edits_.size(), active.mesh().face_slots()), 0);
    for (FaceId f : edited) {
        if (index(f) < edits_.size()) ++edits_[index(f)];
    }
    for (FaceId f : face_pairs::live(active.mesh(), {edited.begin(), edited.end()})) {
        push(estimated(active, error, f));
        ++examined_;
    }
}

std::vector<FaceId> DueFaces::find(const ActiveSet& active, const InterpolationError& error,
                                   double tolerance) {
    if (active_ != &active || roll_backs_ != active.roll_backs()) {
        begin(active, error);
    } else {
        add_edited(active, error);
    }
    const double length = error.displacement();
    std::vector<FaceId> due;
    std::vector<Waiting> examined;
    while (!heap_.empty() &&
           static_cast<double>(heap_.front().slope) * length + rounding_ > tolerance) {
        std::pop_heap(heap_.begin(), heap_.end());
        Waiting next = heap_.back();
        heap_.pop_back();
        if (!is_up_to_date(active, next)) continue;
        const Corners corners = rest_corners(active, next.face);
        const double slope = active.stays(next.face) ? 0.0 : error.slope(corners);
        ++examined_;
        if (slope * length + error.rounding(corners) > tolerance) due.push_back(next.face);
        next.slope = rounded_up(slope);
        examined.push_back(next);
    }
    for (const Waiting& waiting : examined) push(waiting);
    sort_ids(std::span(due));
    return due;
}

}  // namespace pectin
