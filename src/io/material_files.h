// Copies the files that an OBJ file refers to: material libraries (MTL) and their textures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/progress.h"

namespace pectin {

// What happened to each file. Names are relative to the folders, with slashes, unique and sorted.
struct MaterialCopy {
    struct Reason {
        std::string name;
        std::string why;  // follows the name: "is hidden"
        bool operator==(const Reason&) const = default;
    };
    std::vector<std::string> copied;
    std::vector<std::string> missing;  // exist in neither folder
    std::vector<Reason> refused;       // must not be copied
    std::vector<Reason> failed;        // could not be copied
};

struct MaterialLimits {
    // How many names a save looks up. Large scenes have some hundred textures.
    std::size_t names = 4096;
    // In bytes. Real libraries have kilobytes.
    std::uint64_t library_bytes = std::uint64_t{16} << 20;
    // In bytes. A picture of 16384 x 16384 pixels takes this much with four bytes per pixel, and
    // four times as much with four floats.
    std::uint64_t texture_bytes = std::uint64_t{1} << 30;
};

// Copies the MTL files that the mtllib statements name, and the textures that these name, from the
// folder `from` to the folder `to`. Files keep their names; subfolders are made as needed. Files
// that exist in `to` are not replaced. Does nothing if both folders are the same or `to` does not
// exist.
//
// material_libraries: as in IndexedFaceSet. Each entry names one file, whose name may contain
// blanks, or several that end in .mtl. Names of textures have slashes or backslashes. A texture is
// searched for in the folder of its MTL file and then in `from`, where some exporters put it.
//
// Models may come from untrusted sources, so their names must not make a save copy private files or
// write files that other programs execute or obey. Therefore it refuses
// - names that lead out of the folder `from` or `to`, also through symbolic links,
// - names with a hidden part (.config/a.png),
// - material libraries and pictures that are not what their extension (.mtl, .png) or their content
//   should make them,
// - files beyond the limits, pipes, devices and folders.
// Each file is copied completely or not at all (AtomicFile). A file that cannot be read or written
// is reported and does not prevent other files from being copied. Throws Cancelled.
MaterialCopy copy_material_files(std::span<const std::string> material_libraries,
                                 const std::string& from, const std::string& to,
                                 const Progress& progress = {}, const MaterialLimits& limits = {});

}  // namespace pectin
