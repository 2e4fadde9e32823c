// Measures the cost of splits and removals, beside the paper's figures: 200 refinements in 16.8 ms,
// and 32 refinements with 92 decimations in 9.5 ms, on a 195 MHz R10000 (section 5).
//
// J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation. Eurographics
// UK 1999.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "bench/scenes.h"

namespace pectin::bench {
namespace {

AdaptLimits limits(double theta_max, double theta_min) {
    return {.curvature = NormalDivergence({.theta_max = theta_max, .theta_min = theta_min}),
            .floor = 1e-6};
}

void report(benchmark::State& state, const char* what, double count, double total_seconds,
            double paper_microseconds) {
    state.counters[std::string(what) + "s"] = count / static_cast<double>(state.iterations());
    state.counters[std::string("us_per_") + what] = 1e6 * total_seconds / count;
    state.counters[std::string("M_") + what + "s_per_s"] = 1e-6 * count / total_seconds;
    state.counters["paper_us"] = paper_microseconds;
}

constexpr double kPaperSplit = 16'800.0 / 200.0;          // microseconds per refinement
constexpr double kPaperEither = 9'500.0 / (32.0 + 92.0);  // microseconds per refinement or removal

// Where the memory for splits comes from: from the system while splits are made; a later frame has
// that of the frames before; from the system, but taken before the drag, as the program does.
enum Memory { kFresh, kLaterFrame, kPrepared };

constexpr std::uint32_t kPreparedSplits = 100'000;

// Splits only, from a few hundred (as in the paper) to a quarter of a million.
void split(benchmark::State& state) {
    const TriMesh mesh = sphere(static_cast<int>(state.range(0)));
    const AdaptLimits at = limits(static_cast<double>(state.range(1)) / 100.0, kOff);
    double count = 0.0, total = 0.0;
    for (auto _ : state) {
        Scene scene(mesh, {0, 0, 1}, {0, 0, 0.4}, 2.5,
                    state.range(2) == kPrepared ? kPreparedSplits : 0);
        Refinement done;
        if (state.range(2) == kLaterFrame) {
            scene.refine(at);
            scene.roll_back();
        }
        const double passed = seconds([&] { done = scene.refine(at); });
        state.SetIterationTime(passed);
        total += passed;
        count += static_cast<double>(done.splits);
    }
    report(state, "split", count, total, kPaperSplit);
}
BENCHMARK(split)
    ->ArgNames({"resolution", "centidegrees", "memory"})
    ->Args({2, 1400, kFresh})
    ->Args({3, 500, kFresh})
    ->Args({5, 125, kFresh})
    ->Args({6, 62, kFresh})
    ->Args({2, 1400, kLaterFrame})
    ->Args({3, 500, kLaterFrame})
    ->Args({5, 125, kLaterFrame})
    ->Args({6, 62, kLaterFrame})
    ->Args({2, 1400, kPrepared})
    ->Args({3, 500, kPrepared})
    ->Args({5, 125, kPrepared})
    ->UseManualTime();

// Removals only: all vertices that a refinement has inserted are removed.
void unsplit(benchmark::State& state) {
    const TriMesh mesh = sphere(static_cast<int>(state.range(0)));
    const AdaptLimits at = limits(static_cast<double>(state.range(1)) / 100.0, kOff);
    double count = 0.0, total = 0.0;
    for (auto _ : state) {
        Scene scene(mesh, {0, 0, 1}, {0, 0, 0.4}, 2.5);
        scene.refine(at);
        Decimation done;
        const double passed = seconds([&] { done = scene.decimate(AdaptLimits{}); });
        state.SetIterationTime(passed);
        total += passed;
        count += static_cast<double>(done.unsplits);
    }
    report(state, "unsplit", count, total, kPaperEither);
}
BENCHMARK(unsplit)
    ->ArgNames({"resolution", "centidegrees"})
    ->Args({2, 1400})
    ->Args({5, 125})
    ->Args({6, 62})
    ->UseManualTime();

// The paper's two steps on a coarse object: an extrusion that is refined at pi/7, then its
// flattening, which is refined at pi/7 and decimated at pi/9.
void extrude_then_flatten(benchmark::State& state) {
    const TriMesh mesh = sphere(2);
    const AdaptLimits at = limits(180.0 / 7.0, 180.0 / 9.0);
    double splits = 0.0, unsplits = 0.0, total = 0.0;
    for (auto _ : state) {
        Scene extrude(mesh, {0, 0, 1}, {0, 0, 0.8}, 1.6);
        extrude.refine(at);
        Scene flatten(extrude.finish(), {0, 0, 1.8}, {0, 0, -0.8}, 1.6);
        Refinement refined;
        Decimation decimated;
        const double passed = seconds([&] {
            refined = flatten.refine(at);
            decimated = flatten.decimate(at);
        });
        state.SetIterationTime(passed);
        total += passed;
        splits += static_cast<double>(refined.splits);
        unsplits += static_cast<double>(decimated.unsplits);
    }
    state.counters["splits"] = splits / static_cast<double>(state.iterations());
    report(state, "operation", splits + unsplits, total, kPaperEither);
}
BENCHMARK(extrude_then_flatten)->UseManualTime();

// The resident memory of the program, in bytes.
double resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    statm >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double mean_edge(const TriMesh& mesh) {
    double sum = 0.0;
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) sum += mesh.length(EdgeId{e});
    return sum / mesh.edge_count();
}

// Refines a whole sphere of 330 k faces to half its mean edge length, longest edge first, as the
// peers do, and then decimates it to the base mesh. A tiny drag acts, so that normals are
// transformed, too. Mirrored: with symmetry in a plane through the centre.
void refine_to_half_mean(benchmark::State& state) {
    const TriMesh mesh = sphere(7);
    AdaptLimits half{.l_max = 0.5 * mean_edge(mesh), .floor = 1e-6};
    if (state.range(0) != 0) half.symmetry = MirrorPlane{};
    double count = 0.0, concurrent = 0.0, taken = 0.0;
    for (auto _ : state) {
        Scene scene(mesh, {0, 0, 1}, {0, 0, 1e-3}, 4.0);
        Refinement done;
        const double before = resident_bytes();
        state.SetIterationTime(seconds([&] { done = scene.refine(half); }));
        taken += resident_bytes() - before;
        count += static_cast<double>(done.splits);
        concurrent += static_cast<double>(done.concurrent_splits);
    }
    state.counters["new_bytes_per_split"] = taken / count;
    state.counters["concurrent"] = concurrent / count;
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * count, benchmark::Counter::kIsRate);
}
BENCHMARK(refine_to_half_mean)
    ->ArgName("mirrored")
    ->Arg(0)
    ->Arg(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void unsplit_all(benchmark::State& state) {
    const TriMesh mesh = sphere(7);
    const AdaptLimits half{.l_max = 0.5 * mean_edge(mesh), .floor = 1e-6};
    double count = 0.0;
    for (auto _ : state) {
        Scene scene(mesh, {0, 0, 1}, {0, 0, 1e-3}, 4.0);
        scene.refine(half);
        Decimation done;
        state.SetIterationTime(seconds([&] { done = scene.decimate(AdaptLimits{}); }));
        count += static_cast<double>(done.unsplits);
    }
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * count, benchmark::Counter::kIsRate);
}
BENCHMARK(unsplit_all)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
