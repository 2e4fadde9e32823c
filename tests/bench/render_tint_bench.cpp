// Measures what the window does while the radius of the brush is being set, in a model of 1.3
// million faces: the picture without and with the tint on the surface, the rings' profile, and the
// point under the cursor.
#include <benchmark/benchmark.h>

#include <memory>

#include "app/host/offscreen_host.h"
#include "ffd/brush_profile.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "render/renderer.h"
#include "session/session.h"

namespace pectin::bench {
namespace {

constexpr IVec2 kSize{1280, 720};

// Whatever is needed to draw; null if this machine cannot.
struct Studio {
    static Studio* get() {
        static const std::unique_ptr<Studio> kStudio = make();
        return kStudio.get();
    }
    std::unique_ptr<OffscreenHost> host;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<GpuMesh> mesh;
    std::unique_ptr<Canvas> canvas;
    Scene scene;
    std::size_t faces = 0;

  private:
    static std::unique_ptr<Studio> make() {
        auto studio = std::make_unique<Studio>();
        try {
            studio->host = make_offscreen_host();
        } catch (const ContextError&) {
            return nullptr;
        }
        const Gl& gl = studio->host->gl();
        const TriMesh sphere = build_mesh(make_shape(ShapeKind::sphere, 8)).mesh;
        studio->faces = sphere.face_count();
        studio->renderer = std::make_unique<Renderer>(gl);
        studio->mesh = std::make_unique<GpuMesh>(gl);
        studio->mesh->upload(sphere);
        studio->canvas = std::make_unique<Canvas>(gl, kSize);
        studio->scene.camera = fit(sphere.bounding_box(), double{kSize.x} / kSize.y);
        return studio;
    }
};

void draw(benchmark::State& state, const Scene& scene, Studio& studio) {
    const auto picture = [&] {
        studio.renderer->draw(*studio.mesh, scene, *studio.canvas);
        studio.canvas->resolve();
        benchmark::DoNotOptimize(studio.canvas->read());  // waits until it is drawn
    };
    picture();
    for (auto _ : state) picture();
    state.counters["faces"] = static_cast<double>(studio.faces);
}

void radius_picture(benchmark::State& state) {
    Studio* const studio = Studio::get();
    if (!studio) return state.SkipWithError("nothing can be drawn");
    Scene scene = studio->scene;
    const BrushProfile profile(3, Falloff::sharp);
    if (state.range(0) != 0) {
        scene.tint = FalloffTint{.centre = {0.3, 0.2, 0.93},
                                 .image = Vec3{-0.3, 0.2, 0.93},
                                 .radius = 0.87,
                                 .samples = profile.samples()};
    }
    draw(state, scene, *studio);
}
BENCHMARK(radius_picture)
    ->ArgName("tint")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Made anew when the number of control points or the falloff changes.
void radius_profile(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(BrushProfile(static_cast<int>(state.range(0)), Falloff::plateau));
    }
}
BENCHMARK(radius_profile)->ArgName("points")->Arg(3)->Arg(16)->Unit(benchmark::kMillisecond);

// The point under the cursor in each frame.
void radius_pick(benchmark::State& state) {
    Session session;
    if (!session.execute(command::Shape{command::Shape::Kind::sphere, 8})) {
        return state.SkipWithError("there is no such sphere");
    }
    const Camera camera = fit(session.mesh().bounding_box(), double{kSize.x} / kSize.y);
    double x = 560.0;
    session.pick(camera.ray_through({x, 360.0}, kSize));  // makes the tree of the faces
    for (auto _ : state) {
        x = x > 720.0 ? 560.0 : x + 0.37;
        benchmark::DoNotOptimize(session.pick(camera.ray_through({x, 360.0}, kSize)));
    }
}
BENCHMARK(radius_pick)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pectin::bench
