#include "app/editor_scene.h"

#include "app/light_background.h"

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

// While the radius is being set, the surface shows what a drag would do.
std::optional<FalloffTint> radius_tint(const Editor& editor) {
    if (!editor.is_setting_radius() || !editor.hover() || editor.has_cage()) return {};
    const Vec3 centre = editor.hover()->point;
    FalloffTint tint{
        .centre = centre, .radius = editor.radius(), .samples = editor.brush_profile().samples()};
    const auto& plane = editor.session().symmetry();
    if (plane && plane->offset(centre) != 0.0) tint.image = plane->image(centre);
    return tint;
}

}  // namespace

Scene editor_scene(const Editor& editor, float pixel_scale) {
    Scene scene{.camera = editor.camera(),
                .wireframe = editor.display.wireframe,
                .levels = editor.display.levels,
                .tint = radius_tint(editor),
                .pixel_scale = pixel_scale};
    add_symmetry_plane(scene.overlay, editor);
    editor.add_overlays(scene.overlay);
    editor.detail_preview.add_to(scene.overlay);
    if (editor.preferences.theme == Theme::light) use_light_background(scene);
    return scene;
}

}  // namespace pectin
