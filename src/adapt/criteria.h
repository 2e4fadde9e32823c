// What adaptive meshing asks of edges and vertices: triggers and guards.
//
// Sources: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, refinement conditions (a) and (b), decimation conditions (a) and
// (b).
// J. Griessmair, W. Purgathofer. Deformation of solids with trivariate B-splines. Eurographics
// 1989. For the distance of a midpoint from the faces at its edge (the paper's figure 5), which the
// flatness guard uses.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/concurrent/partitions.h"
#include "adapt/floor.h"
#include "adapt/off.h"
#include "adapt/triggers/certified_error.h"
#include "adapt/triggers/edge_length.h"
#include "adapt/triggers/midpoint_distance.h"
#include "adapt/triggers/normal_divergence.h"
#include "ffd/symmetry.h"
#include "geometry/box.h"
#include "mesh/active_set.h"

namespace pectin {

class Embedding;

// The curvature trigger in use: conditions (a) of refinement and of decimation. Each alternative is
// one file in adapt/triggers and has these members of NormalDivergence: kDependsOnFaces,
// needs_refinement, passes_decimation, merged_edge_needs_refinement, fast_path_bound,
// rest_difference_hiding and diverges_on_any_side.
//
// What a trigger may depend on:
// - needs_refinement(e) and passes_decimation(e): the two ends of e with their positions, wedges
//   and deformed marks, now and at rest. Then only the new edges bm, mc, am and dm are tested after
//   a split (EdgeClassifier::classify_one_ring). If kDependsOnFaces is true, also the faces at e.
//   Then the four outer edges are tested as well, and decimation repeats its passes.
// - The image of a point that is no vertex, such as a midpoint before it is inserted. A trigger
//   that needs it has a member bind(const Embedding*), which Criteria calls. Null means that
//   nothing moves.
// - Several threads ask at a time.
// - merged_edge_needs_refinement(star) must give the answer that needs_refinement() gives for bc
//   once m is gone, and with kDependsOnFaces also for the outer edges. Otherwise refinement and
//   decimation undo each other's work in turn.
// - L_max relies on the trigger to find bends in long drags (EdgeLength::Steps::are_only_sampled),
//   except at edges as rough as rest_difference_hiding() says.
// - fast_path_bound(): if the trigger does not follow from the difference of the end normals, it
//   returns 0; then the fast path accepts no edge.
//
// A trigger may ask about faces instead of edges. Then it has a member needed_split(active, h), the
// half-edge at which the face of h has to be split, and needs_refinement(e) rests on it. Passes
// then test each face once (Criteria::curvature_tests_faces), and of a split the new faces.
// bind() gets the order of splits and the floor as well, and update() is called when a pass begins.
//
// An alternative takes the place of NormalDivergence. A condition beside (a) and (b) is a member of
// Criteria as EdgeLength is: need(), edges_pass(), may_unsplit() and classify_one_ring() ask it.
using CurvatureTrigger = std::variant<NormalDivergence, MidpointDistance, CertifiedError>;

// Lengths in world units. kOff switches a limit off, in refinement and in decimation.
struct AdaptLimits {
    CurvatureTrigger curvature{};  // conditions (a)
    double l_max = kOff;           // conditions (b): an edge in the zone that is longer is refined
    // L_max was not set by the user, but follows from the lattice as the distance of samples. In a
    // warp of several steps edges may then be longer (EdgeLength::Steps::are_only_sampled).
    bool l_max_is_automatic = false;
    double flatness = kOff;    // how far an unsplit may move the surface, in lengths of its edge
    double floor = 0.0;        // an edge shorter than twice this is not split
    double propagation = 1.0;  // rho in [1, 1.5), see Propagation
    std::uint64_t budget = std::numeric_limits<std::uint64_t>::max();  // triangles of the mesh
    // A mesh that is symmetric about this plane stays symmetric. It may not with a propagation
    // above 1, since the result then depends on the order of splits, or if the budget is used up.
    std::optional<MirrorPlane> symmetry{};
    // The warp does not fold space: a commit removes self-intersections (see
    // adapt_without_self_intersections).
    bool without_self_intersections = false;
    Partitioning partitioning{};
};

// The tests of one pass. Edges along a cut (siblings) count as one edge with as many sides as there
// are sheets, so that they are split and restored together.
class Criteria {
  public:
    // zone: where edges longer than l_max are refined; none if no lattice is in use. scope: only
    // vertices whose star meets it may be removed; none means everywhere. Both are at rest. With
    // symmetry their mirror images count as well. embedding: in the warp that deforms the mesh,
    // all of whose steps are tested against l_max; none if nothing moves. It must outlive this.
    Criteria(const AdaptLimits& limits, const std::optional<Box>& zone,
             const std::optional<Box>& scope, const Embedding* embedding = nullptr);
    // The same with several boxes.
    Criteria(const AdaptLimits& limits, std::vector<Box> zones,
             std::optional<std::vector<Box>> scope, const Embedding* embedding = nullptr);

    const AdaptLimits& limits() const { return limits_; }

