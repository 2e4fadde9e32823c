#include "app/editor_scene.h"

#include <algorithm>
#include <cstdint>

namespace pectin {
namespace {

constexpr Background kLightBackground{.bottom = {0.700f, 0.712f, 0.730f},
                                      .top = {0.900f, 0.908f, 0.920f}};
// On a light background the lightest channel of a colour is at most this, from 0 to 255.
constexpr int kLightest = 150;
// Lines that are drawn faintly need more opacity there.
constexpr int kOpacityPercent = 140;

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

// Darkens the colour, which is meant for a dark background, and keeps its hue.
void adapt_to_light_background(Colour& colour) {
    const int lightest = std::max({colour.red, colour.green, colour.blue});
    if (lightest > kLightest) {
        const auto darker = [lightest](std::uint8_t channel) {
            return static_cast<std::uint8_t>(channel * kLightest / lightest);
        };
        colour.red = darker(colour.red);
        colour.green = darker(colour.green);
        colour.blue = darker(colour.blue);
    }
    colour.alpha = static_cast<std::uint8_t>(std::min(colour.alpha * kOpacityPercent / 100, 255));
}

void adapt_to_light_background(Scene& scene) {
    scene.background = kLightBackground;
    for (Overlay::Line& line : scene.overlay.lines) adapt_to_light_background(line.colour);
    for (Overlay::Point& point : scene.overlay.points) adapt_to_light_background(point.colour);
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
    if (editor.preferences.theme == Theme::light) adapt_to_light_background(scene);
    return scene;
}

}  // namespace pectin
