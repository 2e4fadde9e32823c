// A bounding-box tree over the faces of a mesh, for box, ray and nearest-face queries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/ray.h"
#include "geometry/stop_token.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// The intersection of a ray with a face.
struct FaceHit {
    FaceId face = kNone<FaceId>;
    RayHit hit;  // barycentric coordinates refer to the face's corners in order
};

// Leaves hold up to kLeafFaces faces. The tree is built by median cuts, refitted where faces
// change, and rebuilt when the mesh has twice as many faces as it was built for. Results are sorted
// by id and do not depend on the tree's history, except those that are documented to be in the
// tree's order.
class FaceTree {
  public:
    // Throws Stopped where `stop` asks for it. Cost: O(n log n).
    explicit FaceTree(const TriMesh& mesh, const StopToken& stop = {});
    // Contains only these faces, each listed once; update() adds the faces it is given. Cost:
    // O(k log k) time, and one word per face slot.
    FaceTree(const TriMesh& mesh, std::span<const FaceId> faces);
    // Contains those of these faces that the other tree, of the same mesh, contains, in the same
    // order. Cost: O(n) in the size of the other tree, which is much less than building one.
    FaceTree(const FaceTree& other, const TriMesh& mesh, std::span<const FaceId> faces);

    // The live faces that have a point in common with `box`, sorted by id.
    // Cost: O(answer + log n).
    std::vector<FaceId> faces_meeting(const Box& box, const TriMesh& mesh) const;

    // Appends the live faces whose boxes meet `box`, in the tree's order. If faces have moved since
    // the last update, the answer is right only as to the others. Cost: O(answer + log n).
    void append_near(const Box& box, const TriMesh& mesh, std::vector<FaceId>& faces) const;
    // Calls visit() with the pairs of leaves whose boxes meet, each once, and each leaf with
    // itself, until it returns false. Each call gets some thousand pairs, in an order that depends
    // on the tree's history. Cost: O(pairs + n).
    struct LeafPair {
        std::uint32_t first, second;
    };
    void for_near_leaves(const std::function<bool(std::span<const LeafPair>)>& visit) const;

    // The live face that the ray meets first; at equal distances the one with the lowest id.
    // Cost: O(log n) for a ray that meets few boxes.
    std::optional<FaceHit> first_hit(const Ray& ray, const TriMesh& mesh) const;

    // The live face nearest to the point; at equal distances the one with the lowest id. None if
    // there are no faces. Cost: O(log n) near the surface.
    std::optional<FaceId> nearest(const Vec3& point, const TriMesh& mesh) const;

    // Must be called with every slot whose face has moved, been added or been removed.
    // Cost: O(k log n), at most O(k + n); O(n log n) when the tree is rebuilt.
    void update(std::span<const FaceId> changed, const TriMesh& mesh);

    std::size_t memory_bytes() const;

    // What LeafBoxes (leaf_boxes.h) needs to find the near faces of such leaves.
    static constexpr std::uint32_t kLeafFaces = 16;
    struct Leaf {
        std::uint32_t count = 0;
        FaceId faces[kLeafFaces] = {};
    };
    std::span<const Leaf> leaves() const { return leaves_; }
    // A box that contains all faces; empty if there are none.
    const Box& box() const { return nodes_.front().box; }

  private:
    static constexpr std::uint32_t kNoNode = 0xffffffffu;

    struct Node {
        Box box;
        std::uint32_t parent = kNoNode;
        std::uint32_t left = kNoNode, right = kNoNode;  // none in a leaf
        std::uint32_t leaf = kNoNode;                   // index into leaves_; none in an inner node
        bool is_leaf() const { return leaf != kNoNode; }
    };
    struct FaceCentre {
        FaceId face = kNone<FaceId>;
        Vec3 centre;  // of its box
    };

    static Box face_box(FaceId f, const TriMesh& mesh);
    static int longest_axis(const Box& box);
    void build(const TriMesh& mesh, std::span<const FaceId> faces, const StopToken& stop = {});
    std::uint32_t build_node(std::span<FaceCentre> faces, std::uint32_t parent, const TriMesh& mesh,
                             const StopToken& stop);
    void rebuild(const TriMesh& mesh, std::span<const FaceId> changed);
    std::uint32_t make_leaf(std::span<const FaceCentre> faces, std::uint32_t parent,
                            const TriMesh& mesh);
    void insert(FaceId f, const TriMesh& mesh);
    void remove(FaceId f);
    void divide_leaf(std::uint32_t node, FaceId extra, const TriMesh& mesh);
    void refit_leaves(std::vector<std::uint32_t> leaves, const TriMesh& mesh);
    void refit_upwards(std::uint32_t node, const TriMesh& mesh);
    void refit_all(const TriMesh& mesh);
    void refit(std::vector<std::uint8_t> is_changed, const TriMesh& mesh);
    void copy_part(const FaceTree& other, const std::vector<std::uint32_t>& counts,
                   const std::vector<bool>& is_wanted);
    Box fitted_box(const Node& node, const TriMesh& mesh) const;

    std::vector<Node> nodes_;  // children after their parent; the root first
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> node_of_face_;  // n_face_slots; kNoNode where not in the tree
    std::uint32_t built_for_ = 0;              // face count at the last build
};

inline Box FaceTree::face_box(FaceId f, const TriMesh& mesh) {
    Box box;
    for (int corner = 0; corner < 3; ++corner) {
        box.include(mesh.position(mesh.origin(TriMesh::half_edge(f, corner))));
    }
    return box;
}

}  // namespace pectin
