// Screenshots without a window.
#pragma once

#include <memory>

#include "session/viewport.h"

namespace pectin {

class OffscreenViewport : public Viewport {
  public:
    OffscreenViewport();
    ~OffscreenViewport() override;
    OffscreenViewport(const OffscreenViewport&) = delete;
    OffscreenViewport& operator=(const OffscreenViewport&) = delete;

    // Creates the OpenGL context in the first call. Refuses to show the user interface, which only
    // a window has.
    Done screenshot(const TriMesh& mesh, const std::optional<Lattice>& lattice,
                    const command::Screenshot& screenshot) override;

  private:
    struct Context;  // OpenGL context, renderer and mesh
    std::unique_ptr<Context> context_;
};

}  // namespace pectin
