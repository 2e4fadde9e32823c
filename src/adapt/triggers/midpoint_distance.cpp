#include "adapt/triggers/midpoint_distance.h"

#include <algorithm>
#include <cmath>

#include "adapt/sheets.h"
#include "embedding/embedding.h"

namespace pectin {
namespace {

// Slack for errors whose terms are summed in another order.
constexpr double kRoundedDown = 1.0 - 1e-9;

VertexId apex_of(const TriMesh& mesh, HalfEdgeId h) { return mesh.origin(TriMesh::prev(h)); }

bool is_any_deformed(const TriMesh& mesh, VertexId p, VertexId q) {
    return mesh.is_deformed(p) || mesh.is_deformed(q);
}

// |f.delta| for the unit normal f of the face with these corners.
double height(const TriMesh& mesh, VertexId p, VertexId q, VertexId apex, const Vec3& delta) {
    const Vec3 normal =
        glm::cross(mesh.position(q) - mesh.position(p), mesh.position(apex) - mesh.position(p));
    const double area = glm::length(normal);
    return area > 0.0 ? std::abs(glm::dot(normal, delta)) / area : glm::length(delta);
}

// The distance of the end of delta from the line through p and q, if delta begins on it.
double distance_from_line(const TriMesh& mesh, VertexId p, VertexId q, const Vec3& delta) {
    const Vec3 along = mesh.position(q) - mesh.position(p);
    const double length = glm::length(along);
    return length > 0.0 ? glm::length(glm::cross(along, delta)) / length : glm::length(delta);
}

std::size_t count_sides(const TriMesh& mesh, EdgeId e) {
    std::size_t sides = 0;
    mesh.for_each_side(e, [&](HalfEdgeId) { ++sides; });
    return sides;
}

//          a
//         /|\        Calls visit(outer, third) for the outer edges of one sheet. outer: the
//        / | \       half-edge of the face at m. third: the third corner of that face once m is
//       b--m--c      gone. That is c for ab and bd, and b for ca and dc.
//        \ | /
//         \|/
//          d
template <typename Visit>
void for_each_outer(const Star& sheet, Visit visit) {
    visit(TriMesh::prev(sheet.bm), sheet.c);
    visit(TriMesh::next(sheet.mc), sheet.b);
    if (sheet.on_boundary()) return;
    visit(TriMesh::next(sheet.mb), sheet.c);
    visit(TriMesh::prev(sheet.cm), sheet.b);
}

// The third corner of the face of h once the split of its apex is undone, if that may be while the
// vertices of this level are removed; otherwise the apex.
VertexId apex_after_removal(const TriMesh& mesh, HalfEdgeId h, std::uint16_t level) {
    VertexId apex = apex_of(mesh, h);
    if (mesh.is_base(apex) || mesh.level(apex) != level) return apex;
    const std::optional<Star> star = mesh.removable(apex);
    if (!star) return apex;
    mesh.for_each_sheet(*star, [&](const Star& sheet) {
        for_each_outer(sheet, [&](HalfEdgeId outer, VertexId third) {
            if (outer == h) apex = third;
        });
    });
    return apex;
}

}  // namespace

// `at`: a face at the edge pq. The image is that of the vertex which a split would insert.
Vec3 MidpointDistance::delta(const ActiveSet& active, VertexId p, VertexId q, FaceId at) const {
    const TriMesh& mesh = active.mesh();
    const Vec3 rest = 0.5 * active.rest_position(p) + 0.5 * active.rest_position(q);
    const bool moves = embedding_ && active.zone().contains_strictly(rest) && !active.stays(at);
    const Vec3 image = moves ? embedding_->image(rest) : rest;
    return image - (0.5 * mesh.position(p) + 0.5 * mesh.position(q));
}

double MidpointDistance::error(const ActiveSet& active, EdgeId e) const {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId h = mesh.half_edge(mesh.representative(e));
    const VertexId p = mesh.origin(h), q = mesh.target(h);
    const Vec3 to_image = delta(active, p, q, TriMesh::face(h));
    if (count_sides(mesh, e) == 1) return distance_from_line(mesh, p, q, to_image);
    double sum = 0.0;
    mesh.for_each_side(
        e, [&](HalfEdgeId side) { sum += height(mesh, p, q, apex_of(mesh, side), to_image); });
    return sum;
}

bool MidpointDistance::needs_refinement(const ActiveSet& active, EdgeId e) const {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId h = mesh.half_edge(e);
    return tolerance_ < kOff && is_any_deformed(mesh, mesh.origin(h), mesh.target(h)) &&
           error(active, e) > tolerance_;
}

//          a                  a
//         /|\                / \         Undoing the split of m restores bc and its faces, and
//        / | \              /   \        changes a face at each of the outer edges ab, ca, bd and
//       b--m--c    --->    b-----c       dc.
//        \ | /              \   /
//         \|/                \ /
//          d                  d
bool MidpointDistance::merged_edge_needs_refinement(const ActiveSet& active,
                                                    const Star& star) const {
    if (tolerance_ == kOff) return false;
    const TriMesh& mesh = active.mesh();
    if (!is_near_middle(mesh, star)) return true;
    if (is_any_deformed(mesh, star.b, star.c) &&
        merged_error(active, star) > kRoundedDown * tolerance_)
        return true;
    return !all_sheets(mesh, star, [&](const Star& sheet) {
        bool all_pass = true;
        for_each_outer(sheet, [&](HalfEdgeId outer, VertexId apex) {
            all_pass = all_pass && outer_edge_passes(active, outer, apex);
        });
        return all_pass;
    });
}

bool MidpointDistance::is_near_middle(const TriMesh& mesh, const Star& star) const {
    const Vec3 middle = 0.5 * mesh.position(star.b) + 0.5 * mesh.position(star.c);
    const std::size_t faces = std::max<std::size_t>(2, count_sides(mesh, mesh.edge(star.bm)));
    return static_cast<double>(faces) * glm::distance(mesh.position(star.m), middle) <
           0.5 * tolerance_;
}

// The error of bc once m is gone.
double MidpointDistance::merged_error(const ActiveSet& active, const Star& star) const {
    const TriMesh& mesh = active.mesh();
    const HalfEdgeId h = mesh.half_edge(mesh.representative(mesh.edge(star.bm)));
    const Vec3 to_image = delta(active, star.b, star.c, TriMesh::face(h));
    if (count_sides(mesh, mesh.edge(star.bm)) == 1) {
        return distance_from_line(mesh, star.b, star.c, to_image);
    }
    double sum = 0.0;
    mesh.for_each_sheet(star, [&](const Star& sheet) {
        sum += height(mesh, star.b, star.c, sheet.a, to_image);
        if (!sheet.on_boundary()) sum += height(mesh, star.b, star.c, sheet.d, to_image);
    });
    return sum;
}

// Whether an outer edge does not need refinement once the face of `outer` has this apex.
bool MidpointDistance::outer_edge_passes(const ActiveSet& active, HalfEdgeId outer,
                                         VertexId apex) const {
    const TriMesh& mesh = active.mesh();
    const EdgeId e = mesh.edge(outer);
    const VertexId p = mesh.origin(outer), q = mesh.target(outer);
    // The error at a boundary does not depend on the face.
    if (!is_any_deformed(mesh, p, q) || count_sides(mesh, e) == 1) return true;
    const std::uint16_t level = mesh.level(apex_of(mesh, outer));
    const HalfEdgeId first = mesh.half_edge(mesh.representative(e));
    const Vec3 to_image = delta(active, p, q, TriMesh::face(first));
    double sum = 0.0;
    mesh.for_each_side(e, [&](HalfEdgeId side) {
        const VertexId now = apex_of(mesh, side);
        const VertexId after = side == outer ? apex : apex_after_removal(mesh, side, level);
        double most = height(mesh, p, q, after, to_image);
        if (side != outer && after != now) {
            most = std::max(most, height(mesh, p, q, now, to_image));
        }
        sum += most;
    });
    return sum <= kRoundedDown * tolerance_;
}

}  // namespace pectin
