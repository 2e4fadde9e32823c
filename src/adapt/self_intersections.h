// Flat triangles that pass through each other though the surfaces they stand for do not.
//
// A warp that folds nothing keeps apart what is apart. The triangles between the images of their
// corners need not: where sheets come nearer to each other than a triangle bulges, one cuts through
// the other for want of samples. An edge *cuts* a face if it passes through it, shares no corner
// with it, and was apart from it at rest. The bulge shrinks with the square of an edge's length
// while the exact sheets stay as far apart as they are, so refinement mends every cut; what touched
// at rest is left alone, as no refinement parts it.
// Source: the want of samples is that of Gain & Dodgson 1999, section 4; that the exact images stay
// apart, Gain & Dodgson 2001, section 3.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapt/criteria.h"
#include "embedding/embedding.h"
#include "mesh/active_set.h"
#include "mesh/face_tree.h"

namespace pectin {

struct SelfIntersection {
    EdgeId edge = kNone<EdgeId>;
    FaceId face = kNone<FaceId>;
    auto operator<=>(const SelfIntersection&) const = default;
};

// The active faces where they are now, to ask which cut. Holds a reference to the set.
class SelfIntersections {
  public:
    explicit SelfIntersections(const ActiveSet& active) : active_(active) {}

    // Every cut between active faces, in order, or those found until it is exhausted. Cost: the
    // first time O(n log n) and what is near; then only what was edited since, or was cut before,
    // is looked at again.
    const std::vector<SelfIntersection>& find();

    // Whether the faces that would take the place of the star cut others, or those them.
    // Cost: O(log n) and what is near, once more for each edit since; the first time O(n log n).
    bool would_intersect(const Star& star);

    // Whether find() has looked at as many pairs of faces as it may, over all its calls. Where all
    // is pressed into one sheet nearly every face is near nearly every other.
    bool is_exhausted() const { return pairs_ >= kMostPairs; }

  private:
    static constexpr std::uint64_t kMostPairs = 40'000'000;  // some seconds

    FaceTree& tree();  // of the faces as they are now
    std::vector<FaceId> changed_faces() const;
    void add_pair(FaceId f, FaceId g);
    bool face_would_intersect(VertexId b, VertexId c, VertexId a, VertexId m);

    const ActiveSet& active_;
    std::optional<FaceTree> tree_;
    std::size_t synced_upto_ = 0;  // how many of the active set's edited faces the tree knows
    std::vector<SelfIntersection> found_;
    bool has_searched_ = false;
    std::uint64_t pairs_ = 0;
    std::vector<FaceId> near_;
};

// What to split so that the cuts go: of the edge and the face's edges the one whose midpoint is
// farthest from where the warp takes it, those below the floor last. Each once, in order.
std::vector<EdgeId> edges_to_resolve(const ActiveSet& active, const Embedding& embedding,
                                     const Criteria& criteria,
                                     std::span<const SelfIntersection> intersections);

}  // namespace pectin
