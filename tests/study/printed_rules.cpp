#include "study/printed_rules.h"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <vector>

namespace pectin::study {
namespace {

class PrintedRefiner {
  public:
    PrintedRefiner(Scene& scene, const PrintedRules& rules)
        : scene_(scene),
          mesh_(scene.mesh()),
          rules_(rules),
          criteria_(scene.criteria({.curvature = rules.curvature})) {}

    PrintedRefinement run() {
        const std::vector<EdgeId> edges(scene_.active().edges().begin(),
                                        scene_.active().edges().end());
        for (const EdgeId e : edges) test(e);
        while (!heap_.empty()) {
            const Entry next = heap_.top();
            heap_.pop();
            // The edge may have been split since, as a neighbour put it on the heap once more.
            if (mesh_.length(next.edge) != next.length || end_of(next.edge) != next.end) continue;
            if (mesh_.face_count() >= rules_.most_faces || !mesh_.may_split(next.edge)) {
                result_.has_ended = false;
                break;
            }
            split(next.edge);
        }
        return result_;
    }

  private:
    struct Entry {
        double precedence;  // the greatest comes first
        EdgeId edge;
        VertexId end;
        double length;
        bool operator<(const Entry& other) const { return precedence < other.precedence; }
    };

    VertexId end_of(EdgeId e) const { return mesh_.target(mesh_.half_edge(e)); }

    void test(EdgeId e) {
        if (!mesh_.is_live(e) || mesh_.representative(e) != e) return;
        ++result_.tests;
        const double length = mesh_.length(e);
        const bool needs_refinement = criteria_.curvature_needs_refinement(scene_.active(), e) ||
                                      (length > rules_.l_max && meets_zone(e));
        if (!needs_refinement) return;
        const double precedence =
            rules_.order == Order::longest_first ? length : -static_cast<double>(result_.tests);
        heap_.push({precedence, e, end_of(e), length});
    }

    // Whether a face of e meets the zone at rest.
    bool meets_zone(EdgeId e) const {
        bool any = false;
        mesh_.for_each_side(e, [&](HalfEdgeId h) {
            const auto rest = [&](HalfEdgeId of) {
                return scene_.active().rest_position(mesh_.origin(of));
            };
            any = any || triangle_meets_box(rest(h), rest(TriMesh::next(h)), rest(TriMesh::prev(h)),
                                            scene_.active().zone());
        });
        return any;
    }

    void split(EdgeId e) {
        inserted_.clear();
        const VertexId m = scene_.active().split(e, inserted_).m;
        scene_.embedding().fit_to_entries();
        scene_.embedding().embed_inserted(inserted_);
        ++result_.splits;
        for (const ActiveSet::Inserted& made : inserted_) {
            for (const EdgeId edge : made.edges) {
                if (!exists(edge)) continue;
                test(edge);
                if (criteria_.curvature_depends_on_faces()) test_outer(edge, m);
            }
        }
    }

    void test_outer(EdgeId edge, VertexId m) {
        std::vector<EdgeId> outer;
        mesh_.for_each_side(edge, [&](HalfEdgeId h) {
            outer.push_back(mesh_.edge(mesh_.origin(h) == m ? TriMesh::next(h) : TriMesh::prev(h)));
        });
        for (const EdgeId e : outer) test(e);
    }

    Scene& scene_;
    const TriMesh& mesh_;
    const PrintedRules& rules_;
    Criteria criteria_;
    std::priority_queue<Entry> heap_;
    std::vector<ActiveSet::Inserted> inserted_;
    PrintedRefinement result_;
};

bool passes_decimation(const Scene& scene, const PrintedRules& rules, const Star& star) {
    const TriMesh& mesh = scene.active().mesh();
    const auto passes = [&](HalfEdgeId h) {
        const EdgeId e = mesh.edge(h);
        return std::visit(
                   [&](const auto& trigger) {
                       return trigger.passes_decimation(scene.active(), e);
                   },
                   rules.curvature) &&
               mesh.length(e) < rules.l_max;
    };
    bool all_pass = true;
    mesh.for_each_sheet(star, [&](const Star& sheet) {
        all_pass = all_pass && passes(sheet.bm) && passes(sheet.mc) &&
                   passes(TriMesh::prev(sheet.mc)) &&
                   (sheet.on_boundary() || passes(TriMesh::prev(sheet.mb)));
    });
    return all_pass;
}

}  // namespace

PrintedRefinement refine_as_printed(Scene& scene, const PrintedRules& rules) {
    return PrintedRefiner(scene, rules).run();
}

std::uint64_t decimate_as_printed(Scene& scene, const PrintedRules& rules) {
    const TriMesh& mesh = scene.mesh();
    std::map<int, std::vector<VertexId>, std::greater<>> by_level;
    for (const VertexId v : scene.active().vertices()) {
        if (exists(v) && !mesh.is_base(v)) by_level[mesh.level(v)].push_back(v);
    }
    std::uint64_t removed = 0;
    for (const auto& [level, vertices] : by_level) {
        for (const VertexId m : vertices) {
            const std::optional<Star> star = mesh.removable(m);
            if (!star || !passes_decimation(scene, rules, *star)) continue;
            scene.active().unsplit(*star);
            ++removed;
        }
    }
    return removed;
}

}  // namespace pectin::study
