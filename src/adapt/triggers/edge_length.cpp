#include "adapt/triggers/edge_length.h"

#include <algorithm>
#include <utility>

#include "adapt/sheets.h"
#include "embedding/embedding.h"

namespace pectin {
namespace {

// Slack for lengths whose squares are summed in another order.
constexpr double kRoundedDown = 1.0 - 1e-6;

// The fraction of L_max by which a corner may be farther from the middle of a zone than its face,
// and by which the steps may bend a face.
constexpr double kNoticed = 0.5;

bool meets(const std::array<Vec3, 3>& corners, const Box& zone) {
    return triangle_meets_box(corners[0], corners[1], corners[2], zone);
}

// Whether the edge of h is a boundary, separates two parts, or is a seam between faces with the
// same normals. A crease is none: what bends it in the plane of one face tilts the other.
bool is_line(const ActiveSet& active, HalfEdgeId h) {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId twin = mesh.twin(h);
    if (!exists(twin)) return true;
    if (mesh.part_index(TriMesh::face(h)) != mesh.part_index(TriMesh::face(twin))) return true;
    if (mesh.is_smooth(mesh.edge(h))) return false;
    const auto normal = [&](HalfEdgeId at) { return active.rest_normal(mesh.wedge(at)); };
    return normal(h) == normal(TriMesh::next(twin)) && normal(TriMesh::next(h)) == normal(twin);
}

// How much farther one corner moves than another, along the normal of the face.
double bend(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& after) {
    const Vec3 normal = glm::cross(before[1] - before[0], before[2] - before[0]);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return 0.0;
    const double a = glm::dot(normal, after[0] - before[0]),
                 b = glm::dot(normal, after[1] - before[1]),
                 c = glm::dot(normal, after[2] - before[2]);
    return (std::max({a, b, c}) - std::min({a, b, c})) / length;
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
    return is_too_coarse(
        active,
        {.a = mesh.origin(TriMesh::prev(h)), .b = mesh.origin(h), .c = mesh.target(h), .side = h});
}

// Whether L_max holds before all steps, since the curvature trigger may not notice what they bend.
bool EdgeLength::may_hide_a_step(const ActiveSet& active, const Face& face) const {
    return !exists(face.side) || hides_bends(active, face.side) ||
           hides_bends(active, TriMesh::next(face.side)) ||
           hides_bends(active, TriMesh::prev(face.side));
}

// Whether the edge of h may bend without the curvature trigger noticing it.
bool EdgeLength::hides_bends(const ActiveSet& active, HalfEdgeId h) const {
    if (is_line(active, h)) return true;
    const TriMesh& mesh = active.mesh();
    const Vec3f difference =
        active.rest_normal(mesh.wedge(h)) - active.rest_normal(mesh.wedge(TriMesh::next(h)));
    return static_cast<double>(glm::dot(difference, difference)) > steps_.largest_rest_difference;
}

bool EdgeLength::is_too_coarse(const ActiveSet& active, const Face& face) const {
    const TriMesh& mesh = active.mesh();
    if (!steps_.are_only_sampled) {
        if (has_long_side(mesh.position(face.a), mesh.position(face.b), mesh.position(face.c)) &&
            rests_in_zone(active, face))
            return true;
        return steps_.embedding != nullptr && is_long_before_a_step(face);
    }
    if (has_long_side(corners_before(0, face)) && rests_in_zone(active, face)) return true;
    if (!is_long_before_a_step(face)) return false;
    return may_hide_a_step(active, face) || may_miss_a_step(face);
}

bool EdgeLength::rests_in_zone(const ActiveSet& active, const Face& face) const {
    const Vec3 &a = active.rest_position(face.a), &b = active.rest_position(face.b),
               &c = active.rest_position(face.c);
    return std::ranges::any_of(zones_,
                               [&](const Box& zone) { return triangle_meets_box(a, b, c, zone); });
}

EdgeLength::Corners EdgeLength::corners_before(std::size_t step, const Face& face) const {
    const Embedding& embedding = *steps_.embedding;
    return {embedding.position_before(step, face.a), embedding.position_before(step, face.b),
            embedding.position_before(step, face.c)};
}

bool EdgeLength::is_long_before_a_step(const Face& face) const {
    const std::size_t count = steps_.embedding->step_count();
    for (std::size_t step = 1; step < count; ++step) {
        const Corners corners = corners_before(step, face);
        if (!has_long_side(corners)) continue;
        for (const Box& zone : steps_.embedding->zones(step)) {
            if (meets(corners, zone)) return true;
        }
    }
    return false;
}

bool EdgeLength::may_miss_a_step(const Face& face) const {
    double bent = 0.0;  // how far the steps move corners out of the plane of the face
    const std::size_t count = steps_.embedding->step_count();
    Corners before = corners_before(1, face);
    for (std::size_t step = 1; step < count; ++step) {
        const Corners after = corners_before(step + 1, face);
        if (has_long_side(before)) {
            for (const Box& zone : steps_.embedding->zones(step)) {
                if (shows_at_no_corner(before, zone)) return true;
            }
            bent += bend(before, after);
            if (bent > kNoticed * l_max_) return true;
        }
        before = after;
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
    const double nearer = nearest - kNoticed * l_max_;
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
    const auto passes = [&](VertexId a, VertexId b, VertexId c) {
        return !is_too_coarse(active, {.a = a, .b = b, .c = c});
    };
    return is_on() && !all_sheets(active.mesh(), star, [&](const Star& sheet) {
               return passes(sheet.a, sheet.b, sheet.c) &&
                      (sheet.on_boundary() || passes(sheet.d, sheet.c, sheet.b));
           });
}

}  // namespace pectin
