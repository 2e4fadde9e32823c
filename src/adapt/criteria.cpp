#include "adapt/criteria.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/sheets.h"
#include "adapt/split_order.h"
#include "embedding/embedding.h"

namespace pectin {
namespace {

// The boxes and, with symmetry, their mirror images. A drag acts on both sides already, but its
// second lattice is the image of the first only up to rounding, and a face may touch the border
// exactly.
std::vector<Box> with_images(std::vector<Box> boxes, const std::optional<MirrorPlane>& symmetry) {
    const std::size_t count = symmetry ? boxes.size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Box image = symmetry->image(boxes[i]);
        if (std::find(boxes.begin(), boxes.end(), image) == boxes.end()) boxes.push_back(image);
    }
    return boxes;
}

// The squared difference of unit normals that are 45 degrees apart.
constexpr double kLeastBend = 0.586;

std::vector<Box> as_list(const std::optional<Box>& box) {
    return box ? std::vector{*box} : std::vector<Box>{};
}

}  // namespace

Criteria::Criteria(const AdaptLimits& limits, const std::optional<Box>& zone,
                   const std::optional<Box>& scope, const Embedding* embedding)
    : Criteria(limits, as_list(zone), scope ? std::optional(as_list(scope)) : std::nullopt,
               embedding) {}

Criteria::Criteria(const AdaptLimits& limits, std::vector<Box> zones,
                   std::optional<std::vector<Box>> scope, const Embedding* embedding)
    : limits_(limits),
      floor_(limits.floor),
      length_(limits.l_max, with_images(std::move(zones), limits.symmetry), steps_of(embedding),
              SplitOrder(limits.propagation, limits.symmetry), floor_),
      curvature_depends_on_faces_(
          ask_curvature([](const auto& trigger) { return trigger.kDependsOnFaces; })),
      curvature_tests_faces_(ask_curvature([](const auto& trigger) {
          return requires(const ActiveSet& active, HalfEdgeId h) {
              trigger.needed_split(active, h);
          };
      })),
      squared_difference_bound_(
          ask_curvature([](const auto& trigger) { return trigger.fast_path_bound(); })),
      squared_length_bound_(length_.fast_path_bound()) {
    if (scope) scope_ = with_images(*std::move(scope), limits.symmetry);
    // Concurrent edits are tested while others are made.
    if (curvature_depends_on_faces_) limits_.partitioning.batch = Partitioning::kNever;
    const SplitOrder order(limits.propagation, limits.symmetry);
    const auto bind = [&](auto& trigger) {
        if constexpr (requires { trigger.bind(embedding); }) {
            trigger.bind(embedding);
        } else if constexpr (requires { trigger.bind(embedding, order, floor_); }) {
            trigger.bind(embedding, order, floor_);
        }
    };
    std::visit(bind, limits_.curvature);
}

EdgeLength::Steps Criteria::steps_of(const Embedding* embedding) const {
    if (!embedding || !embedding->is_composed()) return {};
    return {.embedding = embedding,
            .are_only_sampled = only_samples(*embedding),
            .largest_rest_difference = ask_curvature(
                [](const auto& trigger) { return trigger.rest_difference_hiding(kLeastBend); })};
}

// Whether the curvature trigger finds what the steps bend, so that L_max only has to ensure that no
// step goes unnoticed.
bool Criteria::only_samples(const Embedding& steps) const {
    const bool finds_bends =
        ask_curvature([](const auto& trigger) { return trigger.fast_path_bound() < kLeastBend; });
    return limits_.l_max_is_automatic && finds_bends && steps.steps_move_middles_most();
}

bool Criteria::may_unsplit(const ActiveSet& active, const Star& star) const {
    return edges_pass(active, star) && is_flat(active.mesh(), star) &&
           merged_edge_satisfies_criteria(active, star) && star_meets_scope(active, star) &&
           !length_.restored_face_is_too_coarse(active, star) && !is_kept(active.mesh(), star);
}

void Criteria::keep(std::vector<VertexId> vertices) {
    std::ranges::sort(vertices);
    kept_ = std::move(vertices);
}

