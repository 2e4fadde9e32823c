#include "app/window_viewport.h"

#include "app/picture.h"

namespace pectin {

Done WindowViewport::screenshot(const TriMesh& mesh, const std::optional<Lattice>& lattice,
                                const command::Screenshot& screenshot) {
    const Canvas canvas(*gl_, screenshot.size);
    renderer_->draw(object_->mesh(), make_scene(screenshot, mesh, lattice), canvas);
    canvas.resolve();
    write_image(canvas.read(), screenshot.path);
    return {};
}

}  // namespace pectin
