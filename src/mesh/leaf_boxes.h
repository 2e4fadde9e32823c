// The boxes of the faces in the leaves of a face tree, for the search of pairs of near faces.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/box.h"
#include "mesh/face_tree.h"
#include "mesh/growing_array.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Coordinates are rounded to integers, relative to the box of the whole tree. Rounding preserves
// their order, so boxes that meet still do; a few others may seem to. Integers can be compared
// faster than floating-point numbers, several at a time. Holds a reference to the tree, which must
// not change.
class LeafBoxes {
  public:
    // Cost: O(n), on all threads.
    LeafBoxes(const FaceTree& tree, const TriMesh& mesh);

    // Calls visit(f, g) for each pair of faces from these leaves whose boxes meet, once per pair.
    template <typename Visit>
    void for_near_pairs(const FaceTree::LeafPair& pair, Visit visit) const;

  private:
    static constexpr std::uint32_t kFaces = FaceTree::kLeafFaces;
    using Mask = std::uint32_t;  // bit i stands for face i of a leaf
    static constexpr std::array<Mask, kFaces> kBits = [] {
        std::array<Mask, kFaces> bits{};
        for (std::uint32_t i = 0; i < kFaces; ++i) bits[i] = Mask{1} << i;
        return bits;
    }();
    // Coordinates are in [0, kSteps], so their differences fit into 32 bits.
    static constexpr std::int32_t kSteps = 1 << 30;
    using Point = std::array<std::int32_t, 3>;
    using Bounds = std::array<std::int32_t, kFaces>;

    struct Corners {
        Point min, max;
    };
    struct Boxes {
        std::array<Bounds, 3> min, max;  // of each axis and face; empty boxes where no face is
        Corners all;                     // encloses them
    };

    Point rounded(const Vec3& point) const {
        // Halves of coordinates, since differences of the largest ones are not finite.
        // The order of the arguments makes 0 of what is not a number.
        const Vec3 at =
            glm::min(Vec3{double{kSteps}}, glm::max(Vec3{0.0}, (0.5 * point - origin_) * scale_));
        return {static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y),
                static_cast<std::int32_t>(at.z)};
    }
    void fill(Boxes& boxes, const FaceTree::Leaf& leaf, const TriMesh& mesh) const;
    static Mask meeting(const Boxes& boxes, const Corners& box);
    static Corners box(const Boxes& boxes, std::uint32_t face);

    std::span<const FaceTree::Leaf> leaves_;
    Vec3 origin_{0.0}, scale_{0.0};
    GrowingArray<Boxes> boxes_;  // of each leaf
};

// Without branches and in 32 bits, so that compilers turn the loop into vector instructions. A
// difference is negative where the boxes are apart along an axis.
inline LeafBoxes::Mask LeafBoxes::meeting(const Boxes& boxes, const Corners& box) {
    Mask mask = 0;
    for (std::size_t i = 0; i < kFaces; ++i) {
        const std::int32_t signs = (box.max[0] - boxes.min[0][i]) | (boxes.max[0][i] - box.min[0]) |
                                   (box.max[1] - boxes.min[1][i]) | (boxes.max[1][i] - box.min[1]) |
                                   (box.max[2] - boxes.min[2][i]) | (boxes.max[2][i] - box.min[2]);
        mask |= kBits[i] & ~static_cast<Mask>(signs >> 31);
    }
    return mask;
}

inline LeafBoxes::Corners LeafBoxes::box(const Boxes& boxes, std::uint32_t face) {
    Corners corners;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        corners.min[axis] = boxes.min[axis][face];
        corners.max[axis] = boxes.max[axis][face];
    }
    return corners;
}

template <typename Visit>
void LeafBoxes::for_near_pairs(const FaceTree::LeafPair& pair, Visit visit) const {
    const bool is_same = pair.first == pair.second;
    const Boxes &left = boxes_[pair.first], &right = boxes_[pair.second];
    const Mask from_right = meeting(right, left.all);
    if (from_right == 0) return;
    for (Mask rest = meeting(left, right.all); rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        // In one leaf, each pair once.
        const Mask wanted = is_same ? from_right & ~((Mask{2} << i) - 1) : from_right;
        for (Mask near = meeting(right, box(left, i)) & wanted; near != 0; near &= near - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(near));
            visit(leaves_[pair.first].faces[i], leaves_[pair.second].faces[j]);
        }
    }
}

}  // namespace pectin
