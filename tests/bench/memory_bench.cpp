// Bytes: of a loaded model with what gestures keep for it, and of a step that can be undone.
#include <benchmark/benchmark.h>

#include "bench/scenes.h"
#include "mesh/face_tree.h"

namespace pectin::bench {
namespace {

// A closed smooth mesh, the tree of its faces and the arrays that stay after a first gesture on it.
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

// A drag that splits nothing: what each vertex it has moved costs.
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

}  // namespace
}  // namespace pectin::bench
