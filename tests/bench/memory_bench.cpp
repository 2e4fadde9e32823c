// Measures the memory of a loaded model with its first gesture, and of an undo step.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "bench/scenes.h"
#include "mesh/face_tree.h"

namespace pectin::bench {
namespace {

// A closed smooth mesh, its face tree and the arrays that remain after a first gesture.
void loaded_bytes(benchmark::State& state) {
    TriMesh mesh = sphere(static_cast<int>(state.range(0)));
    const double triangles = mesh.face_count();
    const FaceTree tree(mesh);
    ActiveSet active(mesh);
    const Box zone{Vec3{-0.1, -0.1, 0.9}, Vec3{0.1, 0.1, 1.1}};
    for (auto _ : state) {
        active.begin(tree.faces_meeting(zone, mesh), zone);
        active.finish();
    }
    const auto per_triangle = [&](std::size_t bytes) {
        return static_cast<double>(bytes) / triangles;
    };
    state.counters["mesh"] = per_triangle(mesh.memory_bytes());
    state.counters["gesture"] = per_triangle(active.memory_bytes());
    state.counters["tree"] = per_triangle(tree.memory_bytes());
    state.counters["bytes_per_triangle"] =
        per_triangle(mesh.memory_bytes() + active.memory_bytes() + tree.memory_bytes());
}
BENCHMARK(loaded_bytes)->ArgName("resolution")->Arg(6)->Arg(7)->Arg(8);

// The bytes per moved vertex of a drag without splits.
void undo_bytes_a_vertex(benchmark::State& state) {
    TriMesh mesh = sphere(7);
    ActiveSet active(mesh);
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) faces.push_back(FaceId{f});
    double bytes = 0.0;
    for (auto _ : state) {
        active.begin(faces, Box{Vec3{-2.0}, Vec3{2.0}});
        for (std::uint32_t i = 0; i < active.vertex_entries(); ++i) {
            mesh.set_position(active.vertex(i), 1.1 * mesh.position(active.vertex(i)));
            mesh.set_normal(active.wedge(i), -mesh.normal(active.wedge(i)));
        }
        bytes = static_cast<double>(active.finish().memory_bytes());
    }
    state.counters["bytes_per_vertex"] = bytes / mesh.vertex_count();
}
BENCHMARK(undo_bytes_a_vertex);

// The bytes of a step beyond the states of vertices and wedges, per operation. Operations are all
// edits. The faces that were inserted, removed or moved count as well, although a drag without
// edits would list half of them. As a check of the whole, the step is compared with 100 bytes per
// vertex and 32 per operation.
void report_operations(benchmark::State& state, const MeshChange& change) {
    const auto operations = static_cast<double>(change.edits.size());
    const auto bytes = static_cast<double>(change.memory_bytes());
    const auto states =
        static_cast<double>(change.before.memory_bytes() + change.after.memory_bytes());
    std::vector<VertexId> touched(change.before.vertices.begin(), change.before.vertices.end());
    touched.insert(touched.end(), change.after.vertices.begin(), change.after.vertices.end());
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    state.counters["operations"] = operations;
    state.counters["bytes_per_operation"] = (bytes - states) / operations;
    state.counters["of_what_is_allowed"] =
        bytes / (100.0 * static_cast<double>(touched.size()) + 32.0 * operations);
}

// A drag that refines a whole sphere, or one that decimates it again.
void undo_bytes_an_operation(benchmark::State& state) {
    const bool removes = state.range(0) != 0;
    const AdaptLimits refining{.curvature = NormalDivergence({.theta_max = 0.6, .theta_min = 0.0}),
                               .floor = 1e-6};
    const auto scene = [](const TriMesh& mesh) { return Scene(mesh, {0, 0, 1}, {0, 0, 0.2}, 4.0); };
    TriMesh mesh = sphere(6);
    if (removes) {
        Scene refined = scene(mesh);
        refined.refine(refining);
        mesh = refined.finish();
    }
    MeshChange change;
    for (auto _ : state) {
        Scene acted_on = scene(mesh);
        if (removes) {
            acted_on.decimate(AdaptLimits{});
        } else {
            acted_on.refine(refining);
        }
        change = acted_on.finish_with_change();
    }
    report_operations(state, change);
}
BENCHMARK(undo_bytes_an_operation)
    ->ArgName("removes")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
