// Self-intersections: triangles that pass through each other though the exact surfaces do not.
//
// A warp that does not fold space keeps disjoint surfaces disjoint. The flat triangles between the
// images of their corners may intersect all the same. Where two sheets come closer to each other
// than the surface bulges over a triangle, that triangle may pass through the other sheet. This is
// a sampling error (Gain & Dodgson 1999, section 4, point 1).
//
// An edge intersects a face if it passes through it, shares no corner with it, and was disjoint
// from it at rest. The bulge over an edge shrinks with the square of its length, while the exact
// sheets keep their distance, so refinement resolves every self-intersection. Faces that touched at
// rest are left alone, since refinement cannot separate them.
//
// Sources: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999.
// J. Gain, N. Dodgson. Preventing Self-Intersection under Free-Form Deformation. IEEE Transactions
// on Visualization and Computer Graphics 7 (2001). Section 3: exact images stay disjoint.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapt/criteria.h"
#include "embedding/embedding.h"
#include "geometry/stop_token.h"
#include "mesh/active_set.h"
#include "mesh/face_tree.h"

namespace pectin {

struct SelfIntersection {
    EdgeId edge = kNone<EdgeId>;
    FaceId face = kNone<FaceId>;
    auto operator<=>(const SelfIntersection&) const = default;
};

// The faces outside the active set. Active faces reach beyond the zones of a warp, and may come to
// intersect other faces there.
struct Surroundings {
    // Of all faces of the mesh at rest. Null: the surroundings are not searched.
    const FaceTree* tree = nullptr;
    // Those of the warp. Faces that meet them are active, or stay.
    std::vector<Box> zones{};
    bool are_empty = false;  // all faces are active
};

// Finds self-intersections among the active faces, and between these and their surroundings, at
// their present positions. Holds references to its arguments. Its members throw Stopped where
// `stop` asks for it.
class SelfIntersections {
  public:
    explicit SelfIntersections(const ActiveSet& active, const Surroundings& surroundings = kAlone,
                               const StopToken& stop = kNever)
        : active_(active), surroundings_(surroundings), stop_(stop) {}

    // All self-intersections, sorted, or those found before the search was exhausted. The result
    // does not depend on the number of threads. Cost: the first time O(n + pairs of near faces) if
    // there is a tree of all faces and an eighth of these are active, else O(n log n + pairs), and
    // O(log m) for each active face that has moved and reaches beyond the zones, with m faces in
    // the mesh. Later calls only search again at faces that were edited since, or intersected
    // before.
    const std::vector<SelfIntersection>& find();

    // Whether the faces that would replace the star intersect other faces. Cost: O(log n + near
    // faces), and as much for each edit since the last call; the first time O(n log n).
    bool would_intersect(const Star& star);

    // Whether find() has tested as many pairs of faces with boxes that meet, or nearly do, as it
    // may, over all its calls. If the object is pressed into one sheet, nearly every face is near
    // nearly every other.
    bool is_exhausted() const { return pairs_ >= kMostPairs; }

  private:
    static constexpr std::uint64_t kMostPairs = 40'000'000;  // takes a few seconds
    static constexpr std::uint64_t kTestsBetweenQuestions = 4096;
    static const Surroundings kAlone;
    static const StopToken kNever;

    void ask_whether_to_stop();
    FaceTree& tree();  // of the active faces at their present positions
    void make_tree();
    void mark_active();
    bool has_surroundings() const { return surroundings_.tree && !surroundings_.are_empty; }
    void search_active_faces();
    void test_pair(FaceId f, FaceId g, std::vector<SelfIntersection>& found) const;
    std::vector<FaceId> changed_faces() const;
    void find_near(const Box& box);
    bool reaches_beyond_zones(const Box& box) const;
    void add_pairs_beyond_zones(FaceId f);
    void add_pair(FaceId f, FaceId g);
    bool face_would_intersect(VertexId b, VertexId c, VertexId a, VertexId m);

    const ActiveSet& active_;
    const Surroundings& surroundings_;
    const StopToken& stop_;
    std::uint64_t tests_ = 0;  // since the last question
    std::optional<FaceTree> tree_;
    // How many of the active set's edited faces the tree knows, and how many find() has searched.
    std::size_t synced_upto_ = 0, searched_upto_ = 0;
    // Face slots that are or were active; kept only if there are surroundings.
    std::vector<bool> is_active_;
    std::size_t marked_upto_ = 0;  // this many of the active set's faces are marked there
    std::vector<SelfIntersection> found_;
    bool has_searched_ = false;
    std::uint64_t pairs_ = 0;
    std::vector<FaceId> near_;
};

// The edges to split so that the intersections are resolved. For each intersection, it is the one
// among the edge and the edges of the face whose midpoint is farthest from the warp's image of its
// rest midpoint. Edges below the floor count as having no such distance. There is none for an
// intersection of sheets that were so close at rest that the floor would end the splits before they
// resolved it: they would only leave thin triangles. Sorted, each edge once.
std::vector<EdgeId> edges_to_resolve(const ActiveSet& active, const Embedding& embedding,
                                     const Criteria& criteria,
                                     std::span<const SelfIntersection> intersections);

}  // namespace pectin
