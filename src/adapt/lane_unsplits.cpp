#include "adapt/lane_unsplits.h"

#include <algorithm>

#include "adapt/parallel.h"

namespace pectin {
namespace {

constexpr std::size_t kSample = 1024;

}  // namespace

std::uint64_t LaneUnsplits::unsplit(std::span<const VertexId> level) {
    claims_.begin(active_.mesh().vertex_slots());
    part(level);
    for_each_of(lanes_, [this](Lane& lane) { unsplit(lane); });
    std::uint64_t removed = 0;
    for (Lane& lane : lanes_) {
        unsplit_waiting(lane);
        removed += lane.unsplits.size();
    }
    for (const Lane& lane : lanes_) active_.log_unsplits(lane.unsplits);
    for (const Lane& lane : lanes_) {
        for (VertexId m : lane.last) active_.unsplit(*active_.mesh().removable(m));
        removed += lane.last.size();
    }
    return removed;
}

// By their base faces, about as many in each.
void LaneUnsplits::part(std::span<const VertexId> level) {
    const auto place = [mesh = &active_.mesh()](VertexId m) {
        return mesh->base_face(TriMesh::face(mesh->half_edge(m)));
    };
    std::vector<FaceId> sample;
    for (std::size_t i = 0; i < level.size(); i += 1 + level.size() / kSample) {
        sample.push_back(place(level[i]));
    }
    std::ranges::sort(sample);
    std::array<FaceId, kLanes - 1> borders{};
    for (std::size_t i = 0; i < borders.size(); ++i) {
        borders[i] = sample[(i + 1) * sample.size() / kLanes];
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        lanes_[i].number = static_cast<CornerClaims::Lane>(i);
        lanes_[i].vertices.clear();
    }
    for (VertexId m : level) {
        const auto lane = std::ranges::upper_bound(borders, place(m)) - borders.begin();
        lanes_[static_cast<std::size_t>(lane)].vertices.push_back(m);
    }
}

// Before a star's corners are the lane's, it only reads what no other lane writes.
void LaneUnsplits::unsplit(Lane& lane) {
    lane.unsplits.clear();
    lane.unsplits.reserve(lane.vertices.size());
    lane.waiting.clear();
    lane.last.clear();
    for (VertexId m : lane.vertices) {
        const auto star = active_.mesh().removable(m);
        if (!star || !criteria_.may_unsplit(active_, *star)) continue;
        if (!active_.may_unsplit_apart(*star)) {
            lane.last.push_back(m);
        } else if (claims_.take({star->a, star->b, star->c, star->d}, lane.number)) {
            lane.unsplits.push_back(active_.unsplit_apart(*star));
        } else {
            lane.waiting.push_back(lane.unsplits.size());
            lane.unsplits.push_back({.ids = {.m = m}});
        }
    }
}

void LaneUnsplits::unsplit_waiting(Lane& lane) {
    for (std::size_t i : lane.waiting) {
        ActiveSet::Unsplit& waiting = lane.unsplits[i];
        waiting = active_.unsplit_apart(*active_.mesh().removable(waiting.ids.m));
    }
}

}  // namespace pectin
