// Reads and writes PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pectin {

// Writes a PNG file, completely or not at all. The same pixels give the same bytes. A picture that
// is opaque everywhere is stored without alpha. rgba: width * height pixels of 4 bytes, rows from
// the top. Throws FileError.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgba);

struct PngPixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};
// Reads any PNG file as 8-bit RGBA. Throws FileError.
PngPixels read_png(const std::string& path);

}  // namespace pectin
