// What adaptive meshing asks of edges and vertices.
// Source: Gain & Dodgson 1999, section 4, conditions (a) and (b); Greissmair & Purgathofer 1989
// for the distance of a midpoint from the faces at its edge (the paper's figure 5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "adapt/concurrent/partitions.h"
#include "ffd/symmetry.h"
#include "geometry/box.h"
#include "mesh/active_set.h"

namespace pectin {

class Embedding;

inline constexpr double kOff = std::numeric_limits<double>::infinity();

// Degrees and world units; kOff switches a test off, in refinement and in decimation.
struct AdaptLimits {
    double theta_max = kOff;   // an edge whose end normals diverge by more is refined
    double theta_min = kOff;   // less than theta_max: one that diverges by less may go
    double l_max = kOff;       // an edge longer than this in the zone is refined
    double flatness = kOff;    // farthest an unsplit may move the surface, in edge lengths
    double floor = 0.0;        // an edge shorter than twice this is not split
    double propagation = 1.0;  // rho in [1, 1.5): longest-edge propagation
    std::uint64_t budget = std::numeric_limits<std::uint64_t>::max();  // triangles
    // Ties are broken alike on both sides of it, so that a symmetric mesh stays so (with a
    // propagation of 1; beyond, what is split first depends on the order of splits).
    std::optional<MirrorPlane> symmetry{};
    // The warp folds nothing: a commit leaves no faces that cut each other
    // (adapt_without_self_intersections).
    bool without_self_intersections = false;
    // Of splits and removals that go on several threads (ConcurrentSplits, ConcurrentUnsplits). In
    // which order they go depends on it; how many threads there are does not matter.
    std::size_t partition_batch = kPartitionBatch;
};

// The tests of one pass. Edges along a cut (siblings) are one edge to all of them, with as many
// sides as there are sheets, so that they are split and restored together. Divergences are compared
// as 1 - cos(angle), here |n1 - n2|^2 / 2, which is the same for unit normals and does not cancel
// for small angles.
class Criteria {
  public:
    // zone: where edges longer than l_max are refined; none if no lattice is in use. With symmetry
    // its mirror image counts, too.
    // scope: only vertices whose star meets it may go; none means all.
    Criteria(const AdaptLimits& limits, const std::optional<Box>& zone,
             const std::optional<Box>& scope);
    // The same with several zones. between: tests edges against l_max also where the later steps of
    // a warp find them; must outlive this.
    Criteria(const AdaptLimits& limits, std::vector<Box> zones,
             std::optional<std::vector<Box>> scope, const Embedding* between = nullptr);

    const AdaptLimits& limits() const { return limits_; }

    // --- Refinement
    // An end is deformed and the end normals on one side diverge by more than theta_max
    // (condition (a)), or one of its faces is too coarse and is split at this edge (condition (b)).
    bool needs_refinement(const ActiveSet& active, EdgeId e) const;
    // Condition (a) alone. It depends on the ends of the edge and not on its faces.
    bool bends_too_far(const ActiveSet& active, EdgeId e) const;
    // Whether there is condition (b) at all.
    bool limits_length() const { return !zones_.empty() && limits_.l_max < kOff; }
    // Condition (b). The face of h meets the zone and has an edge longer than l_max; or so it was
    // between the steps of the warp (Embedding::is_long_between_steps).
    //
    // Such a face is split at edge_to_split(), its longest edge at rest. Longest-edge propagation
    // bisects every face at that edge, whatever the reason. So the faces that can come to be form
    // one binary tree per base face, and whether one of them is too coarse depends on its corners
    // alone: what refinement leads to does not depend on the order of splits.
    bool is_too_coarse(const ActiveSet& active, HalfEdgeId h) const;
    // Of the edges of h's face the one that is split before the others (SplitOrder), as a half-edge
    // of that face. An edge below the floor counts only where all three are.
    HalfEdgeId edge_to_split(const ActiveSet& active, HalfEdgeId h) const;
    // Whether one look tells that e does not, as it does of most. may_be_long: false if no edge is
    // longer than l_max. Precondition: one look is enough (ActiveSet::smooth_edges). Cost: O(1),
    // in one face.
    bool satisfies_criteria_fast(const TriMesh& mesh, EdgeId e, bool may_be_long) const;
    bool is_long(const TriMesh& mesh, EdgeId e) const {
        return mesh.squared_length(e) > limits_.l_max * limits_.l_max;
    }
    // Whether its halves would be shorter than the floor.
    bool is_below_floor(const TriMesh& mesh, EdgeId e) const {
        return is_below_floor(mesh.squared_length(e));
    }
    bool is_below_floor(double squared_length) const {
        return squared_length < min_squared_length_;
    }

