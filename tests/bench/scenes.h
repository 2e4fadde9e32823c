// Scenes of the benchmarks: objects, drags on them, and memory copies for comparison.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "adapt/adapt.h"
#include "command/result.h"
#include "embedding/embedding.h"
#include "ffd/drag_solver.h"
#include "mesh/active_set.h"
#include "mesh/tri_mesh.h"
#include "session/session.h"

namespace pectin::bench {

// The unit icosphere of 20·4^resolution faces. Vertices have the order in which subdivision creates
// them.
TriMesh sphere(int resolution);

template <typename Work>
double seconds(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// A mesh with an active set and a drag, before adaptation.
class Scene {
  public:
    // prepared_splits: those that memory is taken from the system for before the drag.
    Scene(const TriMesh& mesh, const Vec3& grabbed, const Vec3& displacement, double radius,
          std::uint32_t prepared_splits = 0);

    void deform() { embedding_->deform(); }
    Refinement refine(const AdaptLimits& limits) {
        return pectin::refine(active_, *embedding_, criteria(limits));
    }
    Decimation decimate(const AdaptLimits& limits) {
        return pectin::decimate(active_, criteria(limits));
    }
    // Undoes the adaptation but keeps the allocated memory.
    void roll_back();
    TriMesh finish();
    // Finishes the gesture and returns the change that an undo step would keep.
    MeshChange finish_with_change() { return active_.finish(); }
    const ActiveSet& active() const { return active_; }

  private:
    Criteria criteria(const AdaptLimits& limits) const {
        return Criteria(limits, warp_.zone(), warp_.zone());
    }
    TriMesh mesh_;
    Warp warp_;
    ActiveSet active_;
    std::unique_ptr<Embedding> embedding_;
};

// Ends the benchmark if the session has refused.
void must(const Done& done);

// The sphere in a session, with a brush at its north pole that influences about this many vertices,
// and an active drag whose frames oscillate.
class BrushScene {
  public:
    BrushScene(int resolution, double influenced, double theta_max);
    // Returns the previous scene again if the arguments are the same, because a benchmark runs
    // several times and the largest model takes seconds to build.
    static BrushScene& kept(int resolution, double influenced, double theta_max);

    void begin();
    // A frame as in the window: solve, deform, refine, decimate, and collecting the changes to
    // upload.
    void frame();
    void cancel() { session_.cancel_drag(); }

    Session& session() { return session_; }
    double radius() const { return radius_; }

  private:
    Session session_;
    double radius_ = 0.0;
    int frames_ = 0;
};

// Copies bytes from one array to another on the given number of threads.
class MemoryCopy {
  public:
    MemoryCopy(std::size_t bytes, int threads);
    void run();

  private:
    std::vector<char> from_, to_;
    std::size_t threads_;
};

}  // namespace pectin::bench
