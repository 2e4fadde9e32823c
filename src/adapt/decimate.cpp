#include "adapt/decimate.h"

#include <algorithm>
#include <span>
#include <vector>

#include "adapt/concurrent/unsplits.h"
#include "adapt/self_intersections.h"

namespace pectin {
namespace {

using Levels = std::vector<std::vector<VertexId>>;

constexpr std::uint64_t kUnsplitsBetweenQuestions = 1024;

void add_inserted(const TriMesh& mesh, std::span<const VertexId> entries, Levels& levels) {
    for (VertexId v : entries) {
        if (!exists(v) || mesh.is_base(v)) continue;
        const std::size_t level = mesh.level(v);
        if (level >= levels.size()) levels.resize(level + 1);
        levels[level].push_back(v);
    }
}

// The vertices that splits have inserted. Precondition: the vertices are sorted by id, so that base
// vertices come first.
std::span<const VertexId> without_base(const TriMesh& mesh, std::span<const VertexId> by_id) {
    const auto first = std::partition_point(by_id.begin(), by_id.end(),
                                            [&](VertexId v) { return mesh.is_base(v); });
    return by_id.subspan(static_cast<std::size_t>(first - by_id.begin()));
}

// The inserted vertices of the active set, grouped by level. Base vertices (level 0) are no
// candidates: none of them is ever removed. ActiveSet says how its entries are sorted.
Levels candidates_by_level(const ActiveSet& active) {
    const TriMesh& mesh = active.mesh();
    const std::uint32_t influenced = active.influenced_at_begin();
    const std::uint32_t original = active.vertices_at_begin();
    Levels levels;
    add_inserted(mesh, without_base(mesh, active.vertices().first(influenced)), levels);
    add_inserted(mesh,
                 without_base(mesh, active.vertices().subspan(influenced, original - influenced)),
                 levels);
    add_inserted(mesh, active.vertices().subspan(original), levels);
    return levels;
}

class Decimator {
  public:
    Decimator(ActiveSet& active, const Criteria& criteria, SelfIntersections* self_intersections,
              const StopToken& stop)
        : active_(active),
          criteria_(criteria),
          self_intersections_(self_intersections),
          stop_(stop),
          concurrent_unsplits_(active, criteria) {}

    // One pass over all levels. Returns whether a vertex was kept only for self-intersections.
    bool run() {
        bool any_kept = false;
        Levels levels = candidates_by_level(active_);
        for (std::size_t level = levels.size(); level-- > 1 && !result_.was_stopped;) {
            if (!self_intersections_ && concurrent_unsplits_.is_worth(levels[level])) {
                const std::uint64_t removed = concurrent_unsplits_.unsplit(levels[level]);
                result_.unsplits += removed;
                result_.concurrent_unsplits += removed;
                ask_whether_to_stop(removed);
            } else {
                any_kept |= unsplit_one_by_one(chosen(levels[level]));
            }
        }
        return any_kept;
    }

    const Decimation& result() const { return result_; }

  private:
    // Of the vertices of one level, those that may be removed, if removing another one may change
    // that. Otherwise all of them.
    std::span<const VertexId> chosen(std::vector<VertexId>& level) const {
        if (criteria_.curvature_depends_on_faces()) {
            std::erase_if(level,
                          [&](VertexId m) { return !removable_star(active_, criteria_, m); });
        }
        return level;
    }

    bool unsplit_one_by_one(std::span<const VertexId> level) {
        bool any_kept = false;
        for (VertexId m : level) {
            if (result_.was_stopped) break;
            const auto star = criteria_.curvature_depends_on_faces()
                                  ? active_.mesh().removable(m)
                                  : removable_star(active_, criteria_, m);
            if (!star) continue;
            if (self_intersections_ && self_intersections_->would_intersect(*star)) {
                any_kept = true;
                continue;
            }
            active_.unsplit(*star);
            ++result_.unsplits;
            ask_whether_to_stop(1);
        }
        return any_kept;
    }

    // To be called with the number of vertices that have just been removed. Those that may stay do
    // not count, since the next call tests them again.
    void ask_whether_to_stop(std::uint64_t removed) {
        removed_ += removed;
        if (removed_ < kUnsplitsBetweenQuestions) return;
        removed_ = 0;
        result_.was_stopped = stop_.stop_requested();
    }

    ActiveSet& active_;
    const Criteria& criteria_;
    SelfIntersections* self_intersections_;
    const StopToken& stop_;
    std::uint64_t removed_ = 0;  // since the last question
    ConcurrentUnsplits concurrent_unsplits_;
    Decimation result_;
};

}  // namespace

//          a                  a
//         /|\                / \         The split that inserted m is undone: m, ma and md go, and
//        / | \              /   \        bm and mc merge into bc. On a boundary there is no d, and
//       b--m--c    --->    b-----c       three edges meet at m. Along a cut this happens in all
//        \ | /              \   /        sheets.
//         \|/                \ /
//          d                  d
std::optional<Star> removable_star(const ActiveSet& active, const Criteria& criteria, VertexId m) {
    // Removal condition (a), connectivity: exactly four edges are incident on m, or three on a
    // boundary. Removal condition (b): all adjacent vertices are at the level of m or lower.
    const std::optional<Star> star = active.mesh().removable(m);
    // The rest of removal condition (a): all these edges pass decimation conditions (a) and (b).
    // And the guards.
    if (!star || !criteria.may_unsplit(active, *star)) return std::nullopt;
    return star;
}

Decimation decimate(ActiveSet& active, const Criteria& criteria,
                    SelfIntersections* self_intersections, const StopToken& stop) {
    criteria.update();
    Decimator decimator(active, criteria, self_intersections, stop);
    std::uint64_t before = 0;
    bool may_go_on = false;
    do {
        before = decimator.result().unsplits;
        const bool any_kept = decimator.run();
        may_go_on = any_kept || criteria.curvature_depends_on_faces();
    } while (may_go_on && decimator.result().unsplits > before && !decimator.result().was_stopped);
    return decimator.result();
}

}  // namespace pectin
