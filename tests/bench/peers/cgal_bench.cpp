// Measures CGAL 5.5: one iteration of isotropic remeshing to half the mean edge length.
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include "bench/peers/sphere.h"

namespace pectin::bench {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

void cgal_remesh(benchmark::State& state) {
    const FlatMesh flat = flat_sphere(5);
    Mesh start;
    for (const Vec3& p : flat.positions) start.add_vertex({p.x, p.y, p.z});
    for (std::size_t i = 0; i < flat.triangles.size(); i += 3) {
        const auto vertex = [&](std::size_t corner) {
            return Mesh::Vertex_index(flat.triangles[i + corner]);
        };
        start.add_face(vertex(0), vertex(1), vertex(2));
    }
    double inserted = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        Mesh mesh = start;
        state.ResumeTiming();
        CGAL::Polygon_mesh_processing::isotropic_remeshing(
            faces(mesh), 0.5 * flat.mean_edge(), mesh, CGAL::parameters::number_of_iterations(1));
        inserted += static_cast<double>(mesh.number_of_vertices() - start.number_of_vertices());
    }
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * inserted, benchmark::Counter::kIsRate);
}
BENCHMARK(cgal_remesh)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
