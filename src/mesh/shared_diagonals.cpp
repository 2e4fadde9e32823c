#include "mesh/shared_diagonals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "geometry/box.h"

namespace pectin {
namespace {

// Relative to the quad's area. An exchange makes no smaller triangle.
constexpr double kSliver = 1e-3;
// Relative to the object's size. Distances that differ by less count as equal.
constexpr double kEqualDistances = 1e-7;

// A diagonal h = ab of a polygon, with the apex c on the side of h and d on the other side.
//       c
//     /   \          .
//    a --- b
//     \   /
//       d
struct Diagonal {
    std::uint32_t h = 0, g = 0;  // its half-edges a -> b and b -> a
};

// The order of exchanges. An exchange and its mirror image have the same rank, and differ only in
// the side.
struct Key {
    std::uint32_t length = 0;            // of the new diagonal, squared, as bits of a float
    std::array<std::int64_t, 6> rank{};  // distances of the midpoints from the mirror planes
    std::array<std::int64_t, 6> side{};  // the same with signs, positive ones first
    std::uint64_t corners = 0;           // of the old diagonal

    auto without_side() const { return std::tie(length, rank); }
    bool operator<(const Key& o) const {
        return std::tie(length, rank, side, corners) <
               std::tie(o.length, o.rank, o.side, o.corners);
    }
};

struct Candidate {
    Diagonal diagonal;
    Key key;
    std::uint64_t new_ends = 0;  // the two vertices of the new diagonal
};

class Exchange {
  public:
    Exchange(const IndexedFaceSet& input, std::span<const Vec3> positions, const Vec3& centre,
             std::span<const std::uint32_t> polygon_of, std::vector<std::uint32_t>& corner_of)
        : input_(input),
          positions_(positions),
          centre_(centre),
          polygon_of_(polygon_of),
          corner_of_(corner_of) {}

    // This terminates: take the number of half-edges beyond two between the same two vertices,
    // summed over all pairs of vertices. It never grows, and the first exchange of each pass lowers
    // it.
    std::vector<std::uint32_t> run(std::span<const HalfEdgeId> half_edges) {
        std::vector<std::uint32_t> changed;
        if (!find_shared(half_edges)) return changed;
        prepare(half_edges);
        for (;;) {
            const std::vector<Candidate> chosen = without_neighbours(without_rivals(candidates()));
            if (chosen.empty()) break;
            for (const Candidate& candidate : chosen) {
                exchange(candidate.diagonal);
                changed.push_back(polygon_of_[candidate.diagonal.h / 3]);
            }
        }
        std::sort(changed.begin(), changed.end());
        changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
        return changed;
    }

  private:
    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    std::uint32_t vertex(std::uint32_t h) const { return input_.corners[corner_of_[h]].position; }
    const Vec3& point(std::uint32_t h) const { return positions_[vertex(h)]; }
    static std::uint64_t pair_of(std::uint32_t v, std::uint32_t w) {
        return std::uint64_t{v} << 32 | w;
    }
    static std::uint64_t unordered_pair_of(std::uint32_t v, std::uint32_t w) {
        return pair_of(std::min(v, w), std::max(v, w));
    }
    // The two corners at the ends of h.
    std::uint64_t corners(std::uint32_t h) const {
        return pair_of(corner_of_[h], corner_of_[next(h)]);
    }
    static std::uint64_t reversed(std::uint64_t corners) { return corners << 32 | corners >> 32; }
    std::uint64_t ends(std::uint32_t h) const {
        return unordered_pair_of(vertex(h), vertex(next(h)));
    }
    std::uint64_t new_ends(const Diagonal& d) const {
        return unordered_pair_of(vertex(prev(d.h)), vertex(prev(d.g)));
    }

    // Finds the diagonals: half-edges with a partner in the opposite direction between the same two
    // corners of one polygon. Returns whether there are any.
    bool find_shared(std::span<const HalfEdgeId> half_edges) {
        std::unordered_set<std::uint64_t> met;
        for (const HalfEdgeId h : half_edges) {
            const std::uint64_t pair = corners(index(h));
            if (met.contains(reversed(pair))) shared_.push_back(pair);
            met.insert(pair);
        }
        return !shared_.empty();
    }

    void prepare(std::span<const HalfEdgeId> half_edges) {
        for (std::uint32_t h = 0; h < corner_of_.size(); ++h) ++users_[ends(h)];
        std::unordered_set<std::uint32_t> polygons;
        for (const HalfEdgeId h : half_edges) polygons.insert(polygon_of_[index(h) / 3]);
        for (std::uint32_t f = 0; f < polygon_of_.size(); ++f) {
            if (polygons.contains(polygon_of_[f])) record_half_edges(f);
        }
        Box box;
        for (const Vec3& p : positions_) box.include(p);
        cells_per_unit_ = 1.0 / std::max(kEqualDistances * box.diagonal(), 1e-300);
    }
    void record_half_edges(std::uint32_t face) {
        for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) half_edge_of_[corners(h)] = h;
    }

