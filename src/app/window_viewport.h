// Screenshots of the object that a window shows.
#pragma once

#include "app/object_view.h"
#include "render/renderer.h"
#include "session/viewport.h"

namespace pectin {

class WindowViewport : public Viewport {
  public:
    // All of them outlive it.
    WindowViewport(const Gl& gl, Renderer& renderer, const ObjectView& object)
        : gl_(&gl), renderer_(&renderer), object_(&object) {}

    // Precondition: the window's context is current. Refuses to show the user interface, which a
    // replay could not.
    std::optional<std::string> screenshot(const TriMesh& mesh,
                                          const std::optional<Lattice>& lattice,
                                          const command::Screenshot& screenshot) override;

  private:
    const Gl* gl_;
    Renderer* renderer_;
    const ObjectView* object_;
};

}  // namespace pectin
