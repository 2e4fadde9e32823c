#include "app/offscreen_viewport.h"

#include "app/host/offscreen_host.h"
#include "app/picture.h"

namespace pectin {

struct OffscreenViewport::Studio {
    std::unique_ptr<OffscreenHost> host = make_offscreen_host();
    Renderer renderer{host->gl()};
    GpuMesh mesh{host->gl()};
};

OffscreenViewport::OffscreenViewport() = default;
OffscreenViewport::~OffscreenViewport() = default;

std::optional<std::string> OffscreenViewport::screenshot(const TriMesh& mesh,
                                                         const std::optional<Lattice>& lattice,
                                                         const command::Screenshot& screenshot) {
    if (screenshot.show.ui) {
        return "the panels cannot be in the picture; leave \"ui\" out of show";
    }
    if (!studio_) studio_ = std::make_unique<Studio>();
    studio_->host->make_current();
    studio_->mesh.upload(mesh);
    const Canvas canvas(studio_->host->gl(), {screenshot.width, screenshot.height});
    studio_->renderer.draw(studio_->mesh, make_scene(screenshot, mesh, lattice), canvas);
    canvas.resolve();
    write_image(canvas.read(), screenshot.path);
    return std::nullopt;
}

}  // namespace pectin
