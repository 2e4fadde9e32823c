// What the hand feels: the steps of a drag in the window, and undo and redo, beside the deformation
// of the same vertices. Drags are fold-free and connected, and their frames are limited in time, as
// in the window.
#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "bench/scenes.h"
#include "command/command.h"
#include "session/session.h"

namespace pectin::bench {
namespace {

constexpr double kDiagonal = 3.46410161513775;                               // of the sphere's box
constexpr std::array kRadii{0.05 * kDiagonal, kAutoRadius* kDiagonal, 4.0};  // 4: the whole sphere
constexpr int kFrames = 6;

class Hand {
  public:
    Hand(int resolution, double radius) : radius_(radius) {
        must(session_.execute(command::Shape{command::Shape::Kind::sphere, resolution}));
        must(session_.execute(command::Brush{.radius = radius}));
        session_.set_frame_time(std::chrono::milliseconds(8));
        session_.pick({.origin = {0, 0, 5}, .direction = {0, 0, -1}});  // builds the face tree
    }
    // Returns the same object again if the arguments are the same, since the largest takes seconds
    // to build.
    static Hand& kept(int resolution, double radius) {
        static std::unique_ptr<Hand> last;
        static int last_resolution = -1;
        if (!last || last_resolution != resolution || last->radius_ != radius) {
            last.reset();
            last = std::make_unique<Hand>(resolution, radius);
            last_resolution = resolution;
        }
        return *last;
    }

    // The times of one drag outwards, in seconds. It is undone at the end.
    struct Times {
        double press = 0.0, frame = 0.0, release = 0.0, undo = 0.0, redo = 0.0, deform = 0.0;
    };
    Times drag() {
        const Vec3 from{0, 0, 1};
        Times times;
        times.press = seconds([&] {
            must(
                session_.begin_drag(std::vector{from}, {}, {.connected = true, .fold_free = true}));
        });
        for (int i = 1; i <= kFrames; ++i) {
            const Vec3 to = from + Vec3{0, 0, 0.1 * radius_ * i / kFrames};
            times.frame += seconds([&] { must(session_.drag_to(std::vector{to})); }) / kFrames;
            times.deform += session_.last_frame().deform_seconds / kFrames;
        }
        times.release = seconds([&] { session_.end_drag(); });
        times.undo = seconds([&] { must(session_.execute(command::Undo{})); });
        times.redo = seconds([&] { must(session_.execute(command::Redo{})); });
        must(session_.execute(command::Undo{}));
        session_.take_dirty();
        return times;
    }
    std::uint64_t influenced() const { return session_.statistics().last.influenced_vertices; }

  private:
    double radius_;
    Session session_;
};

void hand(benchmark::State& state) {
    const double radius = kRadii[static_cast<std::size_t>(state.range(1))];
    Hand& hand = Hand::kept(static_cast<int>(state.range(0)), radius);
    hand.drag();  // so that memory is allocated
    Hand::Times sum;
    for (auto _ : state) {
        const Hand::Times t = hand.drag();
        state.SetIterationTime(t.press + t.frame + t.release + t.undo + t.redo);
        sum.press += t.press;
        sum.frame += t.frame;
        sum.release += t.release;
        sum.undo += t.undo;
        sum.redo += t.redo;
        sum.deform += t.deform;
    }
    const auto milliseconds = [&](double total) {
        return 1e3 * total / static_cast<double>(state.iterations());
    };
    state.counters["vertices"] = static_cast<double>(hand.influenced());
    state.counters["press"] = milliseconds(sum.press);
    state.counters["frame"] = milliseconds(sum.frame);
    state.counters["release"] = milliseconds(sum.release);
    state.counters["undo"] = milliseconds(sum.undo);
    state.counters["redo"] = milliseconds(sum.redo);
    state.counters["deform"] = milliseconds(sum.deform);
}
BENCHMARK(hand)
    ->ArgNames({"resolution", "brush"})
    ->ArgsProduct({{6, 8, 9}, {0, 1, 2}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pectin::bench
