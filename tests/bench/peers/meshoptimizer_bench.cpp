// Measures meshoptimizer 0.18: edge collapses of its simplifier, to a quarter of the triangles.
#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <limits>

#include "bench/peers/sphere.h"

namespace pectin::bench {
namespace {

void meshoptimizer_simplify(benchmark::State& state) {
    const FlatMesh mesh = flat_sphere(7);
    std::vector<Vec3f> positions;
    for (const Vec3& p : mesh.positions) positions.emplace_back(p);
    std::vector<std::uint32_t> result(mesh.triangles.size());
    double collapses = 0.0;
    for (auto _ : state) {
        const std::size_t left =
            meshopt_simplify(result.data(), mesh.triangles.data(), mesh.triangles.size(),
                             &positions.data()->x, positions.size(), sizeof(Vec3f),
                             mesh.triangles.size() / 4, std::numeric_limits<float>::max());
        // A collapse in a closed mesh removes two triangles.
        collapses += static_cast<double>(mesh.triangles.size() - left) / 6.0;
    }
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * collapses, benchmark::Counter::kIsRate);
}
BENCHMARK(meshoptimizer_simplify)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
