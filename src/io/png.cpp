#include "io/png.h"

#include <png.h>

#include <cassert>

#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/read_file.h"

namespace pectin {
namespace {

// Owns the image of libpng's simplified interface.
struct PngImage {
    PngImage() { image.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image image{};
};

bool is_opaque(std::span<const std::uint8_t> rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) {
        if (rgba[i] != 255) return false;
    }
    return true;
}

std::vector<std::uint8_t> without_alpha(std::span<const std::uint8_t> rgba) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    }
    return rgb;
}

}  // namespace

void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgba) {
    assert(rgba.size() == 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<std::uint8_t> rgb;
    PngImage png;
    png.image.width = static_cast<png_uint_32>(width);
    png.image.height = static_cast<png_uint_32>(height);
    png.image.format = PNG_FORMAT_RGBA;
    const void* pixels = rgba.data();
    if (is_opaque(rgba)) {
        rgb = without_alpha(rgba);
        png.image.format = PNG_FORMAT_RGB;
        pixels = rgb.data();
    }
    png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string contents(bytes, '\0');
    if (!png_image_write_to_memory(&png.image, contents.data(), &bytes, 0, pixels, 0, nullptr)) {
        throw FileError(path, std::string("cannot be written as PNG: ") + png.image.message);
    }
    contents.resize(bytes);
    write_file_atomically(path, contents);
}

PngPixels read_png(const std::string& path) {
    const std::string contents = read_whole_file(path);
    PngImage png;
    PngPixels result;
    if (png_image_begin_read_from_memory(&png.image, contents.data(), contents.size())) {
        png.image.format = PNG_FORMAT_RGBA;
        result.width = static_cast<int>(png.image.width);
        result.height = static_cast<int>(png.image.height);
        result.rgba.resize(PNG_IMAGE_SIZE(png.image));
        if (png_image_finish_read(&png.image, nullptr, result.rgba.data(), 0, nullptr)) {
            return result;
        }
    }
    throw FileError(path, std::string("is no PNG that can be read: ") + png.image.message);
}

}  // namespace pectin
