#include "io/material_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "io/file_error.h"

namespace pectin {

namespace fs = std::filesystem;

namespace {

std::string lower_case_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

fs::path followed(const fs::path& path) {
    std::error_code error;
    fs::path target = fs::weakly_canonical(path, error);
    if (error) {
        throw FileError(path.string(), "its path cannot be followed: " + error.message());
    }
    return target;
}

}  // namespace

// The system would read a name only up to a zero byte, so the path checked here would be another.
std::optional<fs::path> path_inside(const fs::path& subfolder, std::string_view name) {
    const fs::path path = (subfolder / name).lexically_normal();
    if (name.find('\0') != name.npos || path.is_absolute() || path.empty()) return std::nullopt;
    if (*path.begin() == ".." || *path.begin() == "." || !path.has_filename()) return std::nullopt;
    return path;
}

bool is_hidden(const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return part.string().starts_with('.'); });
}

const char* reason_against(const fs::path& folder, const fs::path& path) {
    const fs::path root = followed(folder), target = followed(folder / path);
    const auto [in_root, in_target] =
        std::mismatch(root.begin(), root.end(), target.begin(), target.end());
    if (in_root != root.end()) return kLeadsOut;
    return std::any_of(in_target, target.end(),
                       [](const fs::path& part) { return part.string().starts_with('.'); })
               ? kIsHidden
               : nullptr;
}

bool is_library_name(const fs::path& path) { return lower_case_extension(path) == ".mtl"; }

bool is_picture_name(const fs::path& path) {
    // The formats that recognise_file() and is_tga() recognise.
    static constexpr auto kExtensions = std::to_array<std::string_view>(
        {".avif", ".bmp", ".bw",   ".dds",  ".dib",  ".exr", ".gif", ".hdr",  ".heic", ".heif",
         ".icb",  ".iff", ".j2c",  ".j2k",  ".jfif", ".jp2", ".jpc", ".jpe",  ".jpeg", ".jpf",
         ".jpg",  ".jpx", ".jxl",  ".ktx",  ".lbm",  ".pam", ".pbm", ".pfm",  ".pgm",  ".pic",
         ".png",  ".pnm", ".ppm",  ".psb",  ".psd",  ".qoi", ".rgb", ".rgba", ".rgbe", ".sgi",
         ".tga",  ".tif", ".tiff", ".tpic", ".tx",   ".vda", ".vst", ".webp", ".xcf"});
    const std::string extension = lower_case_extension(path);
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace pectin
