#include "adapt/triggers/edge_length.h"

#include <algorithm>
#include <utility>

#include "adapt/sheets.h"
#include "embedding/embedding.h"

namespace pectin {
namespace {

// Slack for lengths whose squares are summed in another order.
constexpr double kRoundedDown = 1.0 - 1e-6;

double squared_distance_of(const Vec3& p, const Vec3& q) {
    const Vec3 along = q - p;
    return glm::dot(along, along);
}

}  // namespace

EdgeLength::EdgeLength(double l_max, std::vector<Box> zones, const Embedding* between,
                       const SplitOrder& order, const Floor& floor)
    : l_max_(l_max), zones_(std::move(zones)), between_(between), order_(order), floor_(floor) {}

double EdgeLength::fast_path_bound() const {
    if (!is_on()) return kOff;
    return between_ ? -1.0 : kRoundedDown * (l_max_ * l_max_);
}

SplitNeed EdgeLength::need(const ActiveSet& active, EdgeId e) const {
    SplitNeed need = SplitNeed::none;
    if (!is_on()) return need;
    const TriMesh& mesh = active.mesh();
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        if (need == SplitNeed::itself) return;
        const HalfEdgeId first = needed_split(active, h);
        if (first == h) {
            need = SplitNeed::itself;
        } else if (exists(first) && !is_long(mesh, mesh.edge(first))) {
            need = SplitNeed::neighbour;
        }
    });
    return need;
}

HalfEdgeId EdgeLength::needed_split(const ActiveSet& active, HalfEdgeId h) const {
    if (!is_on() || !is_too_coarse(active, h)) return kNone<HalfEdgeId>;
    return order_.first_edge(active, h, floor_);
}

bool EdgeLength::is_too_coarse(const ActiveSet& active, HalfEdgeId h) const {
    const TriMesh& mesh = active.mesh();
    return is_too_coarse(active, mesh.origin(TriMesh::prev(h)), mesh.origin(h), mesh.target(h));
}

bool EdgeLength::is_too_coarse(const ActiveSet& active, VertexId a, VertexId b, VertexId c) const {
    const TriMesh& mesh = active.mesh();
    const auto is_long = [&](VertexId p, VertexId q) {
        return squared_distance_of(mesh.position(p), mesh.position(q)) > l_max_ * l_max_;
    };
    const auto meets = [&](const Box& zone) {
        return triangle_meets_box(active.rest_position(a), active.rest_position(b),
                                  active.rest_position(c), zone);
    };
    if ((is_long(b, c) || is_long(c, a) || is_long(a, b)) && std::ranges::any_of(zones_, meets)) {
        return true;
    }
    return between_ && between_->is_long_between_steps(a, b, c, l_max_);
}

//          a                  a
//         /|\                / \         Undoing the split of m restores the faces bca and, away
//        / | \              /   \        from a boundary, cbd.
//       b--m--c    --->    b-----c
//        \ | /              \   /
//         \|/                \ /
//          d                  d
bool EdgeLength::restored_face_is_too_coarse(const ActiveSet& active, const Star& star) const {
    return is_on() && !all_sheets(active.mesh(), star, [&](const Star& sheet) {
               return !is_too_coarse(active, sheet.a, sheet.b, sheet.c) &&
                      (sheet.on_boundary() || !is_too_coarse(active, sheet.d, sheet.c, sheet.b));
           });
}

}  // namespace pectin
