// Measures opening and saving a model of a million triangles, compared with tinyobjloader's parsing
// of the same file in the same run, and the memory.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <sys/wait.h>
#include <tiny_obj_loader.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "io/obj_reader.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "session/model_file.h"

namespace {

using namespace pectin;

constexpr int kTorusResolution = 250;
constexpr std::uint32_t kAround = 4 * kTorusResolution, kTube = 2 * kTorusResolution;  // quads
constexpr double kTriangles = 2.0 * kAround * kTube;

// A torus as exporters write it, in its own folder: triangles with six decimals, normals, and
// texture coordinates with a seam in each direction.
class ModelFile {
  public:
    ModelFile() {
        std::string name =
            (std::filesystem::temp_directory_path() / "pectin-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder to write in");
        folder_ = name;
        write();
    }
    ~ModelFile() { std::filesystem::remove_all(folder_); }
    ModelFile(const ModelFile&) = delete;
    ModelFile& operator=(const ModelFile&) = delete;

    std::string path() const { return folder_ / "model.obj"; }
    std::string saved() const { return folder_ / "saved.obj"; }

  private:
    void write() const {
        const IndexedFaceSet torus = make_shape(ShapeKind::torus, kTorusResolution);
        std::FILE* file = std::fopen(path().c_str(), "w");
        for (const Vec3& p : torus.positions) {
            std::fprintf(file, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
        }
        for (std::uint32_t i = 0; i <= kAround; ++i) {
            for (std::uint32_t j = 0; j <= kTube; ++j) {
                std::fprintf(file, "vt %.6f %.6f\n", 1.0 * i / kAround, 1.0 * j / kTube);
            }
        }
        for (const Vec3f& n : torus.normals) {
            std::fprintf(file, "vn %.4f %.4f %.4f\n", double{n.x}, double{n.y}, double{n.z});
        }
        for (std::uint32_t quad = 0; quad < kAround * kTube; ++quad) write_quad(file, torus, quad);
        std::fclose(file);
    }
    static void write_quad(std::FILE* file, const IndexedFaceSet& torus, std::uint32_t quad) {
        const std::uint32_t uv = quad / kTube * (kTube + 1) + quad % kTube + 1;
        const std::array uvs = {uv, uv + 1, uv + kTube + 2, uv + kTube + 1};
        for (const auto& triangle : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
            std::fputc('f', file);
            for (std::uint32_t corner : triangle) {
                const std::uint32_t p = torus.corners[4 * quad + corner].position + 1;
                std::fprintf(file, " %u/%u/%u", p, uvs[corner], p);
            }
            std::fputc('\n', file);
        }
    }
    std::filesystem::path folder_;
};

const ModelFile& model() {
    static const ModelFile kModel;
    return kModel;
}

void load_with_tinyobjloader() {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error,
                          model().path().c_str())) {
        throw std::runtime_error(error);
    }
    benchmark::DoNotOptimize(shapes.data());
}

LoadedModel open_model() { return load_model({model().path()}); }

template <typename Work>
double seconds(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Measures both alternately, so that both see the same load; the fastest run of each counts.
template <typename Work>
void compare(benchmark::State& state, Work work) {
    model();
    double ours = std::numeric_limits<double>::max(), theirs = ours;
    for (auto _ : state) {
        theirs = std::min(theirs, seconds(load_with_tinyobjloader));
        const double passed = seconds(work);
        ours = std::min(ours, passed);
        state.SetIterationTime(passed);
    }
    state.counters["ms"] = 1e3 * ours;
    state.counters["tinyobj_ms"] = 1e3 * theirs;
    state.counters["of_tinyobj"] = ours / theirs;
}

void obj_read(benchmark::State& state) {
    compare(state, [] { benchmark::DoNotOptimize(read_obj(model().path())); });
}

void obj_build(benchmark::State& state) {
    compare(state, [] { benchmark::DoNotOptimize(build_mesh(read_obj(model().path()))); });
}

// The work of `open`, including face tree and active set. The ratio should be at most 2.
void obj_open(benchmark::State& state) {
    compare(state, [] { benchmark::DoNotOptimize(open_model()); });
}

// Includes the flush to the disk. The ratio should be below 1.
void obj_save(benchmark::State& state) {
    const LoadedModel loaded = open_model();
    compare(state, [&loaded] { save_model(*loaded.mesh, {model().saved()}); });
}

// A value of /proc/self/status, in bytes.
double process_figure(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name + ":")) return 1024.0 * std::stod(line.substr(name.size() + 1));
    }
    return std::numeric_limits<double>::quiet_NaN();
}

struct Memory {
    double peak = 0.0, kept = 0.0;  // bytes in addition to those before
};

// Measures in a new process, so that memory freed earlier does not hide what this takes.
template <typename Work>
Memory memory_of(Work work) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        ::malloc_trim(0);
        const double before = process_figure("VmRSS");
        auto result = work();
        const Memory memory{process_figure("VmHWM") - before, process_figure("VmRSS") - before};
        benchmark::DoNotOptimize(result);
        ::_exit(::write(ends[1], &memory, sizeof memory) == sizeof memory ? 0 : 1);
    }
    ::close(ends[1]);
    Memory memory;
    const bool has_all = ::read(ends[0], &memory, sizeof memory) == sizeof memory;
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    if (!has_all) throw std::runtime_error("the process that loads the model has failed");
    return memory;
}

void report(benchmark::State& state, const Memory& memory) {
    state.counters["peak_bytes_a_triangle"] = memory.peak / kTriangles;
    state.counters["bytes_a_triangle"] = memory.kept / kTriangles;
}

// Should be at most 400 while it opens and 220 once it is open.
void obj_memory(benchmark::State& state) {
    model();
    for (auto _ : state) report(state, memory_of(open_model));
}
void obj_memory_reading(benchmark::State& state) {
    model();
    for (auto _ : state) report(state, memory_of([] { return read_obj(model().path()); }));
}

constexpr int kTurns = 5;
BENCHMARK(obj_read)->Iterations(kTurns)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(obj_build)->Iterations(kTurns)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(obj_open)->Iterations(kTurns)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(obj_save)->Iterations(kTurns)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(obj_memory_reading)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(obj_memory)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
