#include "mesh/face_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "geometry/parallel.h"
#include "mesh/sort_ids.h"

namespace pectin {
namespace {

constexpr std::uint32_t kNodesAtATime = 2048;  // on one thread
constexpr std::size_t kPairsAtATime = 16384;   // of leaves, in one visit
constexpr std::size_t kFewLeaves = 16;         // one to this many nodes

// The growth of a box when it includes another: half the surface area that it gains.
double growth(const Box& box, const Box& added) {
    const auto half_area = [](const Box& b) {
        const Vec3 e = b.extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    };
    Box grown = box;
    grown.include(added);
    return half_area(grown) - half_area(box);
}

}  // namespace

Box FaceTree::fitted_box(const Node& node, const TriMesh& mesh) const {
    Box box;
    if (node.is_leaf()) {
        const Leaf& leaf = leaves_[node.leaf];
        for (std::uint32_t i = 0; i < leaf.count; ++i) box.include(face_box(leaf.faces[i], mesh));
    } else {
        box.include(nodes_[node.left].box);
        box.include(nodes_[node.right].box);
    }
    return box;
}

int FaceTree::longest_axis(const Box& box) {
    const Vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

std::vector<FaceId> FaceTree::faces_meeting(const Box& box, const TriMesh& mesh) const {
    std::vector<FaceId> answer;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        if (node.box.is_empty() || !node.box.meets(box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.right);
            stack.push_back(node.left);
            continue;
        }
        const Leaf& leaf = leaves_[node.leaf];
        if (box.contains(node.box)) {
            answer.insert(answer.end(), leaf.faces, leaf.faces + leaf.count);
            continue;
        }
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
            const HalfEdgeId h = TriMesh::half_edge(leaf.faces[i], 0);
            if (triangle_meets_box(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)),
                                   mesh.position(mesh.origin(TriMesh::prev(h))), box)) {
                answer.push_back(leaf.faces[i]);
            }
        }
    }
    sort_ids(std::span(answer));
    return answer;
}

void FaceTree::append_near(const Box& box, const TriMesh& mesh, std::vector<FaceId>& faces) const {
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        if (node.box.is_empty() || !node.box.meets(box)) continue;
        if (!node.is_leaf()) {
            stack.push_back(node.right);
            stack.push_back(node.left);
            continue;
        }
        const Leaf& leaf = leaves_[node.leaf];
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
            const FaceId f = leaf.faces[i];
            const bool is_live = index(f) < mesh.face_slots() && mesh.is_live(f);
            if (is_live && face_box(f, mesh).meets(box)) faces.push_back(f);
        }
    }
}

void FaceTree::for_near_leaves(const std::function<bool(std::span<const LeafPair>)>& visit) const {
    std::vector<LeafPair> pairs;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [x, y] = stack.back();
        stack.pop_back();
        const Node &left = nodes_[x], &right = nodes_[y];
        if (left.box.is_empty() || right.box.is_empty() || !left.box.meets(right.box)) continue;
        if (left.is_leaf() && right.is_leaf()) {
            pairs.push_back({left.leaf, right.leaf});
            if (pairs.size() < kPairsAtATime) continue;
            if (!visit(pairs)) return;
            pairs.clear();
        } else if (x == y) {
            stack.insert(
                stack.end(),
                {{left.left, left.left}, {left.left, left.right}, {left.right, left.right}});
        } else if (right.is_leaf() ||
                   (!left.is_leaf() && left.box.diagonal() > right.box.diagonal())) {
            stack.insert(stack.end(), {{left.left, y}, {left.right, y}});
        } else {
            stack.insert(stack.end(), {{x, right.left}, {x, right.right}});
        }
    }
    if (!pairs.empty()) visit(pairs);
}

