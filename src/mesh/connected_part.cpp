#include "mesh/connected_part.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/parallel.h"
#include "mesh/concurrent_sets.h"

namespace pectin {
namespace {

// An edge that passes through a zone and whose ends are not inside one.
struct CrossingEdge {
    VertexId low, high;
    std::uint32_t face;  // index into the border faces
};

// A search for the connected part. Its sets consist of vertices inside a zone and of border faces,
// which have an edge without such an end. Connected faces have their elements in one set.
class Search {
  public:
    Search(const TriMesh& mesh, std::span<const FaceId> faces, std::span<const Box> zones)
        : mesh_(mesh), faces_(faces), zones_(zones), is_border_(faces.size()) {
        const auto collect_border = [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) is_border_[i] = has_outer_edge(faces_[i]);
        };
        for_pieces(0, count(), collect_border);
        for (std::uint32_t i = 0; i < count(); ++i) {
            if (is_border_[i] != 0) border_.push_back(i);
        }
        sets_ = ConcurrentSets(mesh.vertex_slots() + border_.size());
        join_inside();
        join_border();
    }

    ConnectedPart from(std::span<const FaceId> seeds) {
        std::vector<std::uint32_t> reached;  // sets
        for (const FaceId seed : seeds) {
            const auto at = std::lower_bound(faces_.begin(), faces_.end(), seed);
            if (at == faces_.end() || *at != seed) continue;
            reached.push_back(set_of(static_cast<std::uint32_t>(at - faces_.begin())));
        }
        std::ranges::sort(reached);
        std::vector<std::uint8_t> is_reached(faces_.size());
        for_pieces(0, count(), [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                is_reached[i] = std::ranges::binary_search(reached, set_of(i)) ? 1 : 0;
            }
        });
        const auto size = std::ranges::count(is_reached, 1);
        ConnectedPart part;
        part.faces.reserve(static_cast<std::size_t>(size));
        part.others.reserve(faces_.size() - static_cast<std::size_t>(size));
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            (is_reached[i] != 0 ? part.faces : part.others).push_back(faces_[i]);
        }
        return part;
    }

  private:
    std::uint32_t count() const { return static_cast<std::uint32_t>(faces_.size()); }

    bool is_inside(VertexId v) const {
        return std::any_of(zones_.begin(), zones_.end(), [&](const Box& zone) {
            return zone.contains_strictly(mesh_.position(v));
        });
    }
    bool crosses_zone(VertexId v, VertexId w) const {
        const Vec3 &a = mesh_.position(v), &b = mesh_.position(w);
        return std::any_of(zones_.begin(), zones_.end(),
                           [&](const Box& zone) { return triangle_meets_box(a, b, b, zone); });
    }
    std::array<VertexId, 3> corners(FaceId f) const {
        return {mesh_.origin(TriMesh::half_edge(f, 0)), mesh_.origin(TriMesh::half_edge(f, 1)),
                mesh_.origin(TriMesh::half_edge(f, 2))};
    }
    std::uint8_t has_outer_edge(FaceId f) const {
        const auto all = corners(f);
        return std::ranges::count_if(all, [&](VertexId v) { return is_inside(v); }) < 2 ? 1 : 0;
    }
    std::optional<VertexId> inner_corner(FaceId f) const {
        for (const VertexId v : corners(f)) {
            if (is_inside(v)) return v;
        }
        return std::nullopt;
    }

    // Joins the vertices inside that have a common face.
    void join_inside() {
        for_pieces(0, count(), [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                for (const VertexId v : corners(faces_[i])) sets_.make(index(v));
            }
        });
        for_pieces(0, count(), [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                if (is_border_[i] != 0) continue;
                const auto [a, b, c] = corners(faces_[i]);
                const bool a_inside = is_inside(a), b_inside = is_inside(b);
                if (a_inside && b_inside) sets_.join(index(a), index(b));
                if (!is_inside(c)) continue;
                if (a_inside || b_inside) sets_.join(index(a_inside ? a : b), index(c));
            }
        });
    }

    // Joins border faces with their vertex inside, and with each other across edges.
    void join_border() {
        std::vector<CrossingEdge> edges;
        for (std::uint32_t k = 0; k < border_.size(); ++k) {
            const FaceId f = faces_[border_[k]];
            sets_.make(node_of_border(k));
            if (const auto v = inner_corner(f)) sets_.join(node_of_border(k), index(*v));
            const auto all = corners(f);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const VertexId v = all[corner], w = all[(corner + 1) % 3];
                if (is_inside(v) || is_inside(w) || !crosses_zone(v, w)) continue;
                edges.push_back({std::min(v, w), std::max(v, w), k});
            }
        }
        std::ranges::sort(edges, [](const CrossingEdge& x, const CrossingEdge& y) {
            return std::tie(x.low, x.high, x.face) < std::tie(y.low, y.high, y.face);
        });
        for (std::size_t i = 1; i < edges.size(); ++i) {
            if (edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high)
                sets_.join(node_of_border(edges[i].face), node_of_border(edges[i - 1].face));
        }
    }

    std::uint32_t node_of_border(std::uint32_t k) const { return mesh_.vertex_slots() + k; }

    // The set of a face's elements.
    std::uint32_t set_of(std::uint32_t face) {
        if (is_border_[face] == 0) return sets_.find(index(*inner_corner(faces_[face])));
        const auto k = std::ranges::lower_bound(border_, face) - border_.begin();
        return sets_.find(node_of_border(static_cast<std::uint32_t>(k)));
    }

    const TriMesh& mesh_;
    std::span<const FaceId> faces_;
    std::span<const Box> zones_;
    std::vector<std::uint8_t> is_border_;  // 0 or 1 for each face
    std::vector<std::uint32_t> border_;    // indices of faces, ascending
    ConcurrentSets sets_;                  // vertices, then border faces
};

}  // namespace

ConnectedPart connected_part(const TriMesh& mesh, std::span<const FaceId> faces,
                             std::span<const FaceId> seeds, std::span<const Box> zones) {
    return Search(mesh, faces, zones).from(seeds);
}

}  // namespace pectin
