// Measures OpenMesh 9: the same refinement with its edge split and a heap, and its quadric
// decimation.
#include <benchmark/benchmark.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <queue>
#include <utility>

#include "bench/peers/sphere.h"

namespace pectin::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Mesh openmesh_sphere(const FlatMesh& flat) {
    Mesh mesh;
    for (const Vec3& p : flat.positions) mesh.add_vertex({p.x, p.y, p.z});
    for (std::size_t i = 0; i < flat.triangles.size(); i += 3) {
        const auto vertex = [&](std::size_t corner) {
            return OpenMesh::VertexHandle(static_cast<int>(flat.triangles[i + corner]));
        };
        mesh.add_face(vertex(0), vertex(1), vertex(2));
    }
    return mesh;
}

void openmesh_refine(benchmark::State& state) {
    const FlatMesh flat = flat_sphere(7);
    const Mesh start = openmesh_sphere(flat);
    const double longest = 0.5 * flat.mean_edge();
    double splits = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        Mesh mesh = start;
        state.ResumeTiming();
        std::priority_queue<std::pair<double, int>> queue;
        const auto push = [&](OpenMesh::EdgeHandle e) {
            const double length = mesh.calc_edge_length(e);
            if (length > longest) queue.push({length, e.idx()});
        };
        for (const auto e : mesh.edges()) push(e);
        while (!queue.empty()) {
            const auto [length, id] = queue.top();
            queue.pop();
            const OpenMesh::EdgeHandle e(id);
            if (mesh.calc_edge_length(e) != length) continue;
            const auto m = mesh.add_vertex(mesh.calc_edge_midpoint(e));
            mesh.split(e, m);
            for (const auto round : mesh.ve_range(m)) push(round);
            ++splits;
        }
    }
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * splits, benchmark::Counter::kIsRate);
}
BENCHMARK(openmesh_refine)->Unit(benchmark::kMillisecond);

void openmesh_decimate(benchmark::State& state) {
    const Mesh start = openmesh_sphere(flat_sphere(6));
    double collapses = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        Mesh mesh = start;
        mesh.request_vertex_status();
        mesh.request_edge_status();
        mesh.request_face_status();
        mesh.request_face_normals();
        mesh.update_face_normals();
        state.ResumeTiming();
        OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
        OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
        decimater.add(quadric);
        decimater.module(quadric).unset_max_err();
        decimater.initialize();
        collapses += static_cast<double>(decimater.decimate_to(start.n_vertices() / 4));
    }
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * collapses, benchmark::Counter::kIsRate);
}
BENCHMARK(openmesh_decimate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
