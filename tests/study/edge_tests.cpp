// The paper's figure 5: operations and time for each test of an edge, before and after the trigger;
// and what the bit index of altered cells saves.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, point 2 and figure 5; section 2.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/defaults.h"
#include "study/bit_index.h"
#include "study/cases.h"
#include "study/certificate.h"
#include "study/counted.h"
#include "study/methods.h"
#include "study/studies.h"
#include "study/textbook.h"

namespace pectin::study {
namespace {

constexpr int kControlPoints = 12;  // of the textbook's hyperpatch, on each axis
constexpr std::size_t kEdges = 4096;

// Keeps a result from being optimised away.
volatile double sink = 0.0;

template <typename T>
Hyperpatch<T> random_patch(std::mt19937& random) {
    std::uniform_real_distribution<double> moved(-0.02, 0.02);
    Hyperpatch<T> patch{.origin = {T(0.0), T(0.0), T(0.0)},
                        .cell = {T(0.125), T(0.125), T(0.125)},
                        .count = kControlPoints,
                        .control_points = {}};
    for (int k = 0; k < kControlPoints; ++k) {
        for (int j = 0; j < kControlPoints; ++j) {
            for (int i = 0; i < kControlPoints; ++i) {
                patch.control_points.push_back({T(0.125 * i + moved(random)),
                                                T(0.125 * j + moved(random)),
                                                T(0.125 * k + moved(random))});
            }
        }
    }
    return patch;
}

template <typename T>
TestedEdge<T> random_edge(std::mt19937& random) {
    std::uniform_real_distribution<double> at(0.3, 1.0), off(-0.05, 0.05);
    const auto near = [&](const Point<double>& p) {
        return Point<T>{T(p[0] + off(random)), T(p[1] + off(random)), T(p[2] + off(random))};
    };
    const Point<double> p{at(random), at(random), at(random)};
    const Point<T> normal{T(0.36), T(0.48), T(0.8)};
    return {near(p), near(p), near(p), near(p), near(p), near(p), normal, normal};
}

// --- Operations and time of the textbook's code.

Json as_json(const Operations& o) {
    return {{"additions", o.additions},
            {"multiplications", o.multiplications},
            {"divisions", o.divisions},
            {"square_roots", o.square_roots},
            {"cost", o.cost()}};
}

template <typename Test>
Operations operations_of(Test test) {
    std::mt19937 random(1);
    const Hyperpatch<Counted> patch = random_patch<Counted>(random);
    const TestedEdge<Counted> edge = random_edge<Counted>(random);
    Counted::take();
    test(patch, edge);
    return Counted::take();
}

// Nanoseconds for each edge.
template <typename Test>
double textbook_time(int repetitions, Test test) {
    std::mt19937 random(1);
    const Hyperpatch<double> patch = random_patch<double>(random);
    std::vector<TestedEdge<double>> edges;
    for (std::size_t i = 0; i < kEdges; ++i) edges.push_back(random_edge<double>(random));
    return median_of(static_cast<std::size_t>(repetitions) * 10, [&] {
        double sum = 0.0;
        const double time = own_seconds([&] {
            for (const TestedEdge<double>& edge : edges) sum += test(patch, edge);
        });
        sink = sum;
        return 1e9 * time / static_cast<double>(kEdges);
    });
}

template <typename Test>
Json textbook(const char* what, int repetitions, Test test) {
    return {{"what", what},
            {"operations", as_json(operations_of(test))},
            {"ns", textbook_time(repetitions, test)}};
}

Json textbook_tests(int repetitions) {
    return {
        textbook("endpoint normals, before the trigger", repetitions,
                 [](const auto&, const auto& e) { return endpoint_normals(e); }),
        textbook("endpoint normals, after the trigger", repetitions,
                 [](const auto& patch, const auto& e) { return image_of_midpoint(patch, e)[0]; }),
        textbook("midpoint distance, before the trigger", repetitions,
                 [](const auto& patch, const auto& e) { return midpoint_distance(patch, e); })};
}

// --- Time of the program's tests: all edges of a fine object in a frame that refines nothing.

Case fine_object(const std::string& drag, Warp warp) {
    return {.object = "sphere of 81920 faces",
            .drag = drag,
            .mesh = shape(ShapeKind::sphere, 6),
            .warp = std::move(warp)};
}

std::vector<EdgeId> live_edges(const Scene& scene) {
    std::vector<EdgeId> edges;
    for (const EdgeId e : scene.active().edges()) {
        if (scene.active().mesh().is_live(e)) edges.push_back(e);
    }
    return edges;
}

// Nanoseconds for each edge of test(edge), which says whether it needs refinement.
template <typename Test>
double time_of_edges(const std::vector<EdgeId>& edges, int repetitions, Test test) {
    return median_of(static_cast<std::size_t>(repetitions), [&] {
        std::size_t count = 0;
        const double time = own_seconds([&] {
            for (const EdgeId e : edges) count += test(e) ? 1 : 0;
        });
        sink = static_cast<double>(count);
        return 1e9 * time / static_cast<double>(edges.size());
    });
}

// Some triggers take over the displacements of the warp when a pass begins.
template <typename Limits>
void begin_pass(const Limits& criteria) {
    if constexpr (requires { criteria.update(); }) criteria.update();
}

Json program_tests_on(const Case& of, int repetitions) {
    Scene scene(of.mesh, of.warp);
    const std::vector<EdgeId> edges = live_edges(scene);
    Json tests = Json::array();
    for (const Trigger& trigger : triggers()) {
        AdaptSettings settings = *AdaptSettings{}.with({.trigger = trigger.trigger});
        settings.l_max = Setting::off();
        const Criteria criteria = scene.criteria(limits_of(settings, of));
        begin_pass(criteria);
        std::size_t triggering = 0;
        for (const EdgeId e : edges) {
            triggering += criteria.needs_refinement(scene.active(), e) ? 1 : 0;
        }
        tests.push_back({{"what", trigger.name},
                         {"triggering", triggering},
                         {"ns", time_of_edges(edges, repetitions, [&](EdgeId e) {
                              return criteria.needs_refinement(scene.active(), e);
                          })}});
    }
    const Criteria normals = scene.criteria(limits_of(AdaptSettings{}, of));
    tests.push_back({{"what", "normals, fast path"},
                     {"triggering", 0},
                     {"ns", time_of_edges(edges, repetitions, [&](EdgeId e) {
                          return !normals.satisfies_criteria_fast(scene.mesh(), e, false);
                      })}});
    std::vector<Vec3> midpoints;
    for (const EdgeId e : edges) {
        const HalfEdgeId h = scene.mesh().half_edge(e);
        midpoints.push_back(0.5 * (scene.active().rest_position(scene.mesh().origin(h)) +
                                   scene.active().rest_position(scene.mesh().target(h))));
    }
    const double image = median_of(static_cast<std::size_t>(repetitions), [&] {
        double sum = 0.0;
        const double time = own_seconds([&] {
            for (const Vec3& x : midpoints) sum += scene.embedding().image(x).x;
        });
        sink = sum;
        return 1e9 * time / static_cast<double>(midpoints.size());
    });
    return {{"drag", of.drag},
            {"edges", edges.size()},
            {"tests", tests},
            {"image_ns", image},
            {"certificate", certificate_times(scene, repetitions)}};
}

// Of the control points of a lattice with as many on each axis, a cube of `moved` on each axis in
// the middle of its upper side.
std::vector<IVec3> block(const Lattice& lattice, int moved) {
    const int count = lattice.deformable.x;
    const int first = std::max(0, (count - moved) / 2), lowest = std::max(0, count - 1 - moved);
    std::vector<IVec3> controls;
    for (int k = lowest; k < lowest + moved; ++k) {
        for (int j = first; j < first + moved; ++j) {
            for (int i = first; i < first + moved; ++i) controls.emplace_back(i, j, k);
        }
    }
    return controls;
}

Warp cage_of(const TriMesh& mesh, int counts, int moved, const Vec3& by) {
    const Lattice lattice = fit_lattice(mesh.bounding_box(), IVec3{counts});
    std::vector<Vec3> displacements(lattice.control_count(), Vec3{0.0});
    for (const IVec3& control : block(lattice, moved)) {
        displacements[lattice.control_index(control)] = by;
    }
    return {.steps = {LatticeField(lattice, std::move(displacements))}};
}

Json program_tests(int repetitions) {
    const Case dragged =
        fine_object("one handle", brush_drag({.from = {0, 0, 1}, .to = {0, 0, 1.02}}, 2.5));
    const Case in_cage = fine_object("a cage of 5 x 5 x 5 control points",
                                     cage_of(dragged.mesh, 5, 7, {0.004, 0.0, 0.004}));
    return {program_tests_on(dragged, repetitions), program_tests_on(in_cage, repetitions)};
}

// How often edges need refinement of those that are tested, by the printed rules with the default
// angle and without L_max.
Json shares_of_triggering(const Options& options) {
    std::uint64_t tests = 0, splits = 0;
    for (const Case& of : twelve_cases(options.models).cases) {
        Scene scene(of.mesh, of.warp);
        const PrintedRefinement done = refine_as_printed(
            scene, {.curvature = NormalDivergence({.theta_max = kDefaultThetaMax})});
        if (!done.has_ended) continue;
        tests += done.tests;
        splits += done.splits;
    }
    return {{"tests", tests}, {"splits", splits}};
}

// --- The bit index. All vertices of the object lie in the cage, of which a block of control points
// has moved.

Json bit_index_with(const TriMesh& mesh, int counts, int moved, int repetitions) {
    const Warp warp = cage_of(mesh, counts, moved, {0.01, 0.0, 0.01});
    const LatticeField& field = std::get<LatticeField>(warp.steps.front());
    BitIndex index(field.lattice());
    for (const IVec3& control : block(field.lattice(), moved)) index.mark(control);
    std::vector<Vec3> points;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        points.push_back(mesh.position(VertexId{v}));
    }
    const auto is_altered = [&](const Vec3& x) { return index.is_altered(x); };
    const auto altered = std::ranges::count_if(points, is_altered);
    std::size_t edges = 0;
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
        const HalfEdgeId h = mesh.half_edge(EdgeId{e});
        edges +=
            is_altered(mesh.position(mesh.origin(h))) || is_altered(mesh.position(mesh.target(h)))
                ? 1
                : 0;
    }
    const auto time = [&](const auto& evaluate) {
        return median_of(static_cast<std::size_t>(repetitions), [&] {
            double sum = 0.0;
            const double passed = own_seconds([&] {
                for (const Vec3& x : points) sum += evaluate(x);
            });
            sink = sum;
            return 1e9 * passed / static_cast<double>(points.size());
        });
    };
    Scene scene(mesh, warp);
    const double streamed = median_of(static_cast<std::size_t>(repetitions), [&] {
        return 1e9 * seconds([&] { scene.embedding().deform(); }) /
               static_cast<double>(points.size());
    });
    return {{"control_points", field.lattice().control_count()},
            {"altered_control_points", moved * moved * moved},
            {"altered_vertices", static_cast<double>(altered) / static_cast<double>(points.size())},
            {"altered_edges", static_cast<double>(edges) / static_cast<double>(mesh.edge_count())},
            {"ns_without", time([&](const Vec3& x) { return field.displacement(x).x; })},
            {"ns_with", time([&](const Vec3& x) {
                 return index.is_altered(x) ? field.displacement(x).x : 0.0;
             })},
            {"ns_index", time([&](const Vec3& x) { return index.is_altered(x) ? 1.0 : 0.0; })},
            {"ns_program", streamed}};
}

Json bit_index(int repetitions) {
    const TriMesh mesh = shape(ShapeKind::sphere, 6);
    Json result = Json::array();
    for (const int moved : {1, 3, 5, 10}) {
        result.push_back(bit_index_with(mesh, 8, moved, repetitions));
    }
    return result;
}

}  // namespace

Json study_edge_tests(const Options& options) {
    return {{"textbook", textbook_tests(options.repetitions)},
            {"program", program_tests(options.repetitions)},
            {"triggering", shares_of_triggering(options)},
            {"bit_index", bit_index(options.repetitions)}};
}

}  // namespace pectin::study
