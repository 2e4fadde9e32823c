#include "mesh/join_seams.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/disjoint_sets.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

class SeamJoiner {
  public:
    SeamJoiner(std::span<const Vec3> positions, std::span<HalfEdge> half_edges)
        : positions_(positions), half_edges_(half_edges) {}

    std::optional<JoinedSeams> join() {
        find_boundary();
        if (!find_equal_positions()) return std::nullopt;
        exclude_short_faces();
        join_coinciding();
        if (result_.half_edges.empty()) return std::nullopt;
        use_representatives();
        match();
        count_seams();
        return std::move(result_);
    }

  private:
    using Ends = std::pair<std::uint32_t, std::uint32_t>;
    struct Edge {
        Ends ends;  // in ascending order
        HalfEdgeId half_edge = HalfEdgeId{0};
        bool is_boundary = true;
        bool operator<(const Edge& o) const {
            return std::tie(ends, half_edge) < std::tie(o.ends, o.half_edge);
        }
    };

    std::uint32_t origin(HalfEdgeId h) const { return index(half_edges_[index(h)].origin); }
    std::uint32_t target(HalfEdgeId h) const { return origin(TriMesh::next(h)); }

    void find_boundary() {
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (!exists(half_edges_[h].twin)) boundary_.push_back(HalfEdgeId{h});
        }
    }

    // Assigns a site to the vertices that coincide with an end of a boundary edge: the lowest
    // vertex at the same position. Returns whether any two share a site. -0 equals 0.
    bool find_equal_positions() {
        const std::vector<std::uint32_t> vertices = vertices_at_boundary();
        site_.assign(positions_.size(), kNone);
        bool any_equal = false;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const bool is_equal = i > 0 && positions_[vertices[i]] == positions_[vertices[i - 1]];
            site_[vertices[i]] = is_equal ? site_[vertices[i - 1]] : vertices[i];
            any_equal = any_equal || is_equal;
        }
        return any_equal;
    }
    // The ends of boundary edges and the vertices that coincide with one, by position, then by
    // index.
    std::vector<std::uint32_t> vertices_at_boundary() const {
        std::vector<bool> is_end(positions_.size(), false);
        for (const HalfEdgeId h : boundary_) is_end[origin(h)] = is_end[target(h)] = true;
        std::vector<std::uint32_t> vertices, others;
        for (std::uint32_t v = 0; v < positions_.size(); ++v) {
            (is_end[v] ? vertices : others).push_back(v);
        }
        const auto lies_before = [&](std::uint32_t v, std::uint32_t w) {
            const Vec3 &p = positions_[v], &q = positions_[w];
            return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
        };
        std::stable_sort(vertices.begin(), vertices.end(), lies_before);
        std::erase_if(others, [&](std::uint32_t v) {
            return !std::binary_search(vertices.begin(), vertices.end(), v, lies_before);
        });
        if (others.empty()) return vertices;
        vertices.insert(vertices.end(), others.begin(), others.end());
        std::sort(vertices.begin(), vertices.end());
        std::stable_sort(vertices.begin(), vertices.end(), lies_before);
        return vertices;
    }

    // If two corners of a face were joined, it would lose an edge. So the vertices of a face with
    // two corners at one site are not joined; those of other faces at the site are.
    void exclude_short_faces() {
        std::vector<std::uint32_t> excluded;
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            const std::uint32_t from = origin(HalfEdgeId{h}), to = target(HalfEdgeId{h});
            if (site_[from] != kNone && site_[from] == site_[to]) {
                excluded.insert(excluded.end(), {from, to});
            }
        }
        for (const std::uint32_t v : excluded) site_[v] = kNone;
    }

    // visit(span of edges): called for each group of edges with the same ends.
    template <typename Visit>
    static void for_each_run(std::span<const Edge> edges, Visit visit) {
        for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
            while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
            visit(edges.subspan(begin, end - begin));
        }
    }

    // Inner edges that coincide with boundary edges lose their twins, as along a cut.
    void join_coinciding() {
        const std::vector<Edge> edges = edges_between_sites();
        for_each_run(edges, [&](std::span<const Edge> run) {
            const Ends first = ends_by_site(run.front());
            const bool is_joined = std::any_of(
                run.begin(), run.end(), [&](const Edge& e) { return ends_by_site(e) != first; });
            const bool has_boundary =
                std::any_of(run.begin(), run.end(), [](const Edge& e) { return e.is_boundary; });
            if (!is_joined || !has_boundary) return;
            for (const Edge& e : run) {
                const Ends ends = ends_by_site(e);
                vertices_.join(first.first, ends.first);
                vertices_.join(first.second, ends.second);
                result_.half_edges.push_back(e.half_edge);
                if (e.is_boundary) continue;
                half_edges_[index(e.half_edge)].twin = pectin::kNone<HalfEdgeId>;
                boundary_.push_back(e.half_edge);
            }
            ++result_.edges;
        });
        std::sort(result_.half_edges.begin(), result_.half_edges.end());
    }
    std::vector<Edge> edges_between_sites() const {
        std::vector<Edge> edges;
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            const HalfEdgeId id{h};
            const std::uint32_t from = site_[origin(id)], to = site_[target(id)];
            if (from == kNone || to == kNone) continue;
            edges.push_back({std::minmax(from, to), id, !exists(half_edges_[h].twin)});
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    }
    // The edge's vertices in the input, in the order of their sites.
    Ends ends_by_site(const Edge& e) const {
        const std::uint32_t v = origin(e.half_edge), w = target(e.half_edge);
        return site_[v] == e.ends.first ? Ends{v, w} : Ends{w, v};
    }

    void use_representatives() {
        result_.corner_vertices.reserve(half_edges_.size());
        for (HalfEdge& h : half_edges_) {
            result_.corner_vertices.push_back(h.origin);
            h.origin = representative(h.origin);
        }
        result_.representatives.reserve(positions_.size());
        for (std::uint32_t v = 0; v < positions_.size(); ++v) {
            result_.representatives.push_back(representative(VertexId{v}));
        }
    }
    VertexId representative(VertexId v) {
        return VertexId{static_cast<std::uint32_t>(vertices_.find(index(v)))};
    }

    // Two boundary half-edges that run in opposite directions become twins; others that share both
    // ends become siblings.
    void match() {
        std::vector<Edge> edges;
        for (const HalfEdgeId h : boundary_) {
            edges.push_back({.ends = std::minmax(origin(h), target(h)), .half_edge = h});
        }
        std::sort(edges.begin(), edges.end());
        for_each_run(edges, [&](std::span<const Edge> run) {
            if (run.size() == 1) return;
            const HalfEdgeId g = run[0].half_edge, h = run[1].half_edge;
            if (run.size() == 2 && origin(g) != origin(h)) {
                half_edges_[index(g)].twin = h;
                half_edges_[index(h)].twin = g;
                return;
            }
            for (const Edge& e : run) result_.cut.push_back(e.half_edge);
            result_.cut_ends.push_back(result_.cut.size());
        });
    }

    void count_seams() {
        DisjointSets runs(positions_.size());
        for (const HalfEdgeId h : result_.half_edges) runs.join(origin(h), target(h));
        std::vector<std::size_t> roots;
        for (const HalfEdgeId h : result_.half_edges) roots.push_back(runs.find(origin(h)));
        std::sort(roots.begin(), roots.end());
        result_.seams =
            static_cast<std::uint32_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
    }

    std::span<const Vec3> positions_;
    std::span<HalfEdge> half_edges_;
    std::vector<HalfEdgeId> boundary_;
    std::vector<std::uint32_t> site_;  // n_vertices; none away from boundaries
    DisjointSets vertices_{positions_.size()};
    JoinedSeams result_;
};

}  // namespace

std::optional<JoinedSeams> join_seams(std::span<const Vec3> positions,
                                      std::span<HalfEdge> half_edges) {
    return SeamJoiner(positions, half_edges).join();
}

}  // namespace pectin
