// Compares the refinement queue with a binary heap. Edges are taken longest first, and each adds
// two halves and two spokes, as in a refinement. The time of both includes computing these.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "adapt/refinement_queue.h"

namespace pectin::bench {
namespace {

// The refinement queue. It orders edges by length class and gives up to some thousands of edges at
// a time. Within each partition of a length class the order is FIFO.
class LengthClasses {
  public:
    void push(double squared, std::uint32_t e) {
        queue_.push(EdgeId{e}, RefinementQueue::length_class_of(squared));
    }
    // Calls visit(edge) for the next edges. Returns false if there are none.
    template <typename Visit>
    bool take(Visit visit) {
        if (queue_.is_empty()) return false;
        const RefinementQueue::Batch next = queue_.take();
        taken_.clear();  // the entries are valid only until the next push
        for (const auto& partition : next.partitions)
            taken_.insert(taken_.end(), partition.begin(), partition.end());
        for (EdgeId e : taken_) visit(index(e));
        return true;
    }

  private:
    RefinementQueue queue_;
    std::vector<EdgeId> taken_;
};

// Orders edges by length and gives one at a time.
class BinaryHeap {
  public:
    void push(double squared, std::uint32_t e) { heap_.emplace(squared, e); }
    template <typename Visit>
    bool take(Visit visit) {
        if (heap_.empty()) return false;
        const std::uint32_t e = heap_.top().second;
        heap_.pop();
        visit(e);
        return true;
    }

  private:
    std::priority_queue<std::pair<double, std::uint32_t>> heap_;
};

// Edges whose lengths depend only on their ancestors, so that the work is the same in any order.
class Edges {
  public:
    static constexpr std::uint32_t kFirst = 491'520;  // edges of a sphere of 330 k faces
    static constexpr double kMost = 0.25;             // no longer than half of 1

    Edges() {
        edges_.reserve(16 * std::size_t{kFirst});
        for (std::uint64_t e = 0; e < kFirst; ++e) edges_.push_back({1.0 + 0.3 * fraction(e), e});
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(edges_.size()); }
    double squared(std::uint32_t e) const { return edges_[e].squared; }
    bool is_too_long(std::uint32_t e) const { return edges_[e].squared > kMost; }
    // Calls visit(edge) for the edges that a split of e creates.
    template <typename Visit>
    void split(std::uint32_t e, Visit visit) {
        const Edge whole = edges_[e];
        for (std::uint64_t k = 0; k < 4; ++k) {
            const std::uint64_t seed = 4 * whole.seed + k + 1;
            const double of_whole = k < 2 ? 0.25 : 0.4 + 0.35 * fraction(seed);
            edges_.push_back({of_whole * whole.squared, seed});
            visit(count() - 1);
        }
    }

  private:
    struct Edge {
        double squared;
        std::uint64_t seed;
    };
    // A number in [0, 1) by multiplicative hashing. D. E. Knuth. The Art of Computer Programming,
    // vol. 3, section 6.4.
    static double fraction(std::uint64_t seed) {
        return static_cast<double>((seed * 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
    }
    std::vector<Edge> edges_;
};

template <typename Queue>
void longest_first(benchmark::State& state) {
    double through = 0.0;
    for (auto _ : state) {
        Edges edges;
        Queue queue;
        for (std::uint32_t e = 0; e < edges.count(); ++e) queue.push(edges.squared(e), e);
        while (queue.take([&](std::uint32_t e) {
            edges.split(e, [&](std::uint32_t made) {
                if (edges.is_too_long(made)) queue.push(edges.squared(made), made);
            });
            ++through;
        })) {
        }
    }
    state.counters["edges"] = through / static_cast<double>(state.iterations());
    state.counters["M_per_s"] = benchmark::Counter(1e-6 * through, benchmark::Counter::kIsRate);
}
BENCHMARK(longest_first<LengthClasses>)->Unit(benchmark::kMillisecond);
BENCHMARK(longest_first<BinaryHeap>)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
