#include "adapt/self_intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <span>
#include <unordered_map>
#include <utility>

#include "geometry/parallel.h"
#include "geometry/piercing.h"
#include "mesh/leaf_boxes.h"
#include "mesh/sort_ids.h"

namespace pectin {
namespace {

// An edge and a face closer than this at rest, as a fraction of the edge's length, touch.
// Boundaries may lie along each other without sharing vertices, and rounding must not count as
// distance.
constexpr double kTouchingFraction = 1e-9;
// The most pairs of an active and another face that are tested; this takes half a second.
constexpr std::uint64_t kMostPairsWithOthers = 4'000'000;
constexpr std::uint64_t kPairsBetweenQuestions = 4096;
// If more than one in this many faces was edited, a new tree is better than an updated one.
constexpr std::size_t kRebuildDivisor = 8;
// If at least one in this many faces is active, a part of the mesh's tree is faster copied than
// built.
constexpr std::size_t kCopyDivisor = 8;
constexpr std::uint32_t kLeavesAtATime = 512;  // pairs of leaves, on one thread

using Corners = std::array<VertexId, 3>;

Corners corners_of(const TriMesh& mesh, FaceId f) {
    const HalfEdgeId h = TriMesh::half_edge(f, 0);
    return {mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h))};
}

bool has(const Corners& corners, VertexId v) {
    return corners[0] == v || corners[1] == v || corners[2] == v;
}

bool is_live(const TriMesh& mesh, FaceId f) {
    return index(f) < mesh.face_slots() && mesh.is_live(f);
}

// The live ones among the faces, sorted, each once.
std::vector<FaceId> live(const TriMesh& mesh, std::vector<FaceId> faces) {
    std::erase_if(faces, [&](FaceId f) { return !is_live(mesh, f); });
    sort_ids(std::span(faces));
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

Box box_of(const TriMesh& mesh, const Corners& face) {
    Box box;
    for (VertexId v : face) box.include(mesh.position(v));
    return box;
}

Box box_of(const TriMesh& mesh, std::span<const FaceId> faces) {
    Box box;
    for (FaceId f : faces) box.include(box_of(mesh, corners_of(mesh, f)));
    return box;
}

// The faces whose boxes meet `box`.
std::vector<FaceId> faces_in(const TriMesh& mesh, std::vector<FaceId> faces, const Box& box) {
    std::erase_if(faces, [&](FaceId f) { return !box_of(mesh, corners_of(mesh, f)).meets(box); });
    return faces;
}

bool has_moved(const ActiveSet& active, FaceId f) {
    return std::ranges::any_of(corners_of(active.mesh(), f), [&](VertexId v) {
        return active.mesh().position(v) != active.rest_position(v);
    });
}

std::vector<FaceId> moved_faces(const ActiveSet& active) {
    std::vector<FaceId> faces = live(active.mesh(), {active.faces().begin(), active.faces().end()});
    std::erase_if(faces, [&](FaceId f) { return !has_moved(active, f); });
    return faces;
}

// The live ones of the faces, and the faces that edits have made of them or of their siblings.
std::vector<FaceId> with_descendants(const ActiveSet& active, std::span<const FaceId> faces) {
    const TriMesh& mesh = active.mesh();
    std::vector<FaceId> all = live(mesh, {faces.begin(), faces.end()});
    std::vector<FaceId> bases;
    for (FaceId f : all) bases.push_back(mesh.base_face(f));
    std::ranges::sort(bases);
    for (FaceId f : active.edited_faces()) {
        if (is_live(mesh, f) && !has_moved(active, f) &&
            std::ranges::binary_search(bases, mesh.base_face(f))) {
            all.push_back(f);
        }
    }
    return live(mesh, std::move(all));
}

double rest_distance(const ActiveSet& active, VertexId p, VertexId q, const Corners& face) {
    return std::sqrt(squared_distance(active.rest_position(p), active.rest_position(q),
                                      active.rest_position(face[0]), active.rest_position(face[1]),
                                      active.rest_position(face[2])));
}

double rest_distance(const ActiveSet& active, const SelfIntersection& intersection) {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId h = mesh.half_edge(intersection.edge);
    return rest_distance(active, mesh.origin(h), mesh.target(h),
                         corners_of(mesh, intersection.face));
}

bool were_disjoint(const ActiveSet& active, VertexId p, VertexId q, const Corners& face) {
    const double length = glm::distance(active.rest_position(p), active.rest_position(q));
    return rest_distance(active, p, q, face) > kTouchingFraction * length;
}

bool passes_through(const TriMesh& mesh, VertexId p, VertexId q, const Corners& face) {
    return !has(face, p) && !has(face, q) &&
           pierces(mesh.position(p), mesh.position(q), mesh.position(face[0]),
                   mesh.position(face[1]), mesh.position(face[2]));
}

// Whether all corners of g lie on one side of the plane of f, or on it.
bool is_on_one_side(const TriMesh& mesh, const Corners& f, const Corners& g) {
    const Vec3& at = mesh.position(f[0]);
    const Vec3 normal = glm::cross(mesh.position(f[1]) - at, mesh.position(f[2]) - at);
    double least = 0.0, greatest = 0.0;
    for (VertexId v : g) {
        // A shared corner lies in the plane, whatever rounding says.
        const double height = has(f, v) ? 0.0 : glm::dot(normal, mesh.position(v) - at);
        least = std::min(least, height);
        greatest = std::max(greatest, height);
    }
    return least >= 0.0 || greatest <= 0.0;
}

bool may_intersect(const TriMesh& mesh, const Corners& f, const Corners& g) {
    return !is_on_one_side(mesh, f, g) && !is_on_one_side(mesh, g, f);
}

// Whether an edge of one face passes through the other, from which it was disjoint at rest.
bool intersect_newly(const ActiveSet& active, const Corners& f, const Corners& g) {
    const TriMesh& mesh = active.mesh();
    if (has(f, g[0]) || has(f, g[1]) || has(f, g[2]) || !may_intersect(mesh, f, g)) return false;
    const auto any_edge_passes = [&](const Corners& edges, const Corners& face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const VertexId p = edges[corner], q = edges[(corner + 1) % 3];
            if (passes_through(mesh, p, q, face) && were_disjoint(active, p, q, face)) return true;
        }
        return false;
    };
    return any_edge_passes(f, g) || any_edge_passes(g, f);
}

