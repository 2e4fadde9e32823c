#include "app/window_viewport.h"

#include "app/picture.h"

namespace pectin {

std::optional<std::string> WindowViewport::screenshot(const TriMesh& mesh,
                                                      const std::optional<Lattice>& lattice,
                                                      const command::Screenshot& screenshot) {
    if (auto refusal = refuse_panels(screenshot)) return refusal;
    const Canvas canvas(*gl_, {screenshot.width, screenshot.height});
    renderer_->draw(object_->mesh(), make_scene(screenshot, mesh, lattice), canvas);
    canvas.resolve();
    write_image(canvas.read(), screenshot.path);
    return std::nullopt;
}

}  // namespace pectin