bool Criteria::diverges_on_any_side(const ActiveSet& active, EdgeId e) const {
    return ask_curvature(
        [&](const auto& trigger) { return trigger.diverges_on_any_side(active, e); });
}

//          a
//         /|\        All edges at m pass the decimation test. Along a cut, bm and mc pass or fail
//        / | \       for all sheets at once; ma and md differ from sheet to sheet. On a boundary
//       b--m--c      there is no d.
//        \ | /
//         \|/
//          d
bool Criteria::edges_pass(const ActiveSet& active, const Star& star) const {
    return ask_curvature([&](const auto& trigger) {
        const TriMesh& mesh = active.mesh();
        const auto passes = [&](HalfEdgeId h) {
            const EdgeId e = mesh.edge(h);
            return trigger.passes_decimation(active, e) &&  // decimation condition (a)
                   length_.passes_decimation(mesh, e);      // decimation condition (b)
        };
        return passes(star.bm) && passes(star.mc) && all_sheets(mesh, star, [&](const Star& sheet) {
                   return passes(TriMesh::prev(sheet.mc)) &&
                          (sheet.on_boundary() || passes(TriMesh::prev(sheet.mb)));
               });
    });
}

// The merged-edge guard for refinement condition (a). EdgeLength has the one for (b).
bool Criteria::merged_edge_satisfies_criteria(const ActiveSet& active, const Star& star) const {
    return ask_curvature(
        [&](const auto& trigger) { return !trigger.merged_edge_needs_refinement(active, star); });
}

// The flatness guard. Removing m moves the surface by |f1.delta| + |f2.delta|, the distances of m
// from the restored faces with normals f1 and f2, where delta leads from the midpoint of bc to m
// (Griessmair & Purgathofer 1989; the paper's figure 5). On a boundary it is the distance from the
// line bc.
bool Criteria::is_flat(const TriMesh& mesh, const Star& star) const {
    if (limits_.flatness == kOff) return true;
    const Vec3 b = mesh.position(star.b), c = mesh.position(star.c);
    const Vec3 delta = mesh.position(star.m) - (0.5 * b + 0.5 * c);
    const double length = glm::distance(b, c);
    const double allowed = limits_.flatness * length;
    if (star.on_boundary()) {
        if (length == 0.0) return glm::length(delta) <= allowed;
        return glm::length(glm::cross(delta, c - b)) <= allowed * length;
    }
    const auto height = [&](const Vec3& area_normal) {
        const double area = glm::length(area_normal);
        // A restored face without area has no plane, so all of delta counts.
        return area > 0.0 ? std::abs(glm::dot(area_normal, delta)) / area : glm::length(delta);
    };
    return height(glm::cross(c - b, mesh.position(star.a) - b)) +
               height(glm::cross(mesh.position(star.d) - b, c - b)) <=
           allowed;
}

bool Criteria::star_meets_scope(const ActiveSet& active, const Star& star) const {
    if (!scope_) return true;
    const Vec3& m = active.rest_position(star.m);
    if (std::ranges::any_of(*scope_, [&](const Box& box) { return box.contains(m); })) return true;
    const auto meets = [&](VertexId p, VertexId q) {
        return std::ranges::any_of(*scope_, [&](const Box& box) {
            return triangle_meets_box(m, active.rest_position(p), active.rest_position(q), box);
        });
    };
    return !all_sheets(active.mesh(), star, [&](const Star& sheet) {
        return !meets(sheet.c, sheet.a) && !meets(sheet.a, sheet.b) &&
               (sheet.on_boundary() || (!meets(sheet.b, sheet.d) && !meets(sheet.d, sheet.c)));
    });
}

// All sheets are restored together, so one kept vertex keeps them all.
bool Criteria::is_kept(const TriMesh& mesh, const Star& star) const {
    if (kept_.empty()) return false;
    return !all_sheets(
        mesh, star, [&](const Star& sheet) { return !std::ranges::binary_search(kept_, sheet.m); });
}

}  // namespace pectin
