// A tree of boxes over the faces of a mesh: which faces meet a box, without looking at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/ray.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Where a ray meets a face.
struct FaceHit {
    FaceId face = kNone<FaceId>;
    RayHit hit;  // barycentric over the face's half-edges' origins, in order
};

// Leaves hold up to kLeafFaces faces. Built by median cuts; kept up by refitting what changed,
// and built anew once the mesh has grown to twice the size it was built for. Answers are sorted
// by id, so they do not depend on the tree's own history, but for those in the tree's order.
class FaceTree {
  public:
    explicit FaceTree(const TriMesh& mesh);  // O(n log n)
    // Of these faces alone, each once; `update` adds what it is told of. O(k log k), and a word a
    // face slot.
    FaceTree(const TriMesh& mesh, std::span<const FaceId> faces);

    // The live faces that have a point in common with `box`, sorted by id.
    // Cost: O(answer + log n).
    std::vector<FaceId> faces_meeting(const Box& box, const TriMesh& mesh) const;

    // Its faces whose boxes meet `box`, appended, in the tree's order. Cost: O(answer + log n).
    void append_near(const Box& box, const TriMesh& mesh, std::vector<FaceId>& faces) const;
    // visit(f, g): every two of its faces whose boxes meet, each pair once, in the tree's order,
    // until it returns false. Cost: O(visits + n).
    void for_near_pairs(const TriMesh& mesh,
                        const std::function<bool(FaceId, FaceId)>& visit) const;

    // The live face that the ray meets first, of those at one distance the one with the lowest id.
    // Cost: O(log n) for a ray that meets little.
    std::optional<FaceHit> first_hit(const Ray& ray, const TriMesh& mesh) const;

    // The live face nearest to the point, of those at one distance the one with the lowest id;
    // none without faces. Cost: O(log n) near the surface.
    std::optional<FaceId> nearest(const Vec3& point, const TriMesh& mesh) const;

    // To be told of every slot whose face moved, came or went. Cost: O(k log n), at most O(n); O(n
    // log n) where it is built anew.
    void update(std::span<const FaceId> changed, const TriMesh& mesh);

    std::size_t memory_bytes() const;

  private:
    static constexpr std::uint32_t kLeafFaces = 16;
    static constexpr std::uint32_t kNoNode = 0xffffffffu;

    struct Node {
        Box box;
        std::uint32_t parent = kNoNode;
        std::uint32_t left = kNoNode, right = kNoNode;  // none in a leaf
        std::uint32_t leaf = kNoNode;                   // into leaves_, none in an inner node
        bool is_leaf() const { return leaf != kNoNode; }
    };
    struct Leaf {
        std::uint32_t count = 0;
        FaceId faces[kLeafFaces] = {};
    };

    struct FaceCentre {
        FaceId face = kNone<FaceId>;
        Vec3 centre;  // of its box
    };

    void build(const TriMesh& mesh, std::span<const FaceId> faces);
    std::uint32_t build_node(std::span<FaceCentre> faces, std::uint32_t parent,
                             const TriMesh& mesh);
    void rebuild(const TriMesh& mesh, std::span<const FaceId> changed);
    std::uint32_t make_leaf(std::span<const FaceCentre> faces, std::uint32_t parent,
                            const TriMesh& mesh);
    void insert(FaceId f, const TriMesh& mesh);
    void remove(FaceId f);
    void divide_leaf(std::uint32_t node, FaceId extra, const TriMesh& mesh);
    void refit_upwards(std::uint32_t node, const TriMesh& mesh);
    void refit_all(const TriMesh& mesh);
    Box fitted_box(const Node& node, const TriMesh& mesh) const;

    std::vector<Node> nodes_;  // children after their parent; the root first
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> node_of_face_;  // n_face_slots; kNoNode where not in the tree
    std::uint32_t built_for_ = 0;              // faces of the mesh then
};

}  // namespace pectin
