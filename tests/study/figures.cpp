// The paper's figures 4 and 6, as data for pictures. Their tests are in
// tests/unit/adapt_figures_test.cpp.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, points 1 and 4 (c).
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "adapt/adapt.h"
#include "study/cases.h"
#include "study/methods.h"
#include "study/studies.h"
#include "study/true_error.h"
#include "support/undulation.h"

namespace pectin::study {
namespace {

// --- Figure 4.

constexpr double kSection = 0.37;  // z of the section that is drawn
constexpr double kHeight = 0.12;

// The lines in which the faces meet the plane z = kSection, as x and y of their ends.
Json section_of(const TriMesh& mesh) {
    Json lines = Json::array();
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (!mesh.is_live(FaceId{f})) continue;
        Json line = Json::array();
        for (int k = 0; k < 3; ++k) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, k);
            const Vec3 p = mesh.position(mesh.origin(h)), q = mesh.position(mesh.target(h));
            if ((p.z < kSection) == (q.z < kSection)) continue;
            const Vec3 at = p + (kSection - p.z) / (q.z - p.z) * (q - p);
            line.push_back({at.x, at.y});
        }
        if (line.size() == 2) lines.push_back(line);
    }
    return lines;
}

Json refined_section(const Case& of, const std::string& name, const AdaptSettings& settings) {
    Scene scene(of.mesh, of.warp);
    const Adaptation done =
        adapt(scene.active(), scene.embedding(), scene.criteria(limits_of(settings, of)));
    const std::vector<FaceId> faces = scene.faces();
    return {{"name", name},
            {"splits", done.refinement.splits},
            {"faces", faces.size()},
            {"from_mesh", true_error(scene, faces).from_mesh},
            {"lines", section_of(scene.mesh())}};
}

Json undulation_by_waves(int waves) {
    const Case of{.object = "plane",
                  .drag = "undulation",
                  .mesh = shape(ShapeKind::plane, 2),
                  .warp = test::undulation(waves, kHeight)};
    Json surface = Json::array();
    for (int i = 0; i <= 400; ++i) {
        const Vec3 image = exact_image(of.warp, {-1.0 + i / 200.0, 0.0, kSection});
        surface.push_back({image.x, image.y});
    }
    Json results = Json::array();
    for (const Trigger& trigger : triggers()) {
        AdaptSettings settings = *AdaptSettings{}.with({.trigger = trigger.trigger});
        if (trigger.limits_length) {
            results.push_back(refined_section(of, trigger.name + " with L_max", settings));
        }
        settings.l_max = Setting::off();
        results.push_back(refined_section(of, trigger.name + " without L_max", settings));
    }
    return {{"waves", waves},
            {"l_max", of.warp.smallest_feature_extent()},
            {"tolerance", kDefaultToleranceFraction * of.diagonal()},
            {"surface", surface},
            {"results", results}};
}

// --- Figure 6.

// All edges as x and z of their ends.
Json edges_of(const TriMesh& mesh) {
    Json lines = Json::array();
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (!mesh.is_live(EdgeId{e})) continue;
        const HalfEdgeId h = mesh.half_edge(EdgeId{e});
        const Vec3 p = mesh.position(mesh.origin(h)), q = mesh.position(mesh.target(h));
        lines.push_back({{p.x, p.z}, {q.x, q.z}});
    }
    return lines;
}

Json point_of(const TriMesh& mesh, VertexId v) { return {mesh.position(v).x, mesh.position(v).z}; }

// A square is split at its diagonal, which inserts p, and then between p and a corner, which
// inserts q. Both p and q have four edges. Without p, q has three, and nothing can remove it.
Json order_of_decimation() {
    TriMesh mesh = shape(ShapeKind::plane, 1);
    EdgeId diagonal{0};
    for (std::uint32_t e = 1; e < mesh.edge_slots(); ++e) {
        if (mesh.length(EdgeId{e}) > mesh.length(diagonal)) diagonal = EdgeId{e};
    }
    const Split first = mesh.split(diagonal);
    const TriMesh with_p = mesh;
    const Split second = mesh.split(first.am);
    const VertexId p = first.m, q = second.m;
    Json before = edges_of(mesh), illegal = Json::array();
    for (const Json& line : before) {
        const bool ends_at_p = line[0] == point_of(mesh, p) || line[1] == point_of(mesh, p);
        if (!ends_at_p) illegal.push_back(line);
    }
    illegal.push_back({point_of(mesh, first.b), point_of(mesh, first.c)});
    return {{"p", point_of(mesh, p)},
            {"q", point_of(mesh, q)},
            {"p_is_removable_first", mesh.removable(p).has_value()},
            {"q_is_removable_first", mesh.removable(q).has_value()},
            {"before", before},
            {"illegal", illegal},
            {"legal", edges_of(with_p)},
            {"then", edges_of(shape(ShapeKind::plane, 1))}};
}

}  // namespace

Json study_figures(const Options&) {
    return {{"undulations", {undulation_by_waves(1), undulation_by_waves(2)}},
            {"order", order_of_decimation()}};
}

}  // namespace pectin::study
