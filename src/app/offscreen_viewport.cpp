#include "app/offscreen_viewport.h"

#include "app/host/offscreen_host.h"
#include "app/picture.h"

namespace pectin {

struct OffscreenViewport::Context {
    std::unique_ptr<OffscreenHost> host = make_offscreen_host();
    Renderer renderer{host->gl()};
    GpuMesh mesh{host->gl()};
};

OffscreenViewport::OffscreenViewport() = default;
OffscreenViewport::~OffscreenViewport() = default;

Done OffscreenViewport::screenshot(const TriMesh& mesh, const std::optional<Lattice>& lattice,
                                   const command::Screenshot& screenshot) {
    if (!context_) context_ = std::make_unique<Context>();
    context_->host->make_current();
    context_->mesh.upload(mesh);
    const Canvas canvas(context_->host->gl(), screenshot.size);
    context_->renderer.draw(context_->mesh, make_scene(screenshot, mesh, lattice), canvas);
    canvas.resolve();
    write_image(canvas.read(), screenshot.path);
    return {};
}

}  // namespace pectin
