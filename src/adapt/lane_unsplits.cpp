#include "adapt/lane_unsplits.h"

#include <algorithm>
#include <utility>

#include "adapt/parallel.h"

namespace pectin {
namespace {

constexpr std::size_t kSample = 1024;

}  // namespace

std::uint64_t LaneUnsplits::unsplit(std::span<const VertexId> level) {
    claims_.begin(active_.vertex_entries());
    part(level);
    for (Lane& lane : lanes_) reserve(lane);
    active_.reserve_unsplits(level.size());
    for_each_of(lanes_, [this](Lane& lane) { unsplit(lane); });
    std::uint64_t removed = 0;
    for (Lane& lane : lanes_) {
        unsplit_waiting(lane);
        removed += lane.unsplits.size();
    }
    log();
    for (const Lane& lane : lanes_) {
        for (VertexId m : lane.last) active_.unsplit(*active_.mesh().removable(m));
        removed += lane.last.size();
    }
    return removed;
}

// One lane after another.
void LaneUnsplits::log() {
    for_each_of(lanes_, [this](Lane& lane) { lane.count = active_.count(lane.unsplits); });
    for (Lane& lane : lanes_) lane.places = active_.allocate_unsplits(lane.count);
    for_each_of(lanes_, [this](Lane& lane) { active_.log_unsplits(lane.unsplits, lane.places); });
}

// By their base faces, those of one base face in their order; about as many in each.
void LaneUnsplits::part(std::span<const VertexId> level) {
    using Place = std::pair<FaceId, std::size_t>;
    const auto place = [&, mesh = &active_.mesh()](std::size_t i) {
        return Place(mesh->base_face(TriMesh::face(mesh->half_edge(level[i]))), i);
    };
    std::vector<Place> sample;
    for (std::size_t i = 0; i < level.size(); i += 1 + level.size() / kSample) {
        sample.push_back(place(i));
    }
    std::ranges::sort(sample);
    std::array<Place, kLanes - 1> borders{};
    for (std::size_t i = 0; i < borders.size(); ++i) {
        borders[i] = sample[(i + 1) * sample.size() / kLanes];
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        lanes_[i].number = static_cast<CornerClaims::Lane>(i);
        lanes_[i].vertices.clear();
    }
    for (std::size_t i = 0; i < level.size(); ++i) {
        const auto lane = std::ranges::upper_bound(borders, place(i)) - borders.begin();
        lanes_[static_cast<std::size_t>(lane)].vertices.push_back(level[i]);
    }
}

// For what unsplitting them takes at most.
void LaneUnsplits::reserve(Lane& lane) {
    lane.unsplits.clear();
    lane.waiting.clear();
    lane.last.clear();
    lane.unsplits.reserve(lane.vertices.size());
    lane.waiting.reserve(lane.vertices.size());
    lane.last.reserve(lane.vertices.size());
}

// Before a star's corners are the lane's, it only reads what no other lane writes.
void LaneUnsplits::unsplit(Lane& lane) {
    for (VertexId m : lane.vertices) {
        const auto star = active_.mesh().removable(m);
        if (!star || !criteria_.may_unsplit(active_, *star)) continue;
        const auto corners = corners_of(*star);
        if (!corners) {
            lane.last.push_back(m);
        } else if (claims_.take(*corners, lane.number)) {
            lane.unsplits.push_back(active_.unsplit_apart(*star));
        } else {
            lane.waiting.push_back(lane.unsplits.size());
            lane.unsplits.push_back({.ids = {.m = m}});
        }
    }
}

// None where it has to go alone.
std::optional<CornerClaims::Corners> LaneUnsplits::corners_of(const Star& star) const {
    if (!active_.may_unsplit_apart(star)) return std::nullopt;
    return CornerClaims::corners(active_, {star.a, star.b, star.c, star.d});
}

void LaneUnsplits::unsplit_waiting(Lane& lane) {
    for (std::size_t i : lane.waiting) {
        ActiveSet::Unsplit& waiting = lane.unsplits[i];
        waiting = active_.unsplit_apart(*active_.mesh().removable(waiting.ids.m));
    }
}

}  // namespace pectin
