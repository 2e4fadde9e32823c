// The interface through which a session draws screenshots. A host that can draw implements it.
#pragma once

#include <optional>
#include <string>

#include "command/command.h"
#include "command/result.h"
#include "ffd/lattice.h"
#include "mesh/tri_mesh.h"

namespace pectin {

class Viewport {
  public:
    virtual ~Viewport() = default;

    // Draws the object and writes the picture. lattice: the cage,
    // or else the lattice of the last drag, if any. Throws what drawing and io throw.
    virtual Done screenshot(const TriMesh& mesh, const std::optional<Lattice>& lattice,
                            const command::Screenshot& screenshot) = 0;
};

}  // namespace pectin
