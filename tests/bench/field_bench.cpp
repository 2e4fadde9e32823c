// Measures the evaluation of deformations at many points on one thread: the textbook 4 x 4 x 4 sum
// of a lattice and the weights of a drag.
#include <benchmark/benchmark.h>

#include <random>

#include "bench/scenes.h"
#include "ffd/lattice_evaluator.h"

namespace pectin::bench {
namespace {

struct Points {
    Points() : lattice{.origin = Vec3{-1.0}, .cell = Vec3{1.0}, .deformable = IVec3{3}} {
        const TriMesh mesh = sphere(6);
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            positions.push_back(mesh.position(VertexId{v}));
            normals.emplace_back(mesh.position(VertexId{v}));
        }
        std::mt19937 engine(1);
        std::uniform_real_distribution<double> number(-0.2, 0.2);
        std::vector<Vec3> moved(lattice.control_count());
        for (Vec3& d : moved) d = {number(engine), number(engine), number(engine)};
        field = std::make_unique<LatticeField>(lattice, moved);
        to.resize(positions.size());
        transformed.resize(positions.size());
    }
    void report(benchmark::State& state) const {
        state.counters["M_per_s"] =
            benchmark::Counter(1e-6 * static_cast<double>(positions.size()),
                               benchmark::Counter::kIsIterationInvariantRate);
    }
    Lattice lattice;
    std::vector<Vec3> positions, to;
    std::vector<Vec3f> normals, transformed;
    std::unique_ptr<LatticeField> field;
};

void textbook_positions(benchmark::State& state) {
    Points points;
    const LatticeEvaluator evaluator(*points.field);
    for (auto _ : state) evaluator.displace(points.positions, points.to);
    points.report(state);
}
BENCHMARK(textbook_positions)->Unit(benchmark::kMicrosecond);

void textbook_with_normals(benchmark::State& state) {
    Points points;
    const LatticeEvaluator evaluator(*points.field);
    for (auto _ : state) {
        evaluator.transform(points.positions, points.normals, points.to, points.transformed);
    }
    points.report(state);
}
BENCHMARK(textbook_with_normals)->Unit(benchmark::kMicrosecond);

void drag_weights(benchmark::State& state) {
    const Points points;
    const Vec3 grabbed{0, 0, 1};
    const auto solver = std::get<DragSolver>(DragSolver::create(points.lattice, {&grabbed, 1}, {}));
    std::vector<DragWeight> weights(points.positions.size());
    for (auto _ : state) solver.field().weights(points.positions, weights);
    points.report(state);
}
BENCHMARK(drag_weights)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pectin::bench
