// Pictures as PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pectin {

// rgba: 4 bytes a pixel, rows from the top, width * height of them. Written whole or not at all;
// the same pixels give the same bytes. A picture that is opaque all over is stored without alpha.
// Throws FileError.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgba);

struct PngPixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};
// Any PNG, as 8-bit RGBA. Throws FileError.
PngPixels read_png(const std::string& path);

}  // namespace pectin
