// Curvature trigger: the distance of an edge's midpoint from the faces at the edge, once deformed.
//
// Sources: J. Griessmair, W. Purgathofer. Deformation of solids with trivariate B-splines.
// Eurographics 1989.
// J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation. Eurographics
// UK 1999. Section 4, point 2 and figure 5, which compares it with the normals at the ends.
#pragma once

#include <limits>

#include "adapt/off.h"
#include "mesh/active_set.h"

namespace pectin {

class Embedding;

// Let delta lead from the middle of a deformed edge to where the warp takes the middle of the edge
// at rest. The error of the edge is the sum of |f.delta| over the unit normals f of its deformed
// faces: how far the surface is from its present triangles there. What moves along a face does not
// change the surface and does not count, except where the face ends: at a boundary the error is the
// distance of delta from the line of the edge. A face without area has no plane, so all of delta
// counts.
//
// Edges along a cut (siblings) count as one edge with a face in each sheet.
//
// The error of an edge changes when a neighbouring edge is split, since a face of it does. Whether
// an edge needs refinement therefore depends on what was split before. All edges of a length class
// are tested before the first of them is split, and all vertices of a level before the first of
// them is removed, so the result does not depend on the order of edges and vertices.
//
// Removing m must not cause a refinement, or both would undo each other's work in turn. This is
// what merged_edge_needs_refinement() ensures:
// - m is near the middle of the edge bc that its removal restores: k |m - middle| is less than half
//   the tolerance, where k is the number of faces at bc, and at least 2. The error of the edge
//   whose split has just inserted m is more than the tolerance and at most k |delta|, so m stays.
// - bc does not need refinement. If m rests in the middle of bc this follows, but an earlier
//   gesture may have moved m.
// - No outer edge needs refinement, whose face on the side of m changes. If the vertex across that
//   edge has the level of m, it may be removed in the same pass, so the edge has to pass with the
//   face that there is on its side and with the one that there would be.
class MidpointDistance {
  public:
    static constexpr bool kDependsOnFaces = true;

    MidpointDistance() = default;  // off
    // tolerance: in world units, above 0.
    explicit MidpointDistance(double tolerance) : tolerance_(tolerance) {}

    double tolerance() const { return tolerance_; }
    // The embedding in the warp, which must outlive this; null if nothing moves.
    void bind(const Embedding* embedding) { embedding_ = embedding; }

    // Refinement condition (a): an end of e is deformed and the error of e is above the tolerance.
    // Cost: O(sides), and that of Embedding::image().
    bool needs_refinement(const ActiveSet& active, EdgeId e) const;
    // Decimation condition (a) says nothing about the edges at a vertex by themselves.
    bool passes_decimation(const ActiveSet&, EdgeId) const { return true; }
    // Whether undoing the split of star.m would cause a refinement, or nearly so. Cost: O(sides)
    // of bc and of the outer edges, and five times that of Embedding::image().
    bool merged_edge_needs_refinement(const ActiveSet& active, const Star& star) const;

    // The fast path of Criteria compares normals, which say nothing about this error.
    float fast_path_bound() const {
        return tolerance_ == kOff ? std::numeric_limits<float>::infinity() : 0.0f;
    }
    // Roughness at rest hides nothing.
    double rest_difference_hiding(double) const { return std::numeric_limits<double>::infinity(); }
    // There are no sides that do not count.
    bool diverges_on_any_side(const ActiveSet& active, EdgeId e) const {
        return needs_refinement(active, e);
    }

  private:
    Vec3 delta(const ActiveSet& active, VertexId p, VertexId q, FaceId at) const;
    double error(const ActiveSet& active, EdgeId e) const;
    double merged_error(const ActiveSet& active, const Star& star) const;
    bool is_near_middle(const TriMesh& mesh, const Star& star) const;
    bool outer_edge_passes(const ActiveSet& active, HalfEdgeId outer, VertexId apex) const;

    double tolerance_ = kOff;
    const Embedding* embedding_ = nullptr;
};

}  // namespace pectin
