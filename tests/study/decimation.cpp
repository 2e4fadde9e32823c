// Decimation by undoing splits, beside vtkDecimatePro and meshoptimizer: time for each removal, how
// far the surface moves, and what returns of the mesh before it was refined.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, point 4 (b), which compares with W. J. Schroeder, J. A. Zarge,
// W. E. Lorensen. Decimation of triangle meshes. SIGGRAPH 1992.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "adapt/adapt.h"
#include "adapt/defaults.h"
#include "io/model_format.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "study/cases.h"
#include "study/methods.h"
#include "study/peers/peers.h"
#include "study/studies.h"

namespace pectin::study {
namespace {

constexpr double kFine = 6.0;  // theta_max in degrees by which the extrusion is refined

using Triangle = std::array<std::uint32_t, 3>;  // sorted

// Indices are the slots of vertices, so those of base vertices stay.
IndexedTriangles triangles_of(const TriMesh& mesh) {
    IndexedTriangles result;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        result.positions.push_back(mesh.is_live(VertexId{v}) ? mesh.position(VertexId{v})
                                                             : Vec3{0.0});
    }
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (!mesh.is_live(FaceId{f})) continue;
        for (int k = 0; k < 3; ++k) {
            result.corners.push_back(index(mesh.origin(TriMesh::half_edge(FaceId{f}, k))));
        }
    }
    return result;
}

std::set<Triangle> set_of(const std::vector<std::uint32_t>& corners) {
    std::set<Triangle> triangles;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        Triangle t{corners[i], corners[i + 1], corners[i + 2]};
        std::ranges::sort(t);
        triangles.insert(t);
    }
    return triangles;
}

TriMesh mesh_of(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& corners) {
    IndexedFaceSet set;
    set.positions = positions;
    set.parts.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        set.corners.push_back({corners[i]});
        if (i % 3 != 2) continue;
        set.polygon_end.push_back(static_cast<std::uint32_t>(i + 1));
        set.polygon_part.push_back(0);
    }
    return build_mesh(std::move(set)).mesh;
}

// The distances of samples of one mesh from another: the largest and the root of the mean square.
struct Distance {
    double largest = 0.0, rms = 0.0;
};
Distance distance(const TriMesh& from, const TriMesh& to) {
    constexpr int kIntervals = 4;
    const FaceTree tree(to);
    Distance result;
    double squares = 0.0;
    std::size_t count = 0;
    const auto corner = [](const TriMesh& mesh, FaceId f, int k) {
        return mesh.position(mesh.origin(TriMesh::half_edge(f, k)));
    };
    for (std::uint32_t i = 0; i < from.face_slots(); ++i) {
        const FaceId f{i};
        if (!from.is_live(f)) continue;
        for (int a = 0; a <= kIntervals; ++a) {
            for (int b = 0; a + b <= kIntervals; ++b) {
                const double u = 1.0 * a / kIntervals, v = 1.0 * b / kIntervals;
                const Vec3 p = (1.0 - u - v) * corner(from, f, 0) + u * corner(from, f, 1) +
                               v * corner(from, f, 2);
                const FaceId g = *tree.nearest(p, to);
                const double d = glm::distance(
                    p,
                    nearest_on_triangle(p, corner(to, g, 0), corner(to, g, 1), corner(to, g, 2)));
                result.largest = std::max(result.largest, d);
                squares += d * d;
                ++count;
            }
        }
    }
    result.rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
    return result;
}

// An object after an extrusion by which it was refined and a flattening by which it was not
// decimated: a mesh with far more triangles than it needs.
struct Oversaturated {
    std::string object;
    TriMesh base;     // before both
    TriMesh refined;  // between them
    Warp flattening;
    std::set<Triangle> split_faces;  // those of the base mesh that refinement has divided
};

Oversaturated oversaturated(std::string object, TriMesh base, const Vec3& from, double reach) {
    const Vec3 to = from + 0.5 * reach * unit_or_zero(from);
    const Warp extrusion = brush_drag({.from = from, .to = to}, reach);
    Scene scene(base, extrusion);
    refine(scene.active(), scene.embedding(),
           scene.criteria(
               {.curvature = NormalDivergence({.theta_max = kFine}, kDefaultRestAllowance)}));
    Oversaturated result{.object = std::move(object),
                         .base = std::move(base),
                         .refined = scene.finish(),
                         .flattening = brush_drag({.from = to, .to = from}, reach),
                         .split_faces = {}};
    const std::set<Triangle> now = set_of(triangles_of(result.refined).corners);
    for (const Triangle& t : set_of(triangles_of(result.base).corners)) {
        if (!now.contains(t)) result.split_faces.insert(t);
    }
    return result;
}

