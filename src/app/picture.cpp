#include "app/picture.h"

#include <algorithm>

#include "app/light_background.h"
#include "io/png.h"

namespace pectin {
namespace {

constexpr float kReferenceHeight = 960.0f;  // pixels

}  // namespace

std::vector<Vec3> referenced_positions(const TriMesh& mesh) {
    std::vector<Vec3> positions;
    positions.reserve(mesh.vertex_slots());
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        if (exists(mesh.half_edge(VertexId{i}))) positions.push_back(mesh.position(VertexId{i}));
    }
    return positions;
}

Scene make_scene(const command::Screenshot& screenshot, const TriMesh& mesh,
                 const std::optional<Lattice>& lattice) {
    Scene scene{.wireframe = screenshot.show.wireframe, .levels = screenshot.show.levels};
    // In larger pictures, lines are as thick relative to the picture as at the reference height.
    scene.pixel_scale = std::max(1.0f, static_cast<float>(screenshot.size.y) / kReferenceHeight);
    const bool shows_lattice = screenshot.show.lattice && lattice;
    if (shows_lattice) add_lattice(scene.overlay, *lattice, {});
    if (screenshot.show.light) use_light_background(scene);
    if (screenshot.camera) {
        scene.camera = *screenshot.camera;
        return scene;
    }
    std::vector<Vec3> positions = referenced_positions(mesh);
    if (shows_lattice) {
        for (const Overlay::Line& line : scene.overlay.lines) positions.push_back(line.from);
    }
    scene.camera = fit(positions, static_cast<double>(screenshot.size.x) / screenshot.size.y);
    return scene;
}

void write_image(const Image& image, const std::string& path) {
    write_png(path, image.size.x, image.size.y, image.rgba);
}

}  // namespace pectin
