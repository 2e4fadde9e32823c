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

bool meets(const std::array<Vec3, 3>& corners, const Box& zone) {
    return triangle_meets_box(corners[0], corners[1], corners[2], zone);
}

}  // namespace

EdgeLength::EdgeLength(double l_max, std::vector<Box> zones, const Steps& steps,
                       const SplitOrder& order, const Floor& floor)
    : l_max_(l_max), zones_(std::move(zones)), steps_(steps), order_(order), floor_(floor) {}

double EdgeLength::fast_path_bound() const {
    if (!is_on()) return kOff;
    return steps_.embedding ? -1.0 : kRoundedDown * (l_max_ * l_max_);
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
    const HalfEdgeId next = TriMesh::next(h), prev = TriMesh::prev(h);
    return is_too_coarse(active, {.a = mesh.origin(prev),
                                  .b = mesh.origin(h),
                                  .c = mesh.target(h),
                                  .is_at_boundary = is_at_boundary(mesh, {h, next, prev})});
}

bool EdgeLength::is_too_coarse(const ActiveSet& active, const Face& face) const {
    if (steps_.are_only_sampled) return may_miss_a_step(face);
    const TriMesh& mesh = active.mesh();
    const Corners now{mesh.position(face.a), mesh.position(face.b), mesh.position(face.c)};
    const Corners rest{active.rest_position(face.a), active.rest_position(face.b),
                       active.rest_position(face.c)};
    const auto meets_face = [&](const Box& zone) { return meets(rest, zone); };
    return (has_long_side(now) && std::ranges::any_of(zones_, meets_face)) || may_miss_a_step(face);
}

bool EdgeLength::is_at_boundary(const TriMesh& mesh,
                                std::initializer_list<HalfEdgeId> sides) const {
    return steps_.are_only_sampled &&
           std::ranges::any_of(sides, [&](HalfEdgeId h) { return !exists(mesh.twin(h)); });
}

bool EdgeLength::has_long_side(const Corners& corners) const {
    const auto is_long = [&](const Vec3& p, const Vec3& q) {
        return squared_distance_of(p, q) > l_max_ * l_max_;
    };
    return is_long(corners[1], corners[2]) || is_long(corners[2], corners[0]) ||
           is_long(corners[0], corners[1]);
}

bool EdgeLength::may_miss_a_step(const Face& face) const {
    if (!steps_.embedding) return false;
    const Embedding& embedding = *steps_.embedding;
    for (std::size_t step = steps_.are_only_sampled ? 0 : 1; step < embedding.step_count();
         ++step) {
        const Corners corners{embedding.position_before(step, face.a),
                              embedding.position_before(step, face.b),
                              embedding.position_before(step, face.c)};
        if (!has_long_side(corners)) continue;
        const bool may_show = steps_.are_only_sampled && step > 0 && !face.is_at_boundary;
        for (const Box& zone : embedding.zones(step)) {
            if (may_show ? shows_at_no_corner(corners, zone) : meets(corners, zone)) return true;
        }
    }
    return false;
}

// Whether the face comes nearer to the middle of the zone than its corners, by more than half of
// L_max. A face without a corner in the zone only has to meet it.
bool EdgeLength::shows_at_no_corner(const Corners& corners, const Box& zone) const {
    const Vec3 middle = zone.centre();
    double nearest = kOff;
    for (const Vec3& corner : corners) {
        if (!zone.contains(corner)) continue;
        const Vec3 from_middle = glm::abs(corner - middle);
        nearest = std::min(nearest, std::max({from_middle.x, from_middle.y, from_middle.z}));
    }
    if (nearest == kOff) return meets(corners, zone);
    const double nearer = nearest - 0.5 * l_max_;
    return nearer > 0.0 &&
           meets(corners, {.min = middle - Vec3{nearer}, .max = middle + Vec3{nearer}});
}

//          a                  a
//         /|\                / \         Undoing the split of m restores the faces bca and, away
//        / | \              /   \        from a boundary, cbd.
//       b--m--c    --->    b-----c
//        \ | /              \   /
//         \|/                \ /
//          d                  d
bool EdgeLength::restored_face_is_too_coarse(const ActiveSet& active, const Star& star) const {
    const TriMesh& mesh = active.mesh();
    const auto passes = [&](const Star& sheet) {
        const bool bc_is_boundary = sheet.on_boundary();
        const HalfEdgeId ab = TriMesh::prev(sheet.bm), ca = TriMesh::next(sheet.mc);
        const Face bca{.a = sheet.a,
                       .b = sheet.b,
                       .c = sheet.c,
                       .is_at_boundary = bc_is_boundary || is_at_boundary(mesh, {ab, ca})};
        if (is_too_coarse(active, bca)) return false;
        if (bc_is_boundary) return true;
        const HalfEdgeId bd = TriMesh::next(sheet.mb), dc = TriMesh::prev(sheet.cm);
        return !is_too_coarse(active, {.a = sheet.d,
                                       .b = sheet.c,
                                       .c = sheet.b,
                                       .is_at_boundary = is_at_boundary(mesh, {bd, dc})});
    };
    return is_on() && !all_sheets(mesh, star, passes);
}

}  // namespace pectin
