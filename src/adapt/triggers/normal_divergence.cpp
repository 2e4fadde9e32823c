#include "adapt/triggers/normal_divergence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adapt/sheets.h"

namespace pectin {
namespace {

// Rest normals more than 120 degrees apart (n1.n2 < -1/2) belong to a spike or a fold that was
// there before the drag. Refinement cannot bring them together. If the drag opens the fold, the
// side counts again. Otherwise the mesh after the drag, whose present normals become the rest
// normals, would need refinement that the drag did not find.
constexpr double kOpposedDivergence = 1.5;

// Slack for a bound that is compared in float.
constexpr double kRoundedDown = 1.0 - 1e-6;

double one_minus_cosine(double degrees) {
    const double angle = NormalDivergence::angle_or_off(degrees);
    return angle == kOff ? kOff : 1.0 - std::cos(angle * std::numbers::pi / 180.0);
}

bool is_defined(const Vec3f& n) { return n != Vec3f{0.0f}; }

// The paper's epsilon = 1 - n1.n2 of unit normals.
double divergence_of(const Vec3f& n1, const Vec3f& n2) {
    const Vec3f difference = n1 - n2;
    return 0.5 * static_cast<double>(glm::dot(difference, difference));
}

// The wedges at the two ends of an edge on one of its sides.
struct SideEnds {
    WedgeId first, second;
};

SideEnds side_of(const TriMesh& mesh, HalfEdgeId h) {
    return {mesh.wedge(h), mesh.wedge(TriMesh::next(h))};
}

// The divergence on one side, or 0 if the side does not count. Results below `enough` are returned
// without checking whether the side counts.
double side_divergence(const ActiveSet& active, SideEnds side, double enough) {
    const Vec3f n1 = active.mesh().normal(side.first), n2 = active.mesh().normal(side.second);
    const double divergence = divergence_of(n1, n2);
    if (divergence < enough) return divergence;
    if (!is_defined(n1) || !is_defined(n2)) return 0.0;
    if (divergence <= kOpposedDivergence) return divergence;
    const bool opposed_at_rest =
        divergence_of(active.rest_normal(side.first), active.rest_normal(side.second)) >
        kOpposedDivergence;
    return opposed_at_rest ? 0.0 : divergence;
}

// The largest divergence over the sides that count; exact only if it is at least `enough`. The
// second side of a smooth edge is skipped, since it has the same two wedges.
double largest_divergence(const ActiveSet& active, EdgeId e, double enough) {
    const TriMesh& mesh = active.mesh();
    const SideEnds left = side_of(mesh, mesh.half_edge(e));
    double largest = -1.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const SideEnds side = side_of(mesh, h);
        const bool is_smooth = side.first == left.second && side.second == left.first;
        if (!is_smooth) largest = std::max(largest, side_divergence(active, side, enough));
    });
    return largest;
}

bool has_deformed_end(const TriMesh& mesh, EdgeId e) {
    const HalfEdgeId h = mesh.half_edge(e);
    return mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h));
}

}  // namespace

NormalDivergence::NormalDivergence(const Angles& angles)
    : angles_(angles),
      refine_above_(one_minus_cosine(angles.theta_max)),
      decimate_below_(one_minus_cosine(angles.theta_min)),
      fast_path_bound_(static_cast<float>(2.0 * kRoundedDown * refine_above_)) {}

bool NormalDivergence::needs_refinement(const ActiveSet& active, EdgeId e) const {
    return refine_above_ < kOff && has_deformed_end(active.mesh(), e) &&
           largest_divergence(active, e, refine_above_) > refine_above_;
}

bool NormalDivergence::passes_decimation(const ActiveSet& active, EdgeId e) const {
    return decimate_below_ == kOff ||
           largest_divergence(active, e, decimate_below_) < decimate_below_;
}

//          a
//         /|\        Undoing the split of m merges bm and mc into bc. On the side of a, its ends
//        / | \       have the wedges that face bma has at b and face mca has at c. On the side of
//       b--m--c      d, they are those of face mbd at b and of face cmd at c.
//        \ | /
//         \|/
//          d
bool NormalDivergence::merged_edge_needs_refinement(const ActiveSet& active,
                                                    const Star& star) const {
    const TriMesh& mesh = active.mesh();
    if (refine_above_ == kOff) return false;
    if (!mesh.is_deformed(star.b) && !mesh.is_deformed(star.c)) return false;
    const auto needs_nothing = [&](const SideEnds& side) {
        return !(side_divergence(active, side, refine_above_) > refine_above_);
    };
    return !all_sheets(mesh, star, [&](const Star& sheet) {
        return needs_nothing({mesh.wedge(sheet.bm), mesh.wedge(TriMesh::next(sheet.mc))}) &&
               (sheet.on_boundary() ||
                needs_nothing({mesh.wedge(sheet.cm), mesh.wedge(TriMesh::next(sheet.mb))}));
    });
}

bool NormalDivergence::diverges_on_any_side(const TriMesh& mesh, EdgeId e) const {
    return has_deformed_end(mesh, e) && largest_on_any_side(mesh, e) > refine_above_;
}

double NormalDivergence::largest_on_any_side(const TriMesh& mesh, EdgeId e) {
    double largest = 0.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const SideEnds side = side_of(mesh, h);
        const Vec3f n1 = mesh.normal(side.first), n2 = mesh.normal(side.second);
        if (is_defined(n1) && is_defined(n2)) largest = std::max(largest, divergence_of(n1, n2));
    });
    return largest;
}

}  // namespace pectin
