// Length trigger: edges in the influenced zone are no longer than L_max.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, conditions (b) of refinement and of decimation, and point 1 on
// sampling (figure 4).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "adapt/floor.h"
#include "adapt/off.h"
#include "adapt/split_order.h"
#include "geometry/box.h"
#include "mesh/active_set.h"

namespace pectin {

class Embedding;

// Which edge has to be split because of an edge e.
enum class SplitNeed : std::uint8_t {
    none,
    itself,
    // Another edge of one of e's faces. The face is too coarse since e is long, but it is split at
    // that edge, which is not long itself. Asked about itself, that edge might pass for one that
    // needs nothing.
    neighbour
};

// A face is too coarse if it meets the zone at rest and one of its edges is longer than L_max now.
// The paper tests edges instead of faces; but a deformation may lie within a face and miss its
// edges. In a warp of several steps a face is too coarse as well if, before one of the later steps,
// it meets the zone of that step and has an edge longer than L_max.
//
// Steps::are_only_sampled changes this for long drags. A drag of many radii draws the surface out
// into a thin spike. Its sides are straight, but each step finds their edges longer than L_max, and
// as faces are bisected at rest, where the sides of the spike are a disc, the number of splits
// grows with the square of the number of steps. So L_max then only ensures that the curvature
// trigger notices each step:
// - At rest a face is too coarse if it meets the zone of any step and has a long edge.
// - Before a later step a long face that meets the zone is fine all the same if one of its corners
//   is as near to the middle of the zone as the face is, up to half of L_max. The step acts most in
//   the middle, so what it does to the face shows at that corner.
// - It may not show at a corner right in the middle, which is moved but not tilted. So a long face
//   is too coarse as well if the later steps bend it by more than half of L_max in all: each step
//   counts by how much farther it moves one corner than another along the normal of the face. On
//   the straight sides of a spike, steps move all corners along the face.
// - At boundaries, seams and between parts none of these exceptions hold, since a line there can
//   bend in the plane of its faces, where no normal shows it. Nor do they hold at edges so rough at
//   rest that the curvature trigger allows bends of 45 degrees, or for faces that decimation would
//   restore.
// - The edges of the result may be longer than L_max.
//
// A face that is too coarse is split at the edge that is longest at rest (SplitOrder::first_edge).
// Longest-edge propagation bisects every face at that edge, whatever the reason for the split. So
// the faces that can arise form one binary tree for each base face, and whether one of them is too
// coarse depends on itself alone. The result of refinement does not depend on the order of splits.
class EdgeLength {
  public:
    // The steps of a warp of several steps.
    struct Steps {
        const Embedding* embedding = nullptr;  // null for a single step; must outlive the trigger
        // L_max follows from the lattice, the curvature trigger finds bends, and each step moves
        // the middles of its zones most.
        bool are_only_sampled = false;
        // The curvature trigger may miss bends at edges with a larger |n1 - n2|^2 at rest.
        double largest_rest_difference = std::numeric_limits<double>::infinity();
    };

    // l_max: world units, deformed lengths. zones: at rest; with none the trigger is off.
    EdgeLength(double l_max, std::vector<Box> zones, const Steps& steps, const SplitOrder& order,
               const Floor& floor);

    bool is_on() const { return !zones_.empty() && l_max_ < kOff; }
    // Whether the edges in the zones are no longer than L_max after refinement.
    bool limits_result() const { return !steps_.are_only_sampled; }
    bool is_long(const TriMesh& mesh, EdgeId e) const {
        return mesh.squared_length(e) > l_max_ * l_max_;
    }

    // Refinement condition (b): what has to be split because of e. `itself` means that e needs
    // refinement: one of its faces is too coarse and is split at e. Cost: O(sides).
    SplitNeed need(const ActiveSet& active, EdgeId e) const;
    // The half-edge of the face of h at which that face has to be split; none if it is fine. need()
    // rests on this alone.
    HalfEdgeId needed_split(const ActiveSet& active, HalfEdgeId h) const;
    // Decimation condition (b): e is shorter than L_max, also outside the zone.
    bool passes_decimation(const TriMesh& mesh, EdgeId e) const {
        return l_max_ == kOff || mesh.squared_length(e) < l_max_ * l_max_;
    }
    // The merged-edge guard: whether a face that undoing the split of star.m restores would be too
    // coarse.
    bool restored_face_is_too_coarse(const ActiveSet& active, const Star& star) const;

    // The fast path of Criteria: a face needs no refinement if the squared lengths of its edges are
    // at most this. Infinite if the trigger is off; negative, so that the fast path accepts
    // nothing, if lengths now do not decide since there are earlier steps.
    double fast_path_bound() const;

  private:
    // A face of the mesh, or one that undoing a split restores.
    struct Face {
        VertexId a, b, c;
        HalfEdgeId side = kNone<HalfEdgeId>;  // none for a face that is only restored
    };
    using Corners = std::array<Vec3, 3>;

    bool is_too_coarse(const ActiveSet& active, HalfEdgeId h) const;
    bool may_hide_a_step(const ActiveSet& active, const Face& face) const;
    bool hides_bends(const ActiveSet& active, HalfEdgeId h) const;
    bool is_too_coarse(const ActiveSet& active, const Face& face) const;
    bool rests_in_zone(const ActiveSet& active, const Face& face) const;
    // Precondition of this and the next: there are several steps.
    bool is_long_before_a_step(const Face& face) const;
    bool may_miss_a_step(const Face& face) const;
    Corners corners_before(std::size_t step, const Face& face) const;
    bool is_long(const Vec3& p, const Vec3& q) const {
        const Vec3 along = q - p;
        return glm::dot(along, along) > l_max_ * l_max_;
    }
    bool has_long_side(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return is_long(b, c) || is_long(c, a) || is_long(a, b);
    }
    bool has_long_side(const Corners& at) const { return has_long_side(at[0], at[1], at[2]); }
    bool shows_at_no_corner(const Corners& corners, const Box& zone) const;

    double l_max_;
    std::vector<Box> zones_;
    Steps steps_;
    SplitOrder order_;
    Floor floor_;
};

}  // namespace pectin
