// What the benchmarks have in common: objects, drags on them, and memory copies to compare with.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "adapt/adapt.h"
#include "embedding/embedding.h"
#include "ffd/drag_solver.h"
#include "mesh/active_set.h"
#include "mesh/tri_mesh.h"
#include "session/session.h"

namespace pectin::bench {

// The unit icosphere of 20·4^resolution faces; its vertices are numbered as subdivision makes them.
TriMesh sphere(int resolution);

template <typename Work>
double seconds(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// A mesh with an active set and a drag about to be adapted to.
class Scene {
  public:
    Scene(const TriMesh& mesh, const Vec3& grabbed, const Vec3& displacement, double radius);

    void deform() { embedding_->deform(); }
    Refinement refine(const AdaptLimits& limits) {
        return pectin::refine(active_, *embedding_, criteria(limits));
    }
    Decimation decimate(const AdaptLimits& limits) {
        return pectin::decimate(active_, criteria(limits));
    }
    // Back to before the adaptation, with the memory that it took.
    void roll_back();
    TriMesh finish();
    // The same, for what a step of the history keeps of it.
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

// The sphere in a session, with a brush about its north pole that influences about so many
// vertices, and an active drag whose frames go to and fro.
class BrushScene {
  public:
    BrushScene(int resolution, double influenced, double theta_max);
    // The same scene as last time if asked for it again: a benchmark runs several times, and the
    // largest model takes seconds to build.
    static BrushScene& kept(int resolution, double influenced, double theta_max);

    void begin();
    // A frame as the window has it: solve, deform, refine, decimate, and what the picture learns.
    void frame();
    void cancel() { session_.cancel_drag(); }

    Session& session() { return session_; }
    double radius() const { return radius_; }

  private:
    Session session_;
    double radius_ = 0.0;
    int frames_ = 0;
};

// Copies as many bytes as asked for from one array to another, on so many threads.
class MemoryCopy {
  public:
    MemoryCopy(std::size_t bytes, int threads);
    void run();

  private:
    std::vector<char> from_, to_;
    std::size_t threads_;
};

}  // namespace pectin::bench