std::optional<FaceHit> FaceTree::first_hit(const Ray& ray, const TriMesh& mesh) const {
    struct Waiting {
        std::uint32_t node;
        double enter;
    };
    std::optional<FaceHit> first;
    std::vector<Waiting> stack;
    const auto push = [&](std::uint32_t node) {
        if (nodes_[node].box.is_empty()) return;
        const auto inside = intersect(ray, nodes_[node].box);
        if (inside) stack.push_back({node, inside->enter});
    };
    push(0);
    while (!stack.empty()) {
        const Waiting next = stack.back();
        stack.pop_back();
        if (first && next.enter > first->hit.t) continue;
        const Node& node = nodes_[next.node];
        if (!node.is_leaf()) {
            push(node.left);
            push(node.right);
            // Visit the nearer child first: its hit often rules out the other child.
            if (stack.size() >= 2 && stack.back().enter > stack[stack.size() - 2].enter) {
                std::swap(stack.back(), stack[stack.size() - 2]);
            }
            continue;
        }
        const Leaf& leaf = leaves_[node.leaf];
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
            const HalfEdgeId h = TriMesh::half_edge(leaf.faces[i], 0);
            const auto hit =
                intersect(ray, mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)),
                          mesh.position(mesh.origin(TriMesh::prev(h))));
            if (!hit) continue;
            const bool nearer = !first || hit->t < first->hit.t ||
                                (hit->t == first->hit.t && leaf.faces[i] < first->face);
            if (nearer) first = FaceHit{leaf.faces[i], *hit};
        }
    }
    return first;
}

std::optional<FaceId> FaceTree::nearest(const Vec3& point, const TriMesh& mesh) const {
    std::optional<FaceId> found;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        if (node.box.is_empty() || node.box.squared_distance(point) > least) continue;
        if (!node.is_leaf()) {
            const bool left_first = nodes_[node.left].box.squared_distance(point) <
                                    nodes_[node.right].box.squared_distance(point);
            stack.push_back(left_first ? node.right : node.left);
            stack.push_back(left_first ? node.left : node.right);
            continue;
        }
        const Leaf& leaf = leaves_[node.leaf];
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
            const HalfEdgeId h = TriMesh::half_edge(leaf.faces[i], 0);
            const Vec3 there = nearest_on_triangle(point, mesh.position(mesh.origin(h)),
                                                   mesh.position(mesh.target(h)),
                                                   mesh.position(mesh.origin(TriMesh::prev(h))));
            const double squared = glm::dot(there - point, there - point);
            if (found && !(squared < least || (squared == least && leaf.faces[i] < *found))) {
                continue;
            }
            least = squared;
            found = leaf.faces[i];
        }
    }
    return found;
}

void FaceTree::update(std::span<const FaceId> changed, const TriMesh& mesh) {
    if (mesh.face_count() > 2 * built_for_) {
        rebuild(mesh, changed);
        return;
    }
    // An undo may have removed slots. Their faces leave the tree before node_of_face_ shrinks.
    std::vector<FaceId> added;
    std::vector<std::uint32_t> leaves;  // nodes of leaves whose faces have moved or gone
    for (FaceId f : changed) {
        const bool is_there = index(f) < node_of_face_.size() && node_of_face_[index(f)] != kNoNode;
        const bool is_live = index(f) < mesh.face_slots() && mesh.is_live(f);
        if (is_there) leaves.push_back(node_of_face_[index(f)]);
        if (is_there && !is_live) remove(f);
        if (is_live && !is_there) added.push_back(f);
    }
    node_of_face_.resize(mesh.face_slots(), kNoNode);
    refit_leaves(std::move(leaves), mesh);
    for (FaceId f : added) {
        if (node_of_face_[index(f)] == kNoNode) insert(f, mesh);  // it may be listed twice
    }
}

// Refits these leaves, which may be listed several times, and the nodes above them. Walking from
// each leaf to the root is slower than a pass over all nodes if there are many leaves.
void FaceTree::refit_leaves(std::vector<std::uint32_t> leaves, const TriMesh& mesh) {
    if (leaves.size() > nodes_.size() / kFewLeaves) {
        std::vector<std::uint8_t> is_changed(nodes_.size(), 0);
        for (std::uint32_t node : leaves) is_changed[node] = 1;
        refit(std::move(is_changed), mesh);
        return;
    }
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    for (std::uint32_t node : leaves) refit_upwards(node, mesh);
}

