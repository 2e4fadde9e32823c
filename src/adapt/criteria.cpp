#include "adapt/criteria.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "adapt/split_order.h"
#include "embedding/embedding.h"

namespace pectin {
namespace {

// Rest normals more than 120 degrees apart (n1.n2 < -1/2) are a spike or a fold that was there
// before: refining cannot bring them together. A drag may open it; then it counts again, so that
// the mesh after the drag, for which rest is the present, needs nothing that the drag did not see.
constexpr double kOpposedDivergence = 1.5;

double one_minus_cosine(double degrees) {
    return degrees >= 180.0 ? kOff : 1.0 - std::cos(degrees * std::numbers::pi / 180.0);
}

double square(double x) { return x * x; }

// Room for the rounding of a bound that is compared in float, or of a sum in another order.
constexpr double kRoundedDown = 1.0 - 1e-6;

bool is_defined(const Vec3f& n) { return n != Vec3f{0.0f}; }

// 1 - n1.n2 of unit normals.
double normal_divergence(const Vec3f& n1, const Vec3f& n2) {
    const Vec3f difference = n1 - n2;
    return 0.5 * static_cast<double>(glm::dot(difference, difference));
}

// The corners of the two ends of an edge on one side of it.
struct SideEnds {
    WedgeId first, second;
};

SideEnds side_of(const TriMesh& mesh, HalfEdgeId h) {
    return {mesh.wedge(h), mesh.wedge(TriMesh::next(h))};
}

// 1 - cos of the angle between the side's normals; 0 where the side is not tested. Whether it is
// tested is only looked up where the answer is `enough` or more.
double side_divergence(const ActiveSet& active, SideEnds side, double enough) {
    const Vec3f n1 = active.mesh().normal(side.first), n2 = active.mesh().normal(side.second);
    const double divergence = normal_divergence(n1, n2);
    if (divergence < enough) return divergence;
    if (!is_defined(n1) || !is_defined(n2)) return 0.0;
    if (divergence <= kOpposedDivergence) return divergence;
    const bool opposed_at_rest =
        normal_divergence(active.rest_normal(side.first), active.rest_normal(side.second)) >
        kOpposedDivergence;
    return opposed_at_rest ? 0.0 : divergence;
}

bool has_deformed_end(const TriMesh& mesh, HalfEdgeId h) {
    return mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h));
}

// Adds the mirror images of the zones. A drag acts on both sides already, but its second lattice is
// the image of the first only up to rounding, and a face may touch the border exactly.
void add_images(std::vector<Box>& zones, const MirrorPlane& plane) {
    const std::size_t count = zones.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Box image = plane.image(zones[i]);
        if (std::find(zones.begin(), zones.end(), image) == zones.end()) zones.push_back(image);
    }
}

}  // namespace

Criteria::Criteria(const AdaptLimits& limits, const std::optional<Box>& zone,
                   const std::optional<Box>& scope)
    : Criteria(limits, zone ? std::vector{*zone} : std::vector<Box>{},
               scope ? std::optional(std::vector{*scope}) : std::nullopt, nullptr) {}

Criteria::Criteria(const AdaptLimits& limits, std::vector<Box> zones,
                   std::optional<std::vector<Box>> scope, const Embedding* between)
    : limits_(limits),
      zones_(std::move(zones)),
      scope_(std::move(scope)),
      between_(between),
      min_squared_length_(square(2.0 * limits.floor)),
      refine_divergence_(one_minus_cosine(limits.theta_max)),
      decimate_divergence_(one_minus_cosine(limits.theta_min)),
      fast_squared_difference_(static_cast<float>(2.0 * kRoundedDown * refine_divergence_)) {
    if (limits_.symmetry) {
        add_images(zones_, *limits_.symmetry);
        if (scope_) add_images(*scope_, *limits_.symmetry);
    }
    if (!limits_length()) return;
    fast_squared_length_ = between_ ? -1.0 : kRoundedDown * square(limits_.l_max);
}

double Criteria::divergence(const ActiveSet& active, EdgeId e, double enough) {
    const TriMesh& mesh = active.mesh();
    const SideEnds left = side_of(mesh, mesh.half_edge(e));
    double greatest = -1.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const SideEnds side = side_of(mesh, h);
        const bool smooth = side.first == left.second && side.second == left.first;
        if (!smooth) greatest = std::max(greatest, side_divergence(active, side, enough));
    });
    return greatest;
}

double Criteria::full_divergence(const TriMesh& mesh, EdgeId e) {
    double greatest = 0.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const SideEnds side = side_of(mesh, h);
        const Vec3f n1 = mesh.normal(side.first), n2 = mesh.normal(side.second);
        if (is_defined(n1) && is_defined(n2))
            greatest = std::max(greatest, normal_divergence(n1, n2));
    });
    return greatest;
}