    // Whether the other diagonal is possible and no edge joins its ends.
    bool leads_elsewhere(const Diagonal& d) const {
        const auto other = users_.find(new_ends(d));
        return (other == users_.end() || other->second == 0) &&
               vertex(prev(d.h)) != vertex(prev(d.g)) && stays_unfolded(d);
    }
    bool stays_unfolded(const Diagonal& d) const {
        const Vec3 &a = point(d.h), &b = point(d.g), &c = point(prev(d.h)), &e = point(prev(d.g));
        const Vec3 normal = glm::cross(b - a, c - a) + glm::cross(e - a, b - a);
        const double least = kSliver * glm::dot(normal, normal);
        return glm::dot(glm::cross(e - a, c - a), normal) > least &&
               glm::dot(glm::cross(c - b, e - b), normal) > least;
    }

    Key key_of(const Diagonal& d) const {
        const Vec3 &a = point(d.h), &b = point(d.g), &c = point(prev(d.h)), &e = point(prev(d.g));
        constexpr std::uint32_t kEqual = (1u << 10) - 1;  // 2^-13 of a squared length
        const auto squared = static_cast<float>(glm::dot(e - c, e - c));
        Key key{.length = std::bit_cast<std::uint32_t>(squared) & ~kEqual, .corners = corners(d.h)};
        const std::array<Vec3, 2> midpoints{0.5 * (c + e) - centre_, 0.5 * (a + b) - centre_};
        for (std::size_t i = 0; i < 6; ++i) {
            const double cells = midpoints[i / 3][static_cast<int>(i % 3)] * cells_per_unit_;
            key.side[i] = -std::llround(std::clamp(cells, -1e18, 1e18));
            key.rank[i] = std::abs(key.side[i]);
        }
        return key;
    }

    // The possible exchanges in ascending order. Diagonals that are no longer shared are dropped.
    std::vector<Candidate> candidates() {
        std::erase_if(shared_, [&](std::uint64_t pair) {
            const auto h = half_edge_of_.find(pair);
            return h == half_edge_of_.end() || users_[ends(h->second)] <= 2;
        });
        std::vector<Candidate> result;
        for (const std::uint64_t pair : shared_) {
            const Diagonal d{half_edge_of_[pair], half_edge_of_[reversed(pair)]};
            if (leads_elsewhere(d)) result.push_back({d, key_of(d), new_ends(d)});
        }
        std::sort(result.begin(), result.end(),
                  [](const Candidate& x, const Candidate& y) { return x.key < y.key; });
        return result;
    }
    // The first of those with the same new ends; none if another has the same rank.
    static std::vector<Candidate> without_rivals(std::vector<Candidate> candidates) {
        std::unordered_map<std::uint64_t, std::size_t> first;
        std::vector<bool> is_kept(candidates.size(), false);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const auto [found, is_first] = first.try_emplace(candidates[i].new_ends, i);
            const Key& best = candidates[found->second].key;
            if (is_first) {
                is_kept[i] = true;
            } else if (candidates[i].key.without_side() == best.without_side()) {
                is_kept[found->second] = false;
            }
        }
        std::size_t i = 0;
        std::erase_if(candidates, [&](const Candidate&) { return !is_kept[i++]; });
        return candidates;
    }
    // Those that have no triangle in common with an earlier one.
    static std::vector<Candidate> without_neighbours(std::vector<Candidate> candidates) {
        std::unordered_set<std::uint32_t> taken;
        std::erase_if(candidates, [&](const Candidate& candidate) {
            const std::uint32_t f = candidate.diagonal.h / 3, g = candidate.diagonal.g / 3;
            if (taken.contains(f) || taken.contains(g)) return true;
            taken.insert({f, g});
            return false;
        });
        return candidates;
    }

    // Replaces abc and bad by adc and bcd.
    void exchange(const Diagonal& d) {
        users_[ends(d.h)] -= 2;
        half_edge_of_.erase(corners(d.h));
        half_edge_of_.erase(corners(d.g));
        const std::uint32_t before = corner_of_[prev(d.h)], behind = corner_of_[prev(d.g)];
        corner_of_[next(d.h)] = behind;
        corner_of_[next(d.g)] = before;
        users_[ends(next(d.h))] += 2;
        record_half_edges(d.h / 3);
        record_half_edges(d.g / 3);
    }

    const IndexedFaceSet& input_;
    std::span<const Vec3> positions_;
    const Vec3& centre_;
    std::span<const std::uint32_t> polygon_of_;
    std::vector<std::uint32_t>& corner_of_;
    std::vector<std::uint64_t> shared_;  // diagonals, by the corners of one of their half-edges
    std::unordered_map<std::uint64_t, std::uint32_t> users_;  // half-edges between two vertices
    // Half-edges of polygons with shared edges, by their corners.
    std::unordered_map<std::uint64_t, std::uint32_t> half_edge_of_;
    double cells_per_unit_ = 1.0;
};

}  // namespace

std::vector<std::uint32_t> exchange_shared_diagonals(const IndexedFaceSet& input,
                                                     std::span<const Vec3> positions,
                                                     const Vec3& centre,
                                                     std::span<const std::uint32_t> polygon_of,
                                                     std::span<const HalfEdgeId> half_edges,
                                                     std::vector<std::uint32_t>& corner_of) {
    return Exchange(input, positions, centre, polygon_of, corner_of).run(half_edges);
}

}  // namespace pectin