template <typename Visit>
void for_each_edge(FaceId f, Visit visit) {
    for (int corner = 0; corner < 3; ++corner) visit(TriMesh::half_edge(f, corner));
}

}  // namespace

const Surroundings SelfIntersections::kAlone{};
const StopToken SelfIntersections::kNever{};

void SelfIntersections::ask_whether_to_stop() {
    if (++tests_ % kTestsBetweenQuestions == 0) stop_.throw_if_requested();
}

FaceTree& SelfIntersections::tree() {
    const auto edited = active_.edited_faces();
    if (!tree_ || kRebuildDivisor * (edited.size() - synced_upto_) > active_.faces().size()) {
        make_tree();
    } else {
        tree_->update(edited.subspan(synced_upto_), active_.mesh());
    }
    synced_upto_ = edited.size();
    if (has_surroundings()) mark_active();
    return *tree_;
}

// If much of the mesh is active and few faces are new, its tree has nearly all of the new one.
void SelfIntersections::make_tree() {
    const TriMesh& mesh = active_.mesh();
    const auto edited = active_.edited_faces();
    const std::vector<FaceId> faces = live(mesh, {active_.faces().begin(), active_.faces().end()});
    const bool has_most = surroundings_.tree && kRebuildDivisor * edited.size() <= faces.size() &&
                          kCopyDivisor * faces.size() >= mesh.face_count();
    if (has_most) {
        tree_.emplace(*surroundings_.tree, mesh, faces);
        tree_->update(edited, mesh);
    } else {
        tree_.emplace(mesh, faces);
    }
}

void SelfIntersections::mark_active() {
    const std::span<const FaceId> faces = active_.faces();
    is_active_.resize(std::max<std::size_t>(is_active_.size(), active_.mesh().face_slots()));
    for (; marked_upto_ < faces.size(); ++marked_upto_) {
        const std::size_t slot = index(faces[marked_upto_]);
        if (slot < is_active_.size()) is_active_[slot] = true;
    }
}

// Sets near_ to the faces whose boxes meet `box`.
void SelfIntersections::find_near(const Box& box) {
    const TriMesh& mesh = active_.mesh();
    near_.clear();
    tree().append_near(box, mesh, near_);
    if (!reaches_beyond_zones(box)) return;
    const std::size_t active = near_.size();
    surroundings_.tree->append_near(box, mesh, near_);
    const auto first_beyond = near_.begin() + static_cast<std::ptrdiff_t>(active);
    near_.erase(
        std::remove_if(first_beyond, near_.end(), [&](FaceId f) { return is_active_[index(f)]; }),
        near_.end());
}

