#include "adapt/lane_splits.h"

#include <type_traits>

#include "adapt/parallel.h"

namespace pectin {

void LaneSplits::split(const RefinementQueue::Entries& next) {
    const std::size_t entries = active_.vertex_entries();
    if (claims_.entries() < entries) claims_.begin(2 * entries);
    chosen_.resize(active_.edges().size(), 0);
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        lanes_[i].number = static_cast<CornerClaims::Lane>(i);
        lanes_[i].edges = next.lanes[i];
    }
    for_each_of(lanes_, [&](Lane& lane) { look(lane, next.octave); });
    for_each_of(lanes_, [&](Lane& lane) { choose(lane); });
    allocate(number_lanes());
    for_each_of(lanes_, [&](Lane& lane) {
        make(lane);
        forget(lane);
    });
}

bool LaneSplits::most_went() const {
    std::size_t went = 0, came = 0;
    for (const Lane& lane : lanes_) {
        went += lane.order.size();
        came += lane.candidates.size();
    }
    return 2 * went > came;
}

// --- Which edges go

void LaneSplits::look(Lane& lane, std::size_t octave) {
    lane.candidates.clear();
    for (EdgeId e : lane.edges) {
        if (!looks_.still_needs_split(e, octave)) continue;
        lane.candidates.push_back(candidate(e));
        const auto& corners = lane.candidates.back().corners;
        if (corners) claims_.claim(*corners, lane.number);
    }
}

LaneSplits::Candidate LaneSplits::candidate(EdgeId e) const {
    const TriMesh& mesh = active_.mesh();
    const HalfEdgeId h = mesh.half_edge(e), twin = mesh.twin(h);
    Candidate found{e, mesh.target(h)};
    if (active_.entry_of(e) && mesh.is_smooth(e)) {
        found.corners = CornerClaims::corners(
            active_, {mesh.origin(h), found.end, mesh.origin(TriMesh::prev(h)),
                      mesh.origin(TriMesh::prev(twin))});
    }
    return found;
}

// What waits for one that comes later in the lane goes after it.
void LaneSplits::choose(Lane& lane) {
    lane.order.clear();
    std::size_t before = 0;
    do {
        before = lane.order.size();
        for (Candidate& candidate : lane.candidates) {
            if (candidate.goes || !candidate.corners) continue;
            if (!claims_.are_of(*candidate.corners, lane.number) || !goes_next(candidate.edge))
                continue;
            candidate.goes = true;
            chosen_[*active_.entry_of(candidate.edge)] = 1;
            lane.order.push_back(candidate.edge);
        }
    } while (lane.order.size() > before && lane.order.size() < lane.candidates.size());
}

bool LaneSplits::is_chosen(EdgeId e) const {
    const auto entry = active_.entry_of(e);
    return entry && chosen_[*entry] != 0;
}

// Whether no edge of its faces will have to go before it, once those chosen so far have been split.
bool LaneSplits::goes_next(EdgeId e) {
    if (is_chosen(e)) return false;  // comes again
    return limits_.symmetry ? is_let_go<RestEdge>(e) : is_let_go<double>(e);
}

// Edge: where there is no symmetry, a length tells all of it.
template <typename Edge>
bool LaneSplits::is_let_go(EdgeId e) {
    const Edge own = at_rest<Edge>(e);
    const HalfEdgeId h = active_.mesh().half_edge(e);
    return lets_go(h, own) && lets_go(active_.mesh().twin(h), own);
}

template <typename Edge>
bool LaneSplits::lets_go(HalfEdgeId h, const Edge& own) {
    const TriMesh& mesh = active_.mesh();
    const EdgeId next = mesh.edge(TriMesh::next(h)), prev = mesh.edge(TriMesh::prev(h));
    const bool next_goes = is_chosen(next), prev_goes = is_chosen(prev);
    if (!next_goes && !prev_goes) {
        return order_.fits_beside(at_rest<Edge>(next), own) &&
               order_.fits_beside(at_rest<Edge>(prev), own);
    }
    // The face at h has half of the one that goes first then, and its spoke; it may be either.
    const auto fits = [&](EdgeId split, VertexId near, VertexId apex) {
        const Vec3 m = middle(split);
        const double half = 0.5 * static_cast<double>(active_.keep_rest_length(split)),
                     spoke = static_cast<double>(active_.spoke_at_rest(apex, m));
        return order_.fits_beside(to_middle<Edge>(half, near, m), own) &&
               order_.fits_beside(to_middle<Edge>(spoke, apex, m), own);
    };
    return (!next_goes || fits(next, mesh.target(h), mesh.origin(h))) &&
           (!prev_goes || fits(prev, mesh.origin(h), mesh.target(h)));
}

template <typename Edge>
Edge LaneSplits::at_rest(EdgeId e) {
    const auto length = static_cast<double>(active_.keep_rest_length(e));
    if constexpr (std::is_same_v<Edge, RestEdge>) {
        return order_.at_rest(active_, e, length);
    } else {
        return length;
    }
}

// Of an edge that will be there: from v to the midpoint m.
template <typename Edge>
Edge LaneSplits::to_middle(double length, VertexId v, const Vec3& m) const {
    if constexpr (std::is_same_v<Edge, RestEdge>) {
        return {length, active_.rest_position(v), m};
    } else {
        return length;
    }
}

Vec3 LaneSplits::middle(EdgeId e) const {
    const HalfEdgeId h = active_.mesh().half_edge(e);
    return 0.5 * active_.rest_position(active_.mesh().origin(h)) +
           0.5 * active_.rest_position(active_.mesh().target(h));
}

// --- Splitting them

// Gives the lanes their places, one after another; how many there are.
std::uint32_t LaneSplits::number_lanes() {
    std::uint32_t count = 0;
    for (Lane& lane : lanes_) {
        lane.first = count;
        count += static_cast<std::uint32_t>(lane.order.size());
    }
    const TriMesh& mesh = active_.mesh();
    if (mesh.has_levels_for(count) && mesh.face_count() + std::size_t{2} * count <= limits_.budget)
        return count;
    for (Lane& lane : lanes_) leave_all(lane);
    return 0;
}

// All of it has to be looked at one by one.
void LaneSplits::leave_all(Lane& lane) {
    forget(lane);
    for (Candidate& candidate : lane.candidates) candidate.goes = false;
    lane.order.clear();
}

void LaneSplits::allocate(std::uint32_t count) {
    embedding_.reserve_splits(count);
    for (Lane& lane : lanes_) {
        lane.inserted.reserve(lane.order.size());
        lane.made.reserve(EdgeLooks::kMostNeeded * lane.order.size());
        lane.scratch.resize(embedding_.scratch_size());
    }
    active_.allocate_splits(count, places_);
    embedding_.fit_to_entries();
}

void LaneSplits::make(Lane& lane) {
    lane.inserted.clear();
    for (std::size_t i = 0; i < lane.order.size(); ++i) {
        lane.inserted.push_back(active_.split_apart(lane.order[i], places_, lane.first + i));
    }
    embedding_.place(lane.inserted, lane.scratch);
    lane.made.clear();
    for (const ActiveSet::Inserted& made : lane.inserted) {
        looks_.for_each_needed(
            made, [&](EdgeId e, std::uint16_t octave) { lane.made.emplace_back(e, octave); });
    }
}

// Whose its corners are and what it has chosen.
void LaneSplits::forget(Lane& lane) {
    for (const Candidate& candidate : lane.candidates) {
        if (candidate.goes) chosen_[*active_.entry_of(candidate.edge)] = 0;
        if (candidate.corners) claims_.give_up(*candidate.corners);
    }
}

}  // namespace pectin
