#include "io/polygon_outline.h"

#include <algorithm>
#include <utility>

#include "mesh/triangulate.h"

namespace pectin {

std::span<const HalfEdgeId> PolygonOutline::find(FaceId first, FaceId last) {
    collect_border(first, last);
    if (border_.size() != index(last) - index(first) + 3 || !chain_border()) return {};
    // Triangles need not begin at the polygon's first corner, but seldom do so far behind it.
    constexpr std::size_t kMostTurns = 16;
    for (std::size_t turn = 0; turn < std::min(kMostTurns, outline_.size()); ++turn) {
        if (becomes(first, last)) return outline_;
        std::rotate(outline_.begin(), outline_.end() - 1, outline_.end());
    }
    return {};
}

// Half-edges that have no opposite among the faces. Twins cannot tell: where the polygon occurs
// twice in the mesh they have been cut.
void PolygonOutline::collect_border(FaceId first, FaceId last) {
    border_.clear();
    outline_.clear();
    std::vector<HalfEdgeId>& all = outline_;
    for (std::uint32_t h = 3 * index(first); h < 3 * index(last) + 3; ++h) {
        all.push_back(HalfEdgeId{h});
    }
    const auto ends = [&](HalfEdgeId h) { return std::minmax({mesh_.origin(h), mesh_.target(h)}); };
    std::sort(all.begin(), all.end(), [&](HalfEdgeId a, HalfEdgeId b) {
        return std::pair(ends(a), a) < std::pair(ends(b), b);
    });
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
        while (end < all.size() && ends(all[end]) == ends(all[i])) ++end;
        const bool inside = end - i == 2 && mesh_.origin(all[i]) == mesh_.target(all[i + 1]);
        if (!inside)
            border_.insert(border_.end(), all.begin() + static_cast<std::ptrdiff_t>(i),
                           all.begin() + static_cast<std::ptrdiff_t>(end));
    }
    std::sort(border_.begin(), border_.end(), [&](HalfEdgeId a, HalfEdgeId b) {
        return std::pair(mesh_.origin(a), a) < std::pair(mesh_.origin(b), b);
    });
}

// Whether the border is one ring; then it is put in order, from the first face's first corner if
// that is on it.
bool PolygonOutline::chain_border() {
    outline_.assign(1, *std::min_element(border_.begin(), border_.end()));
    while (outline_.size() <= border_.size()) {
        const VertexId target = mesh_.target(outline_.back());
        if (target == mesh_.origin(outline_.front())) break;
        const auto next = std::lower_bound(
            border_.begin(), border_.end(), target,
            [&](HalfEdgeId h, VertexId vertex) { return mesh_.origin(h) < vertex; });
        if (next == border_.end() || mesh_.origin(*next) != target) return false;
        outline_.push_back(*next);
    }
    return outline_.size() == border_.size();
}

// Whether the outline, as a polygon, is cut into these faces with these wedges.
bool PolygonOutline::becomes(FaceId first, FaceId last) {
    corners_.clear();
    triangles_.clear();
    for (HalfEdgeId h : outline_) corners_.push_back(mesh_.position(mesh_.origin(h)));
    triangulate(corners_, triangles_);
    if (triangles_.size() != index(last) - index(first) + 1) return false;
    std::uint32_t h = 3 * index(first);
    for (const auto& triangle : triangles_) {
        for (std::uint32_t corner : triangle) {
            if (mesh_.wedge(outline_[corner]) != mesh_.wedge(HalfEdgeId{h++})) return false;
        }
    }
    return true;
}

}  // namespace pectin
