// Curvature trigger: a proven bound of the distance between a face and the exact surface.
//
// Sources: S. Waldron. The error in linear interpolation at the vertices of a simplex. SIAM Journal
// on Numerical Analysis 35(3), 1998. For the bound (ffd/interpolation_error.h).
// M.-C. Rivara. Algorithms for refining triangular grids suitable for adaptive and multigrid
// techniques. International Journal for Numerical Methods in Engineering 20 (1984). For the edge at
// which a face is split.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "adapt/floor.h"
#include "adapt/off.h"
#include "adapt/split_order.h"
#include "mesh/active_set.h"

namespace pectin {

class Embedding;

// The exact surface is the image of the flat faces under the warp. The bound of a face says how far
// its points may be from the images of the points that they were at rest. A face needs refinement
// if its bound is above the tolerance, whether its edges bend visibly or not, so nothing can slip
// between samples, and L_max and the flatness guard are not needed. It is split at the edge that is
// longest at rest (SplitOrder::first_edge). As with EdgeLength, whether a face needs refinement
// depends on that face alone, and the result does not depend on the order of splits.
//
// Errors add up over the gestures since the object was opened. TriMesh::error() stores an ellipsoid
// that contains the vectors from the points of a face to the exact surface. A gesture transports it
// and adds its own error (InterpolationError::accumulated). Its largest radius is the error of the
// face, which thus grows only in the directions in which it is. Removing m must not lose what an
// earlier gesture has made of the surface, and must not cause a refinement:
// - the own bound of each restored face is at most the tolerance, and
// - so is the sum with its errors, to which the vector from the middle of bc to m at rest counts.
//   Without this, many gestures that do nothing could erode the surface step by step. A vertex
//   whose removal changes neither the surface at rest nor its errors, such as one that a frame of
//   this gesture has inserted, need not pass this.
class CertifiedError {
  public:
    static constexpr bool kDependsOnFaces = false;

    CertifiedError() = default;  // off
    // Which faces refinement looks at first. The result is the same.
    enum class Search {
        due,  // if bounds grow in proportion to the drag, those that are due (DueFaces), else all
        all   // the reference
    };
    // tolerance: in world units, above 0.
    explicit CertifiedError(double tolerance, Search search = Search::due)
        : tolerance_(tolerance), search_(search) {}

    double tolerance() const { return tolerance_; }
    // embedding: in the warp, which must outlive this; null if nothing moves.
    void bind(const Embedding* embedding, const SplitOrder& order, const Floor& floor);
    // To be called after the displacements of the warp have changed, before a pass asks anything.
    void update() const;

    // --- Bounds, in world units. Several threads may ask. Cost: that of InterpolationError.
    // Of what the warp adds, for the face of h.
    double bound(const ActiveSet& active, FaceId f) const;
    // The error of f after this gesture: with what earlier ones have left. own_bound: bound().
    ErrorEllipsoid accumulated(const ActiveSet& active, FaceId f, double own_bound) const;

    // The active faces that refinement has to look at first. One thread at a time.
    std::vector<FaceId> faces_to_test(const ActiveSet& active) const;
    // How often refinement has tested a face, and estimated one.
    std::uint64_t examined_faces() const;

    // Refinement condition (a): the half-edge of the face of h at which that face has to be split;
    // none if it needs no refinement.
    HalfEdgeId needed_split(const ActiveSet& active, HalfEdgeId h) const;
    // Whether a face at e has to be split at e.
    bool needs_refinement(const ActiveSet& active, EdgeId e) const;
    // Decimation condition (a) says nothing about edges by themselves.
    bool passes_decimation(const ActiveSet&, EdgeId) const { return true; }
    // Whether undoing the split of star.m would restore a face with too large a bound or error.
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
    using Face = std::array<VertexId, 3>;

    static Face face_of(const TriMesh& mesh, FaceId f);
    double bound(const Face& face) const;
    ErrorEllipsoid accumulated(const ErrorEllipsoid& error, double own_bound,
                               const Face& face) const;
    bool may_restore(const Face& face, const ErrorEllipsoid& error, bool is_exact) const;

    double tolerance_ = kOff;
    Search search_ = Search::due;
    const Embedding* embedding_ = nullptr;
    std::optional<SplitOrder> order_;
    std::optional<Floor> floor_;
    struct State;
    std::shared_ptr<State> state_;  // null if nothing moves
};

}  // namespace pectin