// How one method has decimated the mesh `before` to these triangles.
Json judge(const std::string& method, const Oversaturated& of, const TriMesh& before,
           const std::vector<std::uint32_t>& corners, double seconds) {
    const IndexedTriangles input = triangles_of(before);
    const TriMesh after = mesh_of(input.positions, corners);
    const double diagonal = before.bounding_box().diagonal();
    const Distance there = distance(before, after), back = distance(after, before);
    const std::set<std::uint32_t> used(corners.begin(), corners.end());
    const std::set<std::uint32_t> used_before(input.corners.begin(), input.corners.end());
    const std::size_t removed = used_before.size() - used.size();
    const std::set<Triangle> now = set_of(corners);
    std::size_t returned = 0, base_vertices = 0;
    for (const Triangle& t : of.split_faces) returned += now.contains(t) ? 1 : 0;
    for (const std::uint32_t v : used) base_vertices += v < of.base.vertex_count() ? 1 : 0;
    return {
        {"method", method},
        {"faces", corners.size() / 3},
        {"removed", removed},
        {"ns_per_removal", 1e9 * seconds / static_cast<double>(std::max<std::size_t>(removed, 1))},
        {"largest", std::max(there.largest, back.largest) / diagonal},
        {"rms", std::max(there.rms, back.rms) / diagonal},
        {"split_base_faces", of.split_faces.size()},
        {"returned_base_faces", returned},
        {"base_vertices", of.base.vertex_count()},
        {"kept_base_vertices", base_vertices}};
}

// The mesh after the flattening.
TriMesh flattened(const Oversaturated& of) { return Scene(of.refined, of.flattening).finish(); }

std::vector<FaceId> all_faces(const TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_live(FaceId{f})) faces.push_back(FaceId{f});
    }
    return faces;
}

constexpr const char* kReversal = "exact reversal";

// What the flattening itself removes, by these limits and in its zone.
Json by_reversal_in_the_drag(const Oversaturated& of, const TriMesh& before,
                             const AdaptLimits& limits, int repetitions) {
    std::optional<TriMesh> after;
    const double time = median_of(static_cast<std::size_t>(repetitions), [&] {
        Scene scene(of.refined, of.flattening);
        const double passed = seconds([&] { decimate(scene.active(), scene.criteria(limits)); });
        if (!after) after = scene.finish();
        return passed;
    });
    return judge(kReversal, of, before, triangles_of(*after).corners, time);
}

// Without limits and everywhere: all that was ever inserted.
Json by_full_reversal(const Oversaturated& of, const TriMesh& before, int repetitions) {
    std::optional<TriMesh> after;
    const double time = median_of(static_cast<std::size_t>(repetitions), [&] {
        TriMesh mesh = before;
        ActiveSet active(mesh);
        active.begin(all_faces(mesh), mesh.bounding_box());
        const double passed =
            seconds([&] { decimate(active, Criteria({}, std::nullopt, std::nullopt)); });
        active.finish();
        if (!after) after = mesh;
        return passed;
    });
    return judge(kReversal, of, before, triangles_of(*after).corners, time);
}

template <typename Peer>
Json by_peer(const Oversaturated& of, const TriMesh& before, const std::string& method,
             std::size_t faces, int repetitions, Peer peer) {
    const IndexedTriangles input = triangles_of(before);
    DecimatedTriangles result;
    const double time = median_of(static_cast<std::size_t>(repetitions), [&] {
        result = peer(input, faces);
        return result.seconds;
    });
    return judge(method, of, before, result.corners, time);
}

// limits: of the flattening; none: everything is reversed.
Json compare(const Oversaturated& of, const std::string& aim,
             const std::optional<AdaptLimits>& limits, int repetitions) {
    const TriMesh before = flattened(of);
    Json methods = Json::array();
    methods.push_back(limits ? by_reversal_in_the_drag(of, before, *limits, repetitions)
                             : by_full_reversal(of, before, repetitions));
#ifdef PECTIN_STUDY_PEERS
    const std::size_t faces = methods[0]["faces"];
    methods.push_back(by_peer(of, before, "vtkDecimatePro", faces, repetitions, decimate_by_vtk));
    methods.push_back(
        by_peer(of, before, "meshopt_simplify", faces, repetitions, decimate_by_meshoptimizer));
#endif
    return {{"object", of.object},
            {"aim", aim},
            {"base_faces", of.base.face_count()},
            {"faces_before", before.face_count()},
            {"methods", methods}};
}

}  // namespace

Json study_decimation(const Options& options) {
    std::vector<Oversaturated> objects;
    objects.push_back(
        oversaturated("sphere of 5120 faces", shape(ShapeKind::sphere, 4), {0, 0, 1}, 1.6));
    objects.push_back(
        oversaturated("cube of 768 faces", shape(ShapeKind::cube, 8), {0, 0, 1}, 1.8));
    const std::filesystem::path spot = std::filesystem::path(options.models) / "spot.obj";
    if (!options.models.empty() && std::filesystem::exists(spot)) {
        TriMesh mesh = build_mesh(read_model(spot.string())).mesh;
        const Vec3 from = extreme_point(mesh, {0, 0, -1});
        objects.push_back(oversaturated("spot", std::move(mesh), from, 0.8));
    }
    Json comparisons = Json::array();
    for (const Oversaturated& of : objects) {
        const Case with{.object = of.object, .drag = {}, .mesh = of.refined, .warp = of.flattening};
        comparisons.push_back(compare(of, "the default limits", limits_of(AdaptSettings{}, with),
                                      options.repetitions));
        comparisons.push_back(
            compare(of, "the mesh before the refinement", std::nullopt, options.repetitions));
    }
    return {{"theta_max", kFine},
            {"has_models", objects.size() > 2},
#ifdef PECTIN_STUDY_PEERS
            {"has_peers", true},
#else
            {"has_peers", false},
#endif
            {"comparisons", comparisons}};
}

}  // namespace pectin::study
