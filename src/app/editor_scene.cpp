#include "app/editor_scene.h"

namespace pectin {
namespace {

// Distance from the object to the border of the drawn plane, in diagonals of the object's box.
constexpr double kPlaneMargin = 0.03;

// The drawn part of the plane is a little larger than the object.
void add_symmetry_plane(Overlay& overlay, const Editor& editor) {
    const auto& plane = editor.session().symmetry();
    if (!plane || !editor.display.symmetry_plane) return;
    const Vec3 margin{kPlaneMargin * editor.workspace().diagonal()};
    const Box& box = editor.workspace().box();
    add_mirror_plane(overlay, *plane, {.min = box.min - margin, .max = box.max + margin});
}

}  // namespace

Scene editor_scene(const Editor& editor, float pixel_scale) {
    Scene scene{.camera = editor.camera(),
                .wireframe = editor.display.wireframe,
                .levels = editor.display.levels,
                .pixel_scale = pixel_scale};
    add_symmetry_plane(scene.overlay, editor);
    editor.add_overlays(scene.overlay);
    return scene;
}

}  // namespace pectin