bool SelfIntersections::reaches_beyond_zones(const Box& box) const {
    return has_surroundings() && std::ranges::none_of(surroundings_.zones, [&](const Box& zone) {
               return zone.contains(box.min) && zone.contains(box.max);
           });
}

void SelfIntersections::add_pairs_beyond_zones(FaceId f) {
    const TriMesh& mesh = active_.mesh();
    const Box box = box_of(mesh, corners_of(mesh, f));
    if (!reaches_beyond_zones(box) || !has_moved(active_, f)) return;
    near_.clear();
    surroundings_.tree->append_near(box, mesh, near_);
    for (FaceId g : near_) {
        if (is_exhausted()) return;
        if (!is_active_[index(g)]) add_pair(f, g);
    }
}

const std::vector<SelfIntersection>& SelfIntersections::find() {
    const TriMesh& mesh = active_.mesh();
    if (!has_searched_) {
        search_active_faces();
        if (has_surroundings()) {
            for (FaceId f : live(mesh, {active_.faces().begin(), active_.faces().end()})) {
                add_pairs_beyond_zones(f);
            }
        }
        has_searched_ = true;
    } else {
        const std::vector<FaceId> changed = changed_faces();
        found_.clear();
        for (FaceId f : changed) {
            if (is_exhausted()) break;
            find_near(box_of(mesh, corners_of(mesh, f)));
            for (FaceId g : near_) {
                if (f != g) add_pair(f, g);
            }
        }
    }
    searched_upto_ = active_.edited_faces().size();
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return found_;
}

void SelfIntersections::search_active_faces() {
    const FaceTree& faces = tree();
    const LeafBoxes boxes(faces, active_.mesh());
    std::mutex mutex;
    faces.for_near_leaves([&](std::span<const FaceTree::LeafPair> leaves) {
        stop_.throw_if_requested();
        const auto search = [&](std::uint32_t first, std::uint32_t end) {
            std::vector<SelfIntersection> found;
            std::uint64_t pairs = 0;
            for (std::uint32_t i = first; i < end; ++i) {
                boxes.for_near_pairs(leaves[i], [&](FaceId f, FaceId g) {
                    ++pairs;
                    test_pair(f, g, found);
                });
            }
            const std::scoped_lock lock(mutex);
            pairs_ += pairs;
            found_.insert(found_.end(), found.begin(), found.end());
        };
        for_pieces(0, static_cast<std::uint32_t>(leaves.size()), search, kLeavesAtATime);
        return !is_exhausted();
    });
}

// The faces that were edited since the last search or intersected then.
std::vector<FaceId> SelfIntersections::changed_faces() const {
    const TriMesh& mesh = active_.mesh();
    const auto edited = active_.edited_faces().subspan(searched_upto_);
    std::vector<FaceId> faces(edited.begin(), edited.end());
    for (const SelfIntersection& intersection : found_) faces.push_back(intersection.face);
    return live(mesh, std::move(faces));
}

void SelfIntersections::add_pair(FaceId f, FaceId g) {
    ++pairs_;
    ask_whether_to_stop();
    test_pair(f, g, found_);
}

void SelfIntersections::test_pair(FaceId f, FaceId g, std::vector<SelfIntersection>& found) const {
    const TriMesh& mesh = active_.mesh();
    const Corners of_f = corners_of(mesh, f), of_g = corners_of(mesh, g);
    // Each edge of one of two faces with a common edge has a corner of the other face.
    const int shared =
        (has(of_f, of_g[0]) ? 1 : 0) + (has(of_f, of_g[1]) ? 1 : 0) + (has(of_f, of_g[2]) ? 1 : 0);
    if (shared >= 2 || active_.stays(f) || active_.stays(g) || !may_intersect(mesh, of_f, of_g))
        return;
    const auto add = [&](FaceId through, const Corners& face) {
        return [&, through](HalfEdgeId h) {
            const VertexId p = mesh.origin(h), q = mesh.target(h);
            if (passes_through(mesh, p, q, face) && were_disjoint(active_, p, q, face)) {
                found.push_back({mesh.edge(h), through});
            }
        };
    };
    for_each_edge(f, add(g, of_g));
    for_each_edge(g, add(f, of_f));
}

bool SelfIntersections::would_intersect(const Star& star) {
    bool any = false;
    active_.mesh().for_each_sheet(star, [&](const Star& sheet) {
        any = any || face_would_intersect(sheet.b, sheet.c, sheet.a, star.m) ||
              (!sheet.on_boundary() && face_would_intersect(sheet.b, sheet.c, sheet.d, star.m));
    });
    return any;
}

