// Length trigger: edges in the influenced zone are no longer than L_max.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, conditions (b) of refinement and of decimation, and point 1 on
// sampling (figure 4).
#pragma once

#include <cstdint>
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

// A face is too coarse if it meets the zone at rest and one of its edges is longer than L_max now,
// or was between the steps of the warp (Embedding::is_long_between_steps). The paper tests edges
// instead of faces; but a deformation may lie within a face and miss its edges.
//
// A face that is too coarse is split at the edge that is longest at rest (SplitOrder::first_edge).
// Longest-edge propagation bisects every face at that edge, whatever the reason for the split. So
// the faces that can arise form one binary tree for each base face, and whether one of them is too
// coarse depends on its corners alone. The result of refinement does not depend on the order of
// splits.
class EdgeLength {
  public:
    // l_max: world units, deformed lengths. zones: at rest; with none the trigger is off. between:
    // the embedding whose earlier steps are tested as well, or null; it must outlive this.
    EdgeLength(double l_max, std::vector<Box> zones, const Embedding* between,
               const SplitOrder& order, const Floor& floor);

    bool is_on() const { return !zones_.empty() && l_max_ < kOff; }
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
    bool is_too_coarse(const ActiveSet& active, HalfEdgeId h) const;
    bool is_too_coarse(const ActiveSet& active, VertexId a, VertexId b, VertexId c) const;

    double l_max_;
    std::vector<Box> zones_;
    const Embedding* between_;
    SplitOrder order_;
    Floor floor_;
};

}  // namespace pectin
