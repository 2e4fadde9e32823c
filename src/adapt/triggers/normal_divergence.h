// Curvature trigger: the divergence of the normals at the two ends of an edge.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, conditions (a) of refinement and of decimation, and point 2. The
// test goes back to U. Nimscheck. Rendering for Free Form Deformations. University of Cambridge,
// technical report 381 (1995).
#pragma once

#include "adapt/off.h"
#include "mesh/active_set.h"

namespace pectin {

// Normals are compared on each side of an edge by itself, so a crease is not refined merely because
// it is a crease. Edges along a cut (siblings) count as one edge with one side for each sheet.
//
// Divergences are stored as 1 - cos(angle), computed as |n1 - n2|^2 / 2. For unit normals this is
// the paper's 1 - n1.n2, without its cancellation at small angles. A side does not count if one of
// its normals is undefined, or if its normals oppose each other (by more than 120 degrees) both at
// rest and now.
//
// Many edges of real models are rough: their normals diverge by more than theta_max before anything
// was deformed, up to a third of all edges. By the paper's rule the first touch splits them all,
// and the new vertices lie flat on the old faces and add nothing. RestAllowance excepts roughness
// that the gesture found and did not make.
class NormalDivergence {
  public:
    static constexpr bool kDependsOnFaces = false;

    // In degrees. A limit of 180 or more is off, see angle_or_off().
    struct Angles {
        double theta_max = kOff;  // edges that diverge by more are refined
        double theta_min = kOff;  // below theta_max: edges that diverge by less may be decimated
    };

    // By how much an edge may diverge more than it did at rest, before the gesture, whatever the
    // angles are. As factors of |n1 - n2|; 0 is the paper's rule.
    struct RestAllowance {
        double refinement = 0.0, decimation = 0.0;
    };

    // Returns kOff for a limit of 180 degrees or more, since no normals diverge by more than that.
    static double angle_or_off(double degrees) { return degrees < 180.0 ? degrees : kOff; }

    NormalDivergence() = default;                     // both limits off
    explicit NormalDivergence(const Angles& angles);  // the paper's rule
    NormalDivergence(const Angles& angles, const RestAllowance& allowance);

    const Angles& angles() const { return angles_; }
    const RestAllowance& allowance() const { return allowance_; }

    // Refinement condition (a): an end of e is deformed and the end normals diverge by more than
    // theta_max and by more than is allowed to what they were at rest. This depends on the ends of
    // e and not on its faces. Cost: O(sides).
    bool needs_refinement(const ActiveSet& active, EdgeId e) const;
    // Decimation condition (a): the end normals of e diverge by less than theta_min, or by less
    // than is allowed to what they were at rest.
    bool passes_decimation(const ActiveSet& active, EdgeId e) const;
    // The merged-edge guard: whether bc, the edge that undoing the split of star.m restores, would
    // need refinement.
    bool merged_edge_needs_refinement(const ActiveSet& active, const Star& star) const;

    // The fast path of Criteria: an edge without a normal discontinuity needs no refinement if
    // |n1 - n2|^2 of its end normals is less than this. Infinite if the trigger is off. It is
    // rounded down, since the fast path compares in float.
    float fast_path_bound() const { return fast_path_bound_; }

    // Edges with so large a |n1 - n2|^2 at rest may bend by the angle `bend`, given in the same
    // way, without needing refinement. Infinite if there is no allowance.
    double rest_difference_hiding(double bend) const {
        return bend / (allowance_.refinement * allowance_.refinement);
    }

    // Like needs_refinement(), but sides with opposed normals count as well: what the statistics
    // report as held back. With a RestAllowance they are too rough at rest to count.
    bool diverges_on_any_side(const ActiveSet& active, EdgeId e) const;
    // The largest divergence of e, as 1 - cos(angle), over all sides with defined normals. For
    // statistics.
    static double largest_on_any_side(const TriMesh& mesh, EdgeId e);

  private:
    // The ends of an edge on one of its sides.
    struct SideEnds {
        WedgeId first, second;
    };
    static SideEnds side_of(const TriMesh& mesh, HalfEdgeId h);
    // Whether refinement condition (a) holds on this side, for an edge with a deformed end.
    bool diverges(const ActiveSet& active, const SideEnds& side, bool may_be_opposed) const;
    bool passes_decimation(const ActiveSet& active, const SideEnds& side) const;

    Angles angles_;
    RestAllowance allowance_;
    double refine_above_ = kOff, decimate_below_ = kOff;  // 1 - cos(angle)
    float fast_path_bound_ = std::numeric_limits<float>::infinity();
};

}  // namespace pectin