bool Criteria::diverges(const TriMesh& mesh, EdgeId e) const {
    return has_deformed_end(mesh, mesh.half_edge(e)) &&
           full_divergence(mesh, e) > refine_divergence_;
}

bool Criteria::needs_refinement(const ActiveSet& active, EdgeId e) const {
    if (bends_too_far(active, e)) return true;
    if (!limits_length()) return false;
    bool any = false;
    active.mesh().for_each_side(e, [&](HalfEdgeId h) {
        any = any || (is_too_coarse(active, h) && edge_to_split(active, h) == h);
    });
    return any;
}

bool Criteria::bends_too_far(const ActiveSet& active, EdgeId e) const {
    return refine_divergence_ < kOff &&
           has_deformed_end(active.mesh(), active.mesh().half_edge(e)) &&
           divergence(active, e, refine_divergence_) > refine_divergence_;
}

bool Criteria::is_too_coarse(const ActiveSet& active, HalfEdgeId h) const {
    if (!limits_length()) return false;
    const TriMesh& mesh = active.mesh();
    const bool is_long = has_long_edge(mesh, h);
    if (!is_long && !between_) return false;
    const VertexId a = mesh.origin(TriMesh::prev(h)), b = mesh.origin(h), c = mesh.target(h);
    return (is_long && meets_zone(active, a, b, c)) ||
           (between_ && between_->is_long_between_steps(a, b, c, limits_.l_max));
}

bool Criteria::has_long_edge(const TriMesh& mesh, HalfEdgeId h) const {
    const Vec3& a = mesh.position(mesh.origin(TriMesh::prev(h)));
    const Vec3& b = mesh.position(mesh.origin(h));
    const Vec3& c = mesh.position(mesh.target(h));
    const double most = square(limits_.l_max);
    return glm::dot(c - b, c - b) > most || glm::dot(a - c, a - c) > most ||
           glm::dot(b - a, b - a) > most;
}

HalfEdgeId Criteria::edge_to_split(const ActiveSet& active, HalfEdgeId h) const {
    const TriMesh& mesh = active.mesh();
    const SplitOrder order(limits_);
    const auto rest_edge = [&](HalfEdgeId side) {
        const EdgeId e = mesh.edge(side);
        return order.rest_edge(active, e, static_cast<double>(active.uncached_rest_length(e)));
    };
    // From the same corner, whichever half-edge is asked about: of equally long edges without
    // symmetry the first one counts.
    HalfEdgeId first = TriMesh::half_edge(TriMesh::face(h), 0);
    RestEdge longest = rest_edge(first);
    bool is_below = is_below_floor(mesh, mesh.edge(first));
    for (int corner = 1; corner < 3; ++corner) {
        const HalfEdgeId side = TriMesh::half_edge(TriMesh::face(h), corner);
        const bool is_side_below = is_below_floor(mesh, mesh.edge(side));
        const RestEdge candidate = rest_edge(side);
        const bool precedes =
            is_below == is_side_below ? order.precedes(candidate, longest) : is_below;
        if (!precedes) continue;
        first = side;
        longest = candidate;
        is_below = is_side_below;
    }
    return first;
}

bool Criteria::may_unsplit(const ActiveSet& active, const Star& star) const {
    return edges_pass(active, star) && is_flat(active.mesh(), star) &&
           merged_edge_satisfies_criteria(active, star) && star_meets_scope(active, star) &&
           restored_faces_fit(active, star) && !is_kept(active, star);
}

void Criteria::keep(std::vector<VertexId> vertices) {
    std::ranges::sort(vertices);
    kept_ = std::move(vertices);
}

// Whether any sheet's vertex there is: all sheets are restored together.
bool Criteria::is_kept(const ActiveSet& active, const Star& star) const {
    if (kept_.empty()) return false;
    return !in_all_sheets(active, star, [&](const Star& sheet) {
        return !std::ranges::binary_search(kept_, sheet.m);
    });
}

// Whether all sheets at star.m are as `holds` says of one.
template <typename Holds>
bool Criteria::in_all_sheets(const ActiveSet& active, const Star& star, Holds holds) {
    bool all = true;
    active.mesh().for_each_sheet(star, [&](const Star& sheet) { all = all && holds(sheet); });
    return all;
}

// The edges along a cut pass for all sheets at once.
bool Criteria::edges_pass(const ActiveSet& active, const Star& star) const {
    const TriMesh& mesh = active.mesh();
    return passes_decimation(active, mesh.edge(star.bm)) &&
           passes_decimation(active, mesh.edge(star.mc)) &&
           in_all_sheets(active, star, [&](const Star& sheet) {
               return passes_decimation(active, mesh.edge(TriMesh::prev(sheet.mc))) &&
                      (sheet.on_boundary() ||
                       passes_decimation(active, mesh.edge(TriMesh::prev(sheet.mb))));
           });
}

