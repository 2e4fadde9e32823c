#include "adapt/triggers/normal_divergence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adapt/sheets.h"

namespace pectin {
namespace {

// Rest normals more than 120 degrees apart (n1.n2 < -1/2) belong to a spike or a fold that was
// there before the drag. Refinement cannot bring them together. If the drag opens the fold, the
// side counts again.
constexpr double kOpposedDivergence = 1.5;

// Slack for a bound that is compared in float.
constexpr double kRoundedDown = 1.0 - 1e-6;

double one_minus_cosine(double degrees) {
    const double angle = NormalDivergence::angle_or_off(degrees);
    return angle == kOff ? kOff : 1.0 - std::cos(angle * std::numbers::pi / 180.0);
}

bool is_defined(const Vec3f& n) { return n != Vec3f{0.0f}; }

// The paper's epsilon = 1 - n1.n2 of unit normals; 0 if one of them is undefined.
double divergence_of(const Vec3f& n1, const Vec3f& n2) {
    if (!is_defined(n1) || !is_defined(n2)) return 0.0;
    const Vec3f difference = n1 - n2;
    return 0.5 * static_cast<double>(glm::dot(difference, difference));
}

bool are_opposed(double divergence, double at_rest) {
    return divergence > kOpposedDivergence && at_rest > kOpposedDivergence;
}

// Whether predicate(half-edge) holds on a side of e. The second side of a smooth edge is skipped,
// since it has the same two wedges.
template <typename Predicate>
bool is_true_on_any_side(const TriMesh& mesh, EdgeId e, Predicate predicate) {
    const HalfEdgeId left = mesh.half_edge(e);
    const WedgeId first = mesh.wedge(left), second = mesh.wedge(TriMesh::next(left));
    bool is_true = false;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const bool is_smooth = mesh.wedge(h) == second && mesh.wedge(TriMesh::next(h)) == first;
        if (!is_smooth && !is_true) is_true = predicate(h);
    });
    return is_true;
}

bool has_deformed_end(const TriMesh& mesh, EdgeId e) {
    const HalfEdgeId h = mesh.half_edge(e);
    return mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h));
}

}  // namespace

NormalDivergence::NormalDivergence(const Angles& angles)
    : NormalDivergence(angles, RestAllowance{}) {}

NormalDivergence::NormalDivergence(const Angles& angles, const RestAllowance& allowance)
    : angles_(angles),
      allowance_(allowance),
      refine_above_(one_minus_cosine(angles.theta_max)),
      decimate_below_(one_minus_cosine(angles.theta_min)),
      fast_path_bound_(static_cast<float>(2.0 * kRoundedDown * refine_above_)) {}

NormalDivergence::SideEnds NormalDivergence::side_of(const TriMesh& mesh, HalfEdgeId h) {
    return {mesh.wedge(h), mesh.wedge(TriMesh::next(h))};
}

bool NormalDivergence::diverges(const ActiveSet& active, const SideEnds& side,
                                bool may_be_opposed) const {
    const TriMesh& mesh = active.mesh();
    const double now = divergence_of(mesh.normal(side.first), mesh.normal(side.second));
    if (!(now > refine_above_)) return false;
    const double at_rest =
        divergence_of(active.rest_normal(side.first), active.rest_normal(side.second));
    if (!may_be_opposed && are_opposed(now, at_rest)) return false;
    return now > allowance_.refinement * allowance_.refinement * at_rest;
}

bool NormalDivergence::passes_decimation(const ActiveSet& active, const SideEnds& side) const {
    const TriMesh& mesh = active.mesh();
    const double now = divergence_of(mesh.normal(side.first), mesh.normal(side.second));
    if (now < decimate_below_) return true;
    const double at_rest =
        divergence_of(active.rest_normal(side.first), active.rest_normal(side.second));
    if (are_opposed(now, at_rest)) return decimate_below_ > 0.0;
    return now < allowance_.decimation * allowance_.decimation * at_rest;
}

bool NormalDivergence::needs_refinement(const ActiveSet& active, EdgeId e) const {
    const TriMesh& mesh = active.mesh();
    if (refine_above_ == kOff || !has_deformed_end(mesh, e)) return false;
    return is_true_on_any_side(
        mesh, e, [&](HalfEdgeId h) { return diverges(active, side_of(mesh, h), false); });
}

bool NormalDivergence::passes_decimation(const ActiveSet& active, EdgeId e) const {
    const TriMesh& mesh = active.mesh();
    return decimate_below_ == kOff || !is_true_on_any_side(mesh, e, [&](HalfEdgeId h) {
               return !passes_decimation(active, side_of(mesh, h));
           });
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
    const auto needs_nothing = [&](const SideEnds& side) { return !diverges(active, side, false); };
    return !all_sheets(mesh, star, [&](const Star& sheet) {
        return needs_nothing({mesh.wedge(sheet.bm), mesh.wedge(TriMesh::next(sheet.mc))}) &&
               (sheet.on_boundary() ||
                needs_nothing({mesh.wedge(sheet.cm), mesh.wedge(TriMesh::next(sheet.mb))}));
    });
}

bool NormalDivergence::diverges_on_any_side(const ActiveSet& active, EdgeId e) const {
    const TriMesh& mesh = active.mesh();
    if (refine_above_ == kOff || !has_deformed_end(mesh, e)) return false;
    return is_true_on_any_side(
        mesh, e, [&](HalfEdgeId h) { return diverges(active, side_of(mesh, h), true); });
}

double NormalDivergence::largest_on_any_side(const TriMesh& mesh, EdgeId e) {
    double largest = 0.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const SideEnds side = side_of(mesh, h);
        const Vec3f n1 = mesh.normal(side.first), n2 = mesh.normal(side.second);
        largest = std::max(largest, divergence_of(n1, n2));
    });
    return largest;
}

}  // namespace pectin