    // --- Refinement: e needs it by refinement condition (a) or (b). Cost: O(sides).
    bool needs_refinement(const ActiveSet& active, EdgeId e) const {
        return need(active, e) == SplitNeed::itself;
    }
    // What has to be split because of e. The decision of needs_refinement() is made here.
    SplitNeed need(const ActiveSet& active, EdgeId e) const {
        return curvature_needs_refinement(active, e) ? SplitNeed::itself : length_.need(active, e);
    }
    // Refinement condition (a) by itself.
    bool curvature_needs_refinement(const ActiveSet& active, EdgeId e) const;
    // Whether it depends on the faces at an edge and not on its ends alone. Then edits are serial
    // (AdaptLimits::partitioning), and edges and vertices are tested in groups before one of the
    // group is split or removed, so that the order within the group does not matter.
    bool curvature_depends_on_faces() const { return curvature_depends_on_faces_; }
    // Whether it is a condition for faces, which need to be split at one of their edges:
    // curvature_needed_split() is that half-edge of the face of h, or none. Then
    // curvature_needs_refinement() says whether a face has to be split at e, and refinement begins
    // with faces_to_test().
    bool curvature_tests_faces() const { return curvature_tests_faces_; }
    HalfEdgeId curvature_needed_split(const ActiveSet& active, HalfEdgeId h) const;
    // Of the certified trigger, which alone can prove an error; null if another one is in use.
    const CertifiedError* certified_error() const {
        return std::get_if<CertifiedError>(&limits_.curvature);
    }
    std::vector<FaceId> faces_to_test(const ActiveSet& active) const;
    // To be called by each pass before it asks anything: the displacements of the warp may have
    // changed since the pass before.
    void update() const;
    // Whether decimation keeps the shape of the surface, so that it has to keep it free of
    // self-intersections, too.
    bool limits_removal() const {
        return limits_.flatness != kOff ||
               (certified_error() && certified_error()->tolerance() < kOff);
    }
    // The trigger of conditions (b).
    const EdgeLength& length() const { return length_; }
    // Fast path of needs_refinement() for smooth edges (ActiveSet::smooth_edges). True means that e
    // needs no refinement; false is inconclusive. may_be_long: false if it is known that no edge is
    // longer than l_max. Cost: O(1), within one face.
    bool satisfies_criteria_fast(const TriMesh& mesh, EdgeId e, bool may_be_long) const;
    // Whether the floor forbids to split e, whether e needs refinement or not.
    bool is_below_floor(const TriMesh& mesh, EdgeId e) const {
        return is_below_floor(mesh.squared_length(e));
    }
    bool is_below_floor(double squared_length) const {
        return floor_.forbids_split(squared_length);
    }

    // --- Decimation: decimation conditions (a) and (b) for the edges of a star, and the guards.
    // The star's connectivity and levels have been tested by TriMesh::removable(), from which it
    // comes.
    bool may_unsplit(const ActiveSet& active, const Star& star) const;
    // Decimation removes none of these. A vertex that is dragged arrives where it is dragged to.
    void keep(std::vector<VertexId> vertices);

    // --- Statistics.
    // Whether e would need refinement by refinement condition (a) if sides with opposed normals
    // counted as well.
    bool diverges_on_any_side(const ActiveSet& active, EdgeId e) const;

  private:
    // Here alone a pass asks which curvature trigger is in use. Settings choose it.
    template <typename Question>
    auto ask_curvature(Question question) const {
        return std::visit(question, limits_.curvature);
    }
    EdgeLength::Steps steps_of(const Embedding* embedding) const;
    bool only_samples(const Embedding& steps) const;
    bool edges_pass(const ActiveSet& active, const Star& star) const;
    bool merged_edge_satisfies_criteria(const ActiveSet& active, const Star& star) const;
    bool is_flat(const TriMesh& mesh, const Star& star) const;
    bool star_meets_scope(const ActiveSet& active, const Star& star) const;
    bool is_kept(const TriMesh& mesh, const Star& star) const;

    AdaptLimits limits_;
    Floor floor_;
    EdgeLength length_;
    std::optional<std::vector<Box>> scope_;
    std::vector<VertexId> kept_;  // sorted
    bool curvature_depends_on_faces_, curvature_tests_faces_;
    // Bounds of the fast path, from the triggers: of |n1 - n2|^2 and of the squared length.
    float squared_difference_bound_;
    double squared_length_bound_;
};

inline bool Criteria::curvature_needs_refinement(const ActiveSet& active, EdgeId e) const {
    return ask_curvature([&](const auto& trigger) { return trigger.needs_refinement(active, e); });
}

inline HalfEdgeId Criteria::curvature_needed_split(const ActiveSet& active, HalfEdgeId h) const {
    return ask_curvature([&](const auto& trigger) {
        if constexpr (requires { trigger.needed_split(active, h); }) {
            return trigger.needed_split(active, h);
        } else {
            return kNone<HalfEdgeId>;
        }
    });
}

inline std::vector<FaceId> Criteria::faces_to_test(const ActiveSet& active) const {
    return ask_curvature([&](const auto& trigger) {
        if constexpr (requires { trigger.faces_to_test(active); }) {
            return trigger.faces_to_test(active);
        } else {
            return std::vector<FaceId>{};
        }
    });
}

inline void Criteria::update() const {
    ask_curvature([](const auto& trigger) {
        if constexpr (requires { trigger.update(); }) trigger.update();
    });
}

inline bool Criteria::satisfies_criteria_fast(const TriMesh& mesh, EdgeId e,
                                              bool may_be_long) const {
    const HalfEdgeId h = mesh.half_edge(e);
    const HalfEdge& b = mesh.half_edge(h);
    const HalfEdge& c = mesh.half_edge(TriMesh::next(h));
    const Vec3f &m = mesh.normal(b.wedge), &n = mesh.normal(c.wedge);
    const float x = m.x - n.x, y = m.y - n.y, z = m.z - n.z;
    if (!(x * x + y * y + z * z < squared_difference_bound_)) return false;
    if (!may_be_long) return true;
    const Vec3 &p = mesh.position(b.origin), &q = mesh.position(c.origin);
    const double u = p.x - q.x, v = p.y - q.y, w = p.z - q.z;
    return u * u + v * v + w * w <= squared_length_bound_;
}

}  // namespace pectin
