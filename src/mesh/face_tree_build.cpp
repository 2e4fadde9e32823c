// How a FaceTree is made: built from faces, or copied in part from another tree.
#include <algorithm>

#include "mesh/face_tree.h"

namespace pectin {
namespace {

constexpr std::size_t kFacesBetweenQuestions = 4096;  // whether to stop

}  // namespace

FaceTree::FaceTree(const TriMesh& mesh, const StopToken& stop) {
    std::vector<FaceId> faces;
    faces.reserve(mesh.face_count());
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    build(mesh, faces, stop);
}

FaceTree::FaceTree(const TriMesh& mesh, std::span<const FaceId> faces) { build(mesh, faces); }

FaceTree::FaceTree(const FaceTree& other, const TriMesh& mesh, std::span<const FaceId> faces)
    : node_of_face_(mesh.face_slots(), kNoNode), built_for_(mesh.face_count()) {
    std::vector<bool> is_wanted(mesh.face_slots(), false);
    for (FaceId f : faces) is_wanted[index(f)] = true;
    // How many wanted faces are below each node. Children come after their parent.
    std::vector<std::uint32_t> counts(other.nodes_.size(), 0);
    std::uint32_t all = 0;
    for (std::size_t i = other.nodes_.size(); i-- > 0;) {
        const Node& node = other.nodes_[i];
        if (node.is_leaf()) {
            const Leaf& leaf = other.leaves_[node.leaf];
            all += leaf.count;
            counts[i] = static_cast<std::uint32_t>(std::count_if(
                leaf.faces, leaf.faces + leaf.count,
                [&](FaceId f) { return index(f) < is_wanted.size() && is_wanted[index(f)]; }));
        }
        if (node.parent != kNoNode) counts[node.parent] += counts[i];
    }
    if (counts.front() == all) {
        nodes_ = other.nodes_;
        leaves_ = other.leaves_;
        node_of_face_ = other.node_of_face_;
        node_of_face_.resize(mesh.face_slots(), kNoNode);
    } else {
        copy_part(other, counts, is_wanted);
    }
    refit_all(mesh);
}

// Copies the nodes with wanted faces. A node of which only one child has any is left out.
void FaceTree::copy_part(const FaceTree& other, const std::vector<std::uint32_t>& counts,
                         const std::vector<bool>& is_wanted) {
    struct Copy {
        std::uint32_t from, parent;
        bool is_left;
    };
    std::vector<Copy> stack{{0, kNoNode, false}};
    while (!stack.empty()) {
        const Copy next = stack.back();
        stack.pop_back();
        std::uint32_t from = next.from;
        while (!other.nodes_[from].is_leaf()) {
            const Node& node = other.nodes_[from];
            if (counts[node.left] > 0 && counts[node.right] > 0) break;
            from = counts[node.left] > 0 ? node.left : node.right;
        }
        const auto to = static_cast<std::uint32_t>(nodes_.size());
        Node& made = nodes_.emplace_back();
        made.parent = next.parent;
        if (next.parent != kNoNode)
            (next.is_left ? nodes_[next.parent].left : nodes_[next.parent].right) = to;
        const Node& node = other.nodes_[from];
        if (!node.is_leaf()) {
            stack.push_back({node.right, to, false});
            stack.push_back({node.left, to, true});
            continue;
        }
        made.leaf = static_cast<std::uint32_t>(leaves_.size());
        Leaf& leaf = leaves_.emplace_back();
        const Leaf& all = other.leaves_[node.leaf];
        for (std::uint32_t i = 0; i < all.count; ++i) {
            const FaceId f = all.faces[i];
            if (index(f) >= is_wanted.size() || !is_wanted[index(f)]) continue;
            leaf.faces[leaf.count++] = f;
            node_of_face_[index(f)] = to;
        }
    }
}

void FaceTree::build(const TriMesh& mesh, std::span<const FaceId> faces, const StopToken& stop) {
    nodes_.clear();
    leaves_.clear();
    node_of_face_.assign(mesh.face_slots(), kNoNode);
    built_for_ = mesh.face_count();
    std::vector<FaceCentre> centres;
    centres.reserve(faces.size());
    for (FaceId f : faces) centres.push_back({f, face_box(f, mesh).centre()});
    build_node(centres, kNoNode, mesh, stop);
}

// Rebuilds the tree with the faces it holds and those of `changed` that are new to it.
void FaceTree::rebuild(const TriMesh& mesh, std::span<const FaceId> changed) {
    node_of_face_.resize(mesh.face_slots(), kNoNode);
    for (FaceId f : changed) {
        if (index(f) < mesh.face_slots()) node_of_face_[index(f)] = 0;
    }
    std::vector<FaceId> faces;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (node_of_face_[i] != kNoNode && mesh.is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    build(mesh, faces);
}

std::uint32_t FaceTree::build_node(std::span<FaceCentre> faces, std::uint32_t parent,
                                   const TriMesh& mesh, const StopToken& stop) {
    if (faces.size() > kFacesBetweenQuestions) stop.throw_if_requested();
    // Leaves are filled to three quarters, so that refinement does not divide all of them at once.
    if (faces.size() <= kLeafFaces * 3 / 4) return make_leaf(faces, parent, mesh);
    Box spread;
    for (const FaceCentre& f : faces) spread.include(f.centre);
    const int axis = longest_axis(spread);
    const std::size_t middle = faces.size() / 2;
    std::nth_element(
        faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(middle), faces.end(),
        [&](const FaceCentre& x, const FaceCentre& y) { return x.centre[axis] < y.centre[axis]; });
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_[node].parent = parent;
    const std::uint32_t left = build_node(faces.first(middle), node, mesh, stop);
    const std::uint32_t right = build_node(faces.subspan(middle), node, mesh, stop);
    nodes_[node].left = left;
    nodes_[node].right = right;
    nodes_[node].box = fitted_box(nodes_[node], mesh);
    return node;
}

std::uint32_t FaceTree::make_leaf(std::span<const FaceCentre> faces, std::uint32_t parent,
                                  const TriMesh& mesh) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_[node].parent = parent;
    nodes_[node].leaf = static_cast<std::uint32_t>(leaves_.size());
    Leaf& leaf = leaves_.emplace_back();
    for (const FaceCentre& f : faces) {
        leaf.faces[leaf.count++] = f.face;
        node_of_face_[index(f.face)] = node;
    }
    nodes_[node].box = fitted_box(nodes_[node], mesh);
    return node;
}

}  // namespace pectin
