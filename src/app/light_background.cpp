#include "app/light_background.h"

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

void darken(Colour& colour) {
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

}  // namespace

void use_light_background(Scene& scene) {
    scene.background = kLightBackground;
    for (Overlay::Line& line : scene.overlay.lines) darken(line.colour);
    for (Overlay::Point& point : scene.overlay.points) darken(point.colour);
}

}  // namespace pectin
