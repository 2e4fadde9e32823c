// Where a session's pictures come from: a host that can draw.
#pragma once

#include <optional>
#include <string>

#include "command/command.h"
#include "ffd/lattice.h"
#include "mesh/tri_mesh.h"

namespace pectin {

class Viewport {
  public:
    virtual ~Viewport() = default;

    // Draws the object and writes the picture, or says why not. `lattice`: the one that drags use
    // or the last one used, if there is any. Throws what drawing and io throw.
    virtual std::optional<std::string> screenshot(const TriMesh& mesh,
                                                  const std::optional<Lattice>& lattice,
                                                  const command::Screenshot& screenshot) = 0;
};

}  // namespace pectin
