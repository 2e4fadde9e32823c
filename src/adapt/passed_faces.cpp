#include "adapt/passed_faces.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "adapt/face_pairs.h"
#include "mesh/face_tree.h"

namespace pectin {

namespace {

using face_pairs::box_of;
using face_pairs::Corners;
using face_pairs::corners_of;
using face_pairs::has;
using face_pairs::has_moved;
using face_pairs::is_live;
using face_pairs::live;
using face_pairs::may_intersect;
using face_pairs::passes_through;
using face_pairs::were_disjoint;

// The most pairs of an active and another face that are tested; this takes half a second.
constexpr std::uint64_t kMostPairsWithOthers = 4'000'000;
constexpr std::uint64_t kPairsBetweenQuestions = 4096;

Box box_around(const TriMesh& mesh, std::span<const FaceId> faces) {
    Box box;
    for (FaceId f : faces) box.include(box_of(mesh, corners_of(mesh, f)));
    return box;
}

// The faces whose boxes meet `box`.
std::vector<FaceId> faces_in(const TriMesh& mesh, std::vector<FaceId> faces, const Box& box) {
    std::erase_if(faces, [&](FaceId f) { return !box_of(mesh, corners_of(mesh, f)).meets(box); });
    return faces;
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

}  // namespace

PassedFaces find_passed_faces(const ActiveSet& active, std::span<const FaceId> others,
                              const StopToken& stop) {
    PassedFaces passed;
    if (others.empty()) return passed;
    const TriMesh& mesh = active.mesh();
    const std::vector<FaceId> moving = moved_faces(active);
    const std::vector<FaceId> near_moving =
        faces_in(mesh, with_descendants(active, others), box_around(mesh, moving));
    if (near_moving.empty()) return passed;
    const Box box_of_others = box_around(mesh, near_moving);
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

}  // namespace pectin