bool Criteria::passes_decimation(const ActiveSet& active, EdgeId e) const {
    if (decimate_divergence_ < kOff &&
        !(divergence(active, e, decimate_divergence_) < decimate_divergence_))
        return false;
    return limits_.l_max == kOff || active.mesh().squared_length(e) < square(limits_.l_max);
}

// Merged-edge guard: bc would not itself need refinement.
bool Criteria::merged_edge_satisfies_criteria(const ActiveSet& active, const Star& star) const {
    const TriMesh& mesh = active.mesh();
    if (refine_divergence_ == kOff) return true;
    if (!mesh.is_deformed(star.b) && !mesh.is_deformed(star.c)) return true;
    const auto satisfies_criteria = [&](const SideEnds& side) {
        return !(side_divergence(active, side, refine_divergence_) > refine_divergence_);
    };
    return in_all_sheets(active, star, [&](const Star& sheet) {
        return satisfies_criteria({mesh.wedge(sheet.bm), mesh.wedge(TriMesh::next(sheet.mc))}) &&
               (sheet.on_boundary() ||
                satisfies_criteria({mesh.wedge(sheet.cm), mesh.wedge(TriMesh::next(sheet.mb))}));
    });
}

// No edge of a restored face longer than l_max would belong to a face that meets the zone.
bool Criteria::restored_faces_fit(const ActiveSet& active, const Star& star) const {
    if (!limits_length()) return true;
    const TriMesh& mesh = active.mesh();
    const auto too_long = [&](VertexId p, VertexId q) {
        const Vec3 along = mesh.position(q) - mesh.position(p);
        return glm::dot(along, along) > square(limits_.l_max);
    };
    const auto fits = [&](VertexId a, VertexId b, VertexId c) {
        if ((too_long(a, b) || too_long(b, c) || too_long(c, a)) && meets_zone(active, a, b, c)) {
            return false;
        }
        return !between_ || !between_->is_long_between_steps(a, b, c, limits_.l_max);
    };
    return in_all_sheets(active, star, [&](const Star& sheet) {
        return fits(sheet.a, sheet.b, sheet.c) &&
               (sheet.on_boundary() || fits(sheet.d, sheet.c, sheet.b));
    });
}

// Flatness guard: how far the surface moves if m goes, |f1.delta| + |f2.delta|.
bool Criteria::is_flat(const TriMesh& mesh, const Star& star) const {
    if (limits_.flatness == kOff) return true;
    const Vec3 b = mesh.position(star.b), c = mesh.position(star.c);
    const Vec3 delta = mesh.position(star.m) - (0.5 * b + 0.5 * c);
    const double length = glm::distance(b, c);
    const double allowed = limits_.flatness * length;
    if (star.on_boundary()) {
        if (length == 0.0) return glm::length(delta) <= allowed;
        return glm::length(glm::cross(delta, c - b)) <= allowed * length;
    }
    const auto height = [&](const Vec3& area_normal) {
        const double area = glm::length(area_normal);
        // A restored face without area has no plane: all of delta counts.
        return area > 0.0 ? std::abs(glm::dot(area_normal, delta)) / area : glm::length(delta);
    };
    return height(glm::cross(c - b, mesh.position(star.a) - b)) +
               height(glm::cross(mesh.position(star.d) - b, c - b)) <=
           allowed;
}

bool Criteria::star_meets_scope(const ActiveSet& active, const Star& star) const {
    if (!scope_) return true;
    const Vec3& m = active.rest_position(star.m);
    if (std::any_of(scope_->begin(), scope_->end(),
                    [&](const Box& box) { return box.contains(m); }))
        return true;
    const auto meets = [&](VertexId p, VertexId q) {
        return std::any_of(scope_->begin(), scope_->end(), [&](const Box& box) {
            return triangle_meets_box(m, active.rest_position(p), active.rest_position(q), box);
        });
    };
    return !in_all_sheets(active, star, [&](const Star& sheet) {
        return !meets(sheet.c, sheet.a) && !meets(sheet.a, sheet.b) &&
               (sheet.on_boundary() || (!meets(sheet.b, sheet.d) && !meets(sheet.d, sheet.c)));
    });
}

bool Criteria::meets_zone(const ActiveSet& active, VertexId a, VertexId b, VertexId c) const {
    return std::any_of(zones_.begin(), zones_.end(), [&](const Box& box) {
        return triangle_meets_box(active.rest_position(a), active.rest_position(b),
                                  active.rest_position(c), box);
    });
}

}  // namespace pectin
