#include "adapt/self_intersections.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <unordered_map>
#include <utility>

#include "adapt/face_pairs.h"
#include "geometry/parallel.h"
#include "mesh/leaf_boxes.h"

namespace pectin {

namespace {

using face_pairs::box_of;
using face_pairs::Corners;
using face_pairs::corners_of;
using face_pairs::has;
using face_pairs::has_moved;
using face_pairs::live;
using face_pairs::may_intersect;
using face_pairs::passes_through;
using face_pairs::rest_distance;
using face_pairs::were_disjoint;

// If more than one in this many faces was edited, a new tree is better than an updated one.
constexpr std::size_t kRebuildDivisor = 8;
// If at least one in this many faces is active, a part of the mesh's tree is faster copied than
// built.
constexpr std::size_t kCopyDivisor = 8;
constexpr std::uint32_t kLeavesAtATime = 512;  // pairs of leaves, on one thread

double distance_at_rest(const ActiveSet& active, const SelfIntersection& intersection) {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId h = mesh.half_edge(intersection.edge);
    return rest_distance(active, mesh.origin(h), mesh.target(h),
                         corners_of(mesh, intersection.face));
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
        if (would_resolve(farthest, distance_at_rest(active, intersection)))
            edges.push_back(mesh.representative(farthest));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace pectin
