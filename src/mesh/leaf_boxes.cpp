#include "mesh/leaf_boxes.h"

#include <algorithm>

#include "geometry/parallel.h"

namespace pectin {
namespace {

constexpr std::uint32_t kLeavesAtATime = 1024;  // on one thread
constexpr double kLeastExtent = 1e-290;         // a smaller one is taken as 0

}  // namespace

LeafBoxes::LeafBoxes(const FaceTree& tree, const TriMesh& mesh) : leaves_(tree.leaves()) {
    const Box box = tree.box();
    if (!box.is_empty()) {
        origin_ = 0.5 * box.min;
        const Vec3 extent = 0.5 * box.max - origin_;
        for (int axis = 0; axis < 3; ++axis) {
            if (extent[axis] > kLeastExtent) scale_[axis] = double{kSteps} / extent[axis];
        }
    }
    boxes_.grow(leaves_.size());
    for_pieces(
        0, static_cast<std::uint32_t>(leaves_.size()),
        [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) fill(boxes_[i], leaves_[i], mesh);
        },
        kLeavesAtATime);
}

void LeafBoxes::fill(Boxes& boxes, const FaceTree::Leaf& leaf, const TriMesh& mesh) const {
    constexpr std::int32_t kAbove = kSteps + 1, kBelow = -1;
    for (Bounds& bounds : boxes.min) bounds.fill(kAbove);
    for (Bounds& bounds : boxes.max) bounds.fill(kBelow);
    boxes.all.min.fill(kAbove);
    boxes.all.max.fill(kBelow);
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const VertexId v = mesh.origin(TriMesh::half_edge(leaf.faces[i], corner));
            const Point at = rounded(mesh.position(v));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                boxes.min[axis][i] = std::min(boxes.min[axis][i], at[axis]);
                boxes.max[axis][i] = std::max(boxes.max[axis][i], at[axis]);
                boxes.all.min[axis] = std::min(boxes.all.min[axis], at[axis]);
                boxes.all.max[axis] = std::max(boxes.all.max[axis], at[axis]);
            }
        }
    }
}

}  // namespace pectin