void FaceTree::insert(FaceId f, const TriMesh& mesh) {
    const Box box = face_box(f, mesh);
    std::uint32_t node = 0;
    nodes_[node].box.include(box);
    while (!nodes_[node].is_leaf()) {
        const Node& n = nodes_[node];
        const bool go_left = growth(nodes_[n.left].box, box) <= growth(nodes_[n.right].box, box);
        node = go_left ? n.left : n.right;
        nodes_[node].box.include(box);
    }
    Leaf& leaf = leaves_[nodes_[node].leaf];
    if (leaf.count == kLeafFaces) {
        divide_leaf(node, f, mesh);
    } else {
        leaf.faces[leaf.count++] = f;
        node_of_face_[index(f)] = node;
    }
}

// Precondition: f is in the tree. The boxes are not shrunk.
void FaceTree::remove(FaceId f) {
    Leaf& leaf = leaves_[nodes_[node_of_face_[index(f)]].leaf];
    FaceId* const found = std::find(leaf.faces, leaf.faces + leaf.count, f);
    *found = leaf.faces[--leaf.count];
    node_of_face_[index(f)] = kNoNode;
}

void FaceTree::divide_leaf(std::uint32_t node, FaceId extra, const TriMesh& mesh) {
    const std::uint32_t old_leaf = nodes_[node].leaf;
    std::array<FaceCentre, kLeafFaces + 1> faces;
    for (std::uint32_t i = 0; i <= kLeafFaces; ++i) {
        const FaceId f = i < kLeafFaces ? leaves_[old_leaf].faces[i] : extra;
        faces[i] = {f, face_box(f, mesh).centre()};
    }
    const int axis = longest_axis(nodes_[node].box);
    std::sort(faces.begin(), faces.end(), [&](const FaceCentre& x, const FaceCentre& y) {
        return x.centre[axis] < y.centre[axis];
    });
    const std::span<const FaceCentre> all(faces);
    const std::size_t middle = faces.size() / 2;
    const std::uint32_t left = make_leaf(all.first(middle), node, mesh);
    // The second half reuses the leaf of the node, which becomes an inner node.
    const auto right = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_[right].parent = node;
    nodes_[right].leaf = old_leaf;
    leaves_[old_leaf].count = 0;
    for (const FaceCentre& f : all.subspan(middle)) {
        leaves_[old_leaf].faces[leaves_[old_leaf].count++] = f.face;
        node_of_face_[index(f.face)] = right;
    }
    nodes_[right].box = fitted_box(nodes_[right], mesh);
    nodes_[node].leaf = kNoNode;
    nodes_[node].left = left;
    nodes_[node].right = right;
}

void FaceTree::refit_upwards(std::uint32_t node, const TriMesh& mesh) {
    while (node != kNoNode) {
        const Box box = fitted_box(nodes_[node], mesh);
        if (box == nodes_[node].box) return;
        nodes_[node].box = box;
        node = nodes_[node].parent;
    }
}

void FaceTree::refit_all(const TriMesh& mesh) {
    refit(std::vector<std::uint8_t>(nodes_.size(), 1), mesh);
}

// Refits the nodes that have changed and those above them. The leaves on all threads, since most of
// the time goes there.
void FaceTree::refit(std::vector<std::uint8_t> is_changed, const TriMesh& mesh) {
    const auto refit_leaves = [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            if (nodes_[i].is_leaf() && is_changed[i] != 0)
                nodes_[i].box = fitted_box(nodes_[i], mesh);
        }
    };
    for_pieces(0, static_cast<std::uint32_t>(nodes_.size()), refit_leaves, kNodesAtATime);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        if (nodes_[i].is_leaf()) continue;
        if (is_changed[nodes_[i].left] == 0 && is_changed[nodes_[i].right] == 0) continue;
        is_changed[i] = 1;
        nodes_[i].box = fitted_box(nodes_[i], mesh);
    }
}

std::size_t FaceTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf) +
           node_of_face_.capacity() * sizeof(std::uint32_t);
}

}  // namespace pectin
