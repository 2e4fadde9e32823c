// A mesh in the hands of one warp: what every part of the study measures.
#pragma once

#include <time.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "adapt/criteria.h"
#include "embedding/embedding.h"
#include "ffd/warp.h"
#include "mesh/active_set.h"
#include "mesh/tri_mesh.h"

namespace pectin::study {

// An object and what is done to it.
struct Case {
    std::string object, drag;
    TriMesh mesh;
    Warp warp;

    double diagonal() const { return mesh.bounding_box().diagonal(); }
    double largest_coordinate() const;
};

template <typename Work>
double seconds(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The same for work of this thread alone, without the time in which other programs ran.
template <typename Work>
double own_seconds(Work work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double begin = now();
    work();
    return now() - begin;
}

// The median of some repetitions of measure(), which returns a number.
template <typename Measure>
double median_of(std::size_t repetitions, Measure measure);
double median(std::vector<double> values);

// The mesh of a case, embedded and deformed, before it is adapted. It refers to the warp, which
// must outlive it.
class Scene {
  public:
    Scene(const TriMesh& mesh, const Warp& warp);

    TriMesh& mesh() { return mesh_; }
    ActiveSet& active() { return active_; }
    const ActiveSet& active() const { return active_; }
    Embedding& embedding() { return *embedding_; }
    const Warp& warp() const { return warp_; }
    // As a gesture makes them.
    Criteria criteria(const AdaptLimits& limits) const;
    // The faces that met the zone at the beginning and those made of them: live, sorted, each once.
    std::vector<FaceId> faces() const;
    // Ends the gesture.
    TriMesh finish();

  private:
    TriMesh mesh_;
    const Warp& warp_;
    ActiveSet active_;
    std::unique_ptr<Embedding> embedding_;
};

template <typename Measure>
double median_of(std::size_t repetitions, Measure measure) {
    std::vector<double> values;
    for (std::size_t i = 0; i < repetitions; ++i) values.push_back(measure());
    return median(std::move(values));
}

}  // namespace pectin::study
