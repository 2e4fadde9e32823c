// Measures frames of a drag against the size of the model, against the number of active vertices,
// and beside memory copies. A frame is everything the session does between a mouse move and the
// picture.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "bench/scenes.h"

namespace pectin::bench {
namespace {

// theta_max in degrees: small enough that frames split and remove while the drag oscillates, and
// the program's default.
constexpr double kFine = 2.5, kUsual = 180.0 / 7.0;

void count_frames(benchmark::State& state, BrushScene& scene, double splits, double unsplits) {
    const auto frames = static_cast<double>(state.iterations());
    state.counters["faces"] = scene.session().mesh().face_count();
    state.counters["splits"] = splits / frames;
    state.counters["unsplits"] = unsplits / frames;
}

void run_frames(benchmark::State& state, BrushScene& scene) {
    scene.begin();
    for (int i = 0; i < 40; ++i) scene.frame();  // until all memory is allocated
    double splits = 0.0, unsplits = 0.0;
    for (auto _ : state) {
        scene.frame();
        splits += static_cast<double>(scene.session().last_frame().splits);
        unsplits += static_cast<double>(scene.session().last_frame().unsplits);
    }
    count_frames(state, scene, splits, unsplits);
    scene.cancel();
}

// 10,000 active vertices in models of increasing size. At the default angle almost nothing is
// split, so that all do the same work, as the counters show.
void locality(benchmark::State& state) {
    BrushScene& scene = BrushScene::kept(static_cast<int>(state.range(0)), 10'000, kUsual);
    run_frames(state, scene);
}
BENCHMARK(locality)
    ->ArgName("resolution")
    ->Arg(6)
    ->Arg(7)
    ->Arg(8)
    ->Arg(9)
    ->Unit(benchmark::kMicrosecond);

// The beginning of a drag: the faces in the zone are found, the linear system is solved, and the
// weights are computed. The drag is then cancelled, which is not measured.
void gesture_start(benchmark::State& state) {
    BrushScene& scene = BrushScene::kept(static_cast<int>(state.range(0)), 10'000, kFine);
    scene.begin();
    scene.cancel();
    for (auto _ : state) {
        state.SetIterationTime(seconds([&] { scene.begin(); }));
        scene.cancel();
    }
}
BENCHMARK(gesture_start)
    ->ArgName("resolution")
    ->Arg(6)
    ->Arg(7)
    ->Arg(8)
    ->Arg(9)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

// Increasing numbers of active vertices in a model of 1.3 M faces.
void active_sweep(benchmark::State& state) {
    BrushScene& scene = BrushScene::kept(8, static_cast<double>(state.range(0)), kUsual);
    run_frames(state, scene);
    state.counters["ns_per_vertex"] = benchmark::Counter(
        1e-9 * static_cast<double>(state.range(0)),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(active_sweep)
    ->ArgName("vertices")
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(655'000)
    ->Unit(benchmark::kMicrosecond);

// Steps of a brush as in sculpting programs.
void brush_step(benchmark::State& state) {
    BrushScene& scene = BrushScene::kept(static_cast<int>(state.range(0)),
                                         static_cast<double>(state.range(1)), 10.0);
    run_frames(state, scene);
}
BENCHMARK(brush_step)
    ->ArgNames({"resolution", "vertices"})
    ->Args({6, 650})
    ->Args({8, 9'400})
    ->Unit(benchmark::kMicrosecond);

// A frame with the whole sphere of 1.3 M faces in the zone, compared with a copy of its vertices
// (position and normal) and of the indices of its triangles.
constexpr int kWhole = 8;

void whole_object_frame(benchmark::State& state) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(0)));
    BrushScene& scene = BrushScene::kept(kWhole, 1e9, kUsual);
    run_frames(state, scene);
}
BENCHMARK(whole_object_frame)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void whole_object_copy(benchmark::State& state) {
    const TriMesh mesh = sphere(kWhole);
    const std::size_t bytes = mesh.vertex_count() * (sizeof(Vec3) + sizeof(Vec3f)) +
                              mesh.face_count() * 3 * sizeof(std::uint32_t);
    MemoryCopy copy(bytes, static_cast<int>(state.range(0)));
    for (auto _ : state) copy.run();
    state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
}
BENCHMARK(whole_object_copy)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

// Computes only the positions and normals of a frame. The counter is the memory traffic: per vertex
// the frame reads the rest position, the weight with its gradient and the rest normal, and writes a
// position, a normal and a mark. Ids are consecutive, so it reads none.
constexpr std::size_t kDeformReads = sizeof(Vec3) + sizeof(DragWeight) + sizeof(Vec3f);
constexpr std::size_t kDeformWrites = sizeof(Vec3) + sizeof(Vec3f) + 1;

void deform(benchmark::State& state) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(0)));
    Scene scene(sphere(kWhole), {0, 0, 1}, {0, 0, 0.4}, 4.0);
    for (auto _ : state) scene.deform();
    const std::size_t vertices = scene.active().influenced_at_begin();
    state.SetBytesProcessed(state.iterations() *
                            static_cast<std::int64_t>(vertices * (kDeformReads + kDeformWrites)));
    state.counters["M_vertices_per_s"] = benchmark::Counter(
        1e-6 * static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(deform)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMicrosecond);

// Reads n bytes and writes n bytes.
void deform_copy(benchmark::State& state) {
    const std::size_t moved = 655'362 * (kDeformReads + kDeformWrites);
    MemoryCopy copy(moved / 2, static_cast<int>(state.range(0)));
    for (auto _ : state) copy.run();
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(moved));
}
BENCHMARK(deform_copy)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pectin::bench
