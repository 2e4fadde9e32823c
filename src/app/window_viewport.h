// Screenshots of a window's object.
#pragma once

#include "app/object_view.h"
#include "render/renderer.h"
#include "session/viewport.h"

namespace pectin {

class WindowViewport : public Viewport {
  public:
    // Precondition: all arguments outlive the viewport.
    WindowViewport(const Gl& gl, Renderer& renderer, const ObjectView& object)
        : gl_(&gl), renderer_(&renderer), object_(&object) {}

    // Refuses to show the user interface, because a replay could not. Precondition: the window's
    // context is current.
    Done screenshot(const TriMesh& mesh, const std::optional<Lattice>& lattice,
                    const command::Screenshot& screenshot) override;

  private:
    const Gl* gl_;
    Renderer* renderer_;
    const ObjectView* object_;
};

}  // namespace pectin