// Tests the restored face bca, whose edge bc is new, against all faces outside the star. An edge
// that touched both the restored face and one of the star's faces at rest does not count, since
// keeping m would not separate them.
bool SelfIntersections::face_would_intersect(VertexId b, VertexId c, VertexId a, VertexId m) {
    const TriMesh& mesh = active_.mesh();
    const Corners restored{b, c, a}, first{b, m, a}, second{m, c, a};
    find_near(box_of(mesh, restored));
    for (FaceId g : near_) {
        ask_whether_to_stop();
        const Corners face = corners_of(mesh, g);
        if (active_.stays(g) || has(face, m) || !may_intersect(mesh, restored, face)) continue;
        if (passes_through(mesh, b, c, face) &&
            (were_disjoint(active_, b, c, face) ||
             (were_disjoint(active_, b, m, face) && were_disjoint(active_, m, c, face)))) {
            return true;
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const VertexId p = face[corner], q = face[(corner + 1) % 3];
            if (passes_through(mesh, p, q, restored) &&
                (were_disjoint(active_, p, q, restored) ||
                 (were_disjoint(active_, p, q, first) && were_disjoint(active_, p, q, second)))) {
                return true;
            }
        }
    }
    return false;
}

PassedFaces find_passed_faces(const ActiveSet& active, std::span<const FaceId> others,
                              const StopToken& stop) {
    PassedFaces passed;
    if (others.empty()) return passed;
    const TriMesh& mesh = active.mesh();
    const std::vector<FaceId> moving = moved_faces(active);
    const std::vector<FaceId> near_moving =
        faces_in(mesh, with_descendants(active, others), box_of(mesh, moving));
    if (near_moving.empty()) return passed;
    const Box box_of_others = box_of(mesh, near_moving);
    const FaceTree tree(mesh, near_moving);
    std::vector<FaceId> near;
    std::uint64_t pairs = 0, asked_at = kPairsBetweenQuestions;
    for (FaceId f : moving) {
        if (pairs >= asked_at) {
            stop.throw_if_requested();
            asked_at = pairs + kPairsBetweenQuestions;
        }
        const Corners corners = corners_of(mesh, f);
        const Box box = box_of(mesh, corners);
        if (!box.meets(box_of_others)) continue;
        near.clear();
        tree.append_near(box, mesh, near);
        pairs += near.size();
        passed.are_all = pairs <= kMostPairsWithOthers;
        if (!passed.are_all) break;
        for (FaceId g : near) {
            if (intersect_newly(active, corners, corners_of(mesh, g))) passed.faces.push_back(g);
        }
    }
    std::sort(passed.faces.begin(), passed.faces.end());
    const auto end = std::unique(passed.faces.begin(), passed.faces.end());
    passed.faces.erase(end, passed.faces.end());
    return passed;
}

std::vector<EdgeId> edges_to_resolve(const ActiveSet& active, const Embedding& embedding,
                                     const Criteria& criteria,
                                     std::span<const SelfIntersection> intersections) {
    const TriMesh& mesh = active.mesh();
    std::unordered_map<std::uint32_t, double> bulges;  // an edge may be in many intersections
    const auto bulge = [&](EdgeId e) {
        const auto [known, is_new] = bulges.try_emplace(index(e), 0.0);
        if (!is_new || criteria.is_below_floor(mesh, e)) return known->second;
        const VertexId b = mesh.origin(mesh.half_edge(e)), c = mesh.target(mesh.half_edge(e));
        const Vec3 rest = 0.5 * active.rest_position(b) + 0.5 * active.rest_position(c);
        return known->second = glm::distance(embedding.image(rest),
                                             0.5 * mesh.position(b) + 0.5 * mesh.position(c));
    };
    // The bulge over an edge shrinks with the square of its length, and has to become less than the
    // distance of the exact sheets, about that at rest.
    const auto would_resolve = [&](EdgeId e, double distance) {
        return distance >= bulge(e) ||
               !criteria.is_below_floor(mesh.squared_length(e) * distance / bulge(e));
    };
    std::vector<EdgeId> edges;
    for (const SelfIntersection& intersection : intersections) {
        EdgeId farthest = intersection.edge;
        for_each_edge(intersection.face, [&](HalfEdgeId h) {
            if (bulge(mesh.edge(h)) > bulge(farthest)) farthest = mesh.edge(h);
        });
        if (would_resolve(farthest, rest_distance(active, intersection)))
            edges.push_back(mesh.representative(farthest));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace pectin
