// The scene that a screenshot asks for, and its file.
#pragma once

#include <optional>
#include <vector>

#include "command/command.h"
#include "ffd/lattice.h"
#include "mesh/tri_mesh.h"
#include "render/canvas.h"
#include "render/renderer.h"

namespace pectin {

// lattice: drawn, if asked for and there is one. A camera that fits takes in what is shown of it.
// O(mesh) where the camera fits.
Scene make_scene(const command::Screenshot& screenshot, const TriMesh& mesh,
                 const std::optional<Lattice>& lattice);

// The positions of all live vertices that have faces, for a camera to fit. O(n).
std::vector<Vec3> seen_positions(const TriMesh& mesh);

// Throws FileError.
void write_image(const Image& image, const std::string& path);

}  // namespace pectin
