// The certified trigger during a drag: how many faces are examined, and how long that takes.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "adapt/adapt.h"
#include "ffd/interpolation_error.h"
#include "mesh/face_tree.h"
#include "scenes.h"

namespace pectin::bench {
namespace {

constexpr int kFrames = 200;
constexpr double kLongest = 0.5;  // displacement of the last frame

// The largest bound of a face at the end of the drag, of every hundredth face.
double largest_bound(const TriMesh& mesh, const Warp& warp) {
    const InterpolationError error(warp);
    double largest = 0.0;
    for (std::uint32_t f = 0; f < mesh.face_slots(); f += 100) {
        InterpolationError::Corners rest;
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, c);
            rest[static_cast<std::size_t>(c)] = mesh.position(mesh.origin(h));
        }
        largest = std::max(largest, error.bound(std::span(&rest, 1)));
    }
    return largest;
}

// A drag that grows evenly over 200 frames and moves a whole sphere of 1.3 M faces by one handle,
// in one step. From 80 % of its length on, the steepest faces exceed the tolerance. With `all` set
// every face is tested in each of two frames, for comparison.
void certified_drag(benchmark::State& state) {
    const auto search =
        state.range(1) != 0 ? CertifiedError::Search::all : CertifiedError::Search::due;
    const int frames = state.range(1) != 0 ? kFrames / 100 : kFrames;
    TriMesh mesh = sphere(static_cast<int>(state.range(0)));
    const std::vector<Vec3> grabbed{mesh.position(VertexId{0})};
    auto solved = DragSolver::create(brush_lattice(grabbed[0], 4.0, 3), grabbed, {});
    const auto& solver = std::get<DragSolver>(solved);
    const Vec3 direction = glm::normalize(grabbed[0]);
    Warp warp{{DragStep{solver.field(), {kLongest * direction}}}};
    const double tolerance = 0.8 * largest_bound(mesh, warp);
    for (auto _ : state) {
        ActiveSet active(mesh);
        mesh.track_errors();
        active.begin(FaceTree(mesh).faces_meeting(warp.zone(), mesh), warp.zone());
        Embedding embedding(active, warp);
        embedding.embed();
        const Criteria criteria({.curvature = CertifiedError(tolerance, search), .floor = 1e-5},
                                warp.zone(), warp.zone(), &embedding);
        double deforming = 0.0, adapting = 0.0;
        std::uint64_t splits = 0, face_frames = 0;
        for (int i = 1; i <= frames; ++i) {
            displacements_of(warp.steps.back()).front() =
                (kLongest * i / static_cast<double>(frames)) * direction;
            deforming += seconds([&] { embedding.deform(); });
            face_frames += mesh.face_count();
            adapting +=
                seconds([&] { splits += adapt(active, embedding, criteria).refinement.splits; });
        }
        state.counters["faces"] = mesh.face_count();
        state.counters["splits"] = static_cast<double>(splits);
        state.counters["examined_share"] =
            static_cast<double>(criteria.certified_error()->examined_faces()) /
            static_cast<double>(face_frames);
        state.counters["adapt_ms_per_frame"] = 1e3 * adapting / frames;
        state.counters["deform_ms_per_frame"] = 1e3 * deforming / frames;
        active.cancel();
    }
}
BENCHMARK(certified_drag)
    ->ArgNames({"resolution", "all"})
    ->Args({8, 0})
    ->Args({8, 1})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace pectin::bench