    // --- Decimation
    bool may_unsplit(const ActiveSet& active, const Star& star) const;
    // Decimation removes none of these: a vertex that is dragged arrives where it is dragged to.
    void keep(std::vector<VertexId> vertices);

    // The greatest same-side divergence of the end normals, as 1 - cos; sides with an undefined
    // normal do not count, nor do those whose normals oppose each other (by more than 120 degrees)
    // at rest as well as now. Below `enough` it may be that of a side which does not count: what is
    // asked is only whether it reaches that far.
    static double divergence(const ActiveSet& active, EdgeId e, double enough = 0.0);

    // The same with opposed sides, too.
    static double full_divergence(const TriMesh& mesh, EdgeId e);
    // Whether that is beyond theta_max and an end is deformed.
    bool diverges(const TriMesh& mesh, EdgeId e) const;

  private:
    bool is_kept(const ActiveSet& active, const Star& star) const;
    template <typename Holds>
    static bool in_all_sheets(const ActiveSet& active, const Star& star, Holds holds);
    bool star_meets_scope(const ActiveSet& active, const Star& star) const;
    bool edges_pass(const ActiveSet& active, const Star& star) const;
    bool passes_decimation(const ActiveSet& active, EdgeId e) const;
    bool merged_edge_satisfies_criteria(const ActiveSet& active, const Star& star) const;
    bool restored_faces_fit(const ActiveSet& active, const Star& star) const;
    bool is_flat(const TriMesh& mesh, const Star& star) const;
    bool has_long_edge(const TriMesh& mesh, HalfEdgeId h) const;
    bool meets_zone(const ActiveSet& active, VertexId a, VertexId b, VertexId c) const;

    AdaptLimits limits_;
    std::vector<Box> zones_;
    std::optional<std::vector<Box>> scope_;
    const Embedding* between_ = nullptr;
    std::vector<VertexId> kept_;       // sorted
    double min_squared_length_ = 0.0;  // of the length of an edge that may be split
    double refine_divergence_ = kOff, decimate_divergence_ = kOff;
    float fast_squared_difference_ =
        std::numeric_limits<float>::infinity();  // |n1 - n2|^2, rounded down
    double fast_squared_length_ = kOff;  // squared; below 0 if the steps of a warp have to be asked
};

inline bool Criteria::satisfies_criteria_fast(const TriMesh& mesh, EdgeId e,
                                              bool may_be_long) const {
    const HalfEdgeId h = mesh.half_edge(e);
    const HalfEdge& b = mesh.half_edge(h);
    const HalfEdge& c = mesh.half_edge(TriMesh::next(h));
    const Vec3f &m = mesh.normal(b.wedge), &n = mesh.normal(c.wedge);
    const float x = m.x - n.x, y = m.y - n.y, z = m.z - n.z;
    if (!(x * x + y * y + z * z < fast_squared_difference_)) return false;
    if (!may_be_long) return true;
    const Vec3 &p = mesh.position(b.origin), &q = mesh.position(c.origin);
    const double u = p.x - q.x, v = p.y - q.y, w = p.z - q.z;
    return u * u + v * v + w * w <= fast_squared_length_;
}

}  // namespace pectin
