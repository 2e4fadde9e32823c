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

    // Makes its context at the first one. Refuses to show the user interface, which is a window's.
    std::optional<std::string> screenshot(const TriMesh& mesh,
                                          const std::optional<Lattice>& lattice,
                                          const command::Screenshot& screenshot) override;

  private:
    struct Studio;  // context, renderer and mesh
    std::unique_ptr<Studio> studio_;
};

}  // namespace pectin
