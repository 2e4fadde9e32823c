// Measures a frame of a drag, plain and fold-free, while no further step is needed.
#include <benchmark/benchmark.h>

#include <array>

#include "bench/scenes.h"
#include "session/session.h"

namespace pectin {
namespace {

using bench::must;

// Arguments: resolution of the sphere, fold_free. The drag varies between 0.9 and 1.15 cells.
void drag_frame(benchmark::State& state) {
    constexpr double kRadius = 0.4, kCell = kRadius / 3.0;
    Session session;
    must(session.execute(
        command::Shape{command::Shape::Kind::sphere, static_cast<int>(state.range(0))}));
    must(session.execute(command::Brush{.radius = kRadius}));
    const Vec3 from{0, 0, 1};
    must(session.begin_drag(std::array{from}, {}, {.fold_free = state.range(1) != 0}));
    int frame = 0;
    for (auto _ : state) {
        const double far = 0.9 + 0.25 * (frame % 40) / 40.0;
        const Vec3 direction = glm::normalize(Vec3{0.2 + 0.01 * (frame % 7), 0.1, 1.0});
        must(session.drag_to(std::array{from + far * kCell * direction}));
        ++frame;
    }
    state.counters["waypoints"] = static_cast<double>(session.active_drag().via.size());
    session.cancel_drag();
}
BENCHMARK(drag_frame)->ArgsProduct({{4, 6, 7}, {0, 1}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pectin
