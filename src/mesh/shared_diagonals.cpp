#include "mesh/shared_diagonals.h"

#include <algorithm>
#include <unordered_map>

namespace pectin {
namespace {

// An exchange can only leave diagonals shared that the ones before it have not met, so few passes
// change anything.
constexpr int kMostPasses = 8;
// Of the quad's area; an exchange leaves no smaller triangle.
constexpr double kSliver = 1e-3;

// A diagonal h = ab of a polygon, with c before and d behind it.
//       c
//     /   \          .
//    a --- b
//     \   /
//       d
struct Diagonal {
    std::uint32_t h = 0, g = 0;  // its half-edges a -> b and b -> a
};

class Exchange {
  public:
    Exchange(const IndexedFaceSet& input, std::span<const Vec3> positions,
             std::span<const std::uint32_t> polygon_of, std::vector<std::uint32_t>& corner_of)
        : input_(input), positions_(positions), polygon_of_(polygon_of), corner_of_(corner_of) {}

    std::vector<std::uint32_t> run(std::span<const HalfEdgeId> half_edges) {
        std::vector<Diagonal> diagonals = diagonals_among(half_edges);
        std::vector<std::uint32_t> changed;
        if (diagonals.empty()) return changed;
        for (std::uint32_t h = 0; h < corner_of_.size(); ++h) ++users_[ends(h)];
        for (int pass = 0; pass < kMostPasses; ++pass) {
            const std::vector<Diagonal> chosen = exchangeable(diagonals);
            if (chosen.empty()) break;
            for (const Diagonal& d : chosen) {
                // One before it may have changed a triangle of this one. Whether the ends are
                // still shared is not asked again: diagonals that are each other's mirror image
                // are both exchanged.
                if (!is_whole(d) || !leads_elsewhere(d)) continue;
                exchange(d);
                changed.push_back(polygon_of_[d.h / 3]);
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
        return std::uint64_t{std::min(v, w)} << 32 | std::max(v, w);
    }
    std::uint64_t ends(std::uint32_t h) const { return pair_of(vertex(h), vertex(next(h))); }
    std::uint64_t other_ends(const Diagonal& d) const {
        return pair_of(vertex(prev(d.h)), vertex(prev(d.g)));
    }

    bool are_opposite(std::uint32_t h, std::uint32_t g) const {
        return corner_of_[h] == corner_of_[next(g)] && corner_of_[g] == corner_of_[next(h)];
    }
    bool is_whole(const Diagonal& d) const { return are_opposite(d.h, d.g); }

    // Half-edges of one polygon that run between the same two corners of it, each way.
    std::vector<Diagonal> diagonals_among(std::span<const HalfEdgeId> half_edges) const {
        std::vector<Diagonal> diagonals;
        std::unordered_map<std::uint64_t, std::uint32_t> by_corners;
        for (const HalfEdgeId id : half_edges) {
            const std::uint32_t h = index(id);
            const auto [other, is_first] =
                by_corners.try_emplace(pair_of(corner_of_[h], corner_of_[next(h)]), h);
            if (!is_first && are_opposite(h, other->second))
                diagonals.push_back({other->second, h});
        }
        return diagonals;
    }

    bool is_shared(const Diagonal& d) const { return users_.find(ends(d.h))->second > 2; }
    // Whether the other diagonal is possible and its ends have no edge.
    bool leads_elsewhere(const Diagonal& d) const {
        const auto other = users_.find(other_ends(d));
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
    std::vector<Diagonal> exchangeable(const std::vector<Diagonal>& diagonals) const {
        std::vector<Diagonal> chosen;
        std::unordered_map<std::uint64_t, int> wanted;
        for (const Diagonal& d : diagonals) {
            if (!is_whole(d) || !is_shared(d) || !leads_elsewhere(d)) continue;
            chosen.push_back(d);
            ++wanted[other_ends(d)];
        }
        std::erase_if(chosen, [&](const Diagonal& d) { return wanted[other_ends(d)] > 1; });
        return chosen;
    }

    // abc and bad become adc and bcd.
    void exchange(const Diagonal& d) {
        users_[ends(d.h)] -= 2;
        const std::uint32_t before = corner_of_[prev(d.h)], behind = corner_of_[prev(d.g)];
        corner_of_[next(d.h)] = behind;
        corner_of_[next(d.g)] = before;
        users_[ends(next(d.h))] += 2;
    }

    const IndexedFaceSet& input_;
    std::span<const Vec3> positions_;
    std::span<const std::uint32_t> polygon_of_;
    std::vector<std::uint32_t>& corner_of_;
    std::unordered_map<std::uint64_t, std::uint32_t> users_;  // half-edges between two vertices
};

}  // namespace

std::vector<std::uint32_t> exchange_shared_diagonals(const IndexedFaceSet& input,
                                                     std::span<const Vec3> positions,
                                                     std::span<const std::uint32_t> polygon_of,
                                                     std::span<const HalfEdgeId> half_edges,
                                                     std::vector<std::uint32_t>& corner_of) {
    return Exchange(input, positions, polygon_of, corner_of).run(half_edges);
}

}  // namespace pectin
