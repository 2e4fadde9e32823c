// The scene and the file of a screenshot.
#pragma once

#include <optional>
#include <vector>

#include "command/command.h"
#include "command/result.h"
#include "ffd/lattice.h"
#include "mesh/tri_mesh.h"
#include "render/canvas.h"
#include "render/renderer.h"

namespace pectin {

// lattice: drawn if the screenshot shows it. A camera that fits the object then also fits the
// lattice. Cost: O(mesh) if the camera fits, else O(1).
Scene make_scene(const command::Screenshot& screenshot, const TriMesh& mesh,
                 const std::optional<Lattice>& lattice);

// The positions of all live vertices that have faces, for a camera to fit. Cost: O(n).
std::vector<Vec3> referenced_positions(const TriMesh& mesh);

// Writes a PNG file. Throws FileError.
void write_image(const Image& image, const std::string& path);

}  // namespace pectin
