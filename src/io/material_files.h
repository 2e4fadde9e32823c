// The files that an OBJ names beside itself: material libraries (MTL) and their textures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/progress.h"

namespace pectin {

// Each name once, sorted; below the folders, with slashes.
struct MaterialCopy {
    struct Reason {
        std::string name;
        std::string why;  // behind the name: "is hidden"
        bool operator==(const Reason&) const = default;
    };
    std::vector<std::string> copied;
    std::vector<std::string> missing;  // named, but in neither folder
    std::vector<Reason> refused;       // not to be copied, whatever is there
    std::vector<Reason> failed;        // to be copied, but that went wrong
};

struct MaterialLimits {
    // Names that a save looks up. Large scenes have some hundred textures.
    std::size_t names = 4096;
    // Real libraries have kilobytes; what is larger is none, whatever it is called.
    std::uint64_t library_bytes = std::uint64_t{16} << 20;
    // A picture of 16384 x 16384 pixels with four floats each takes four times as much, one with
    // four bytes each as much.
    std::uint64_t texture_bytes = std::uint64_t{1} << 30;
};

// Copies the MTL files that the mtllib statements name, and the textures that those name, from the
// folder `from` into the folder `to`, below the same names; subfolders are made as needed. What is
// in `to` already stays as it is, and so does everything where both are one folder or where there
// is no folder `to`.
//
// material_libraries: as IndexedFaceSet has them; each names one file, also with blanks, or several
// that end in .mtl. Textures are named with slashes or backslashes; they lie beside their MTL file
// or, as some exporters have it, below `from`.
//
// A model can come from anybody, and so its names must not carry other files along or put any where
// programs would obey them. Refused are: names that lead out of the folder, also by symbolic links,
// in `from` or in `to`; names with a hidden part (.config/a.png); libraries that are none and
// textures that are no pictures, by their extension (.mtl, .png) or by their content; what is
// larger than the limits; pipes, devices and folders. Each file is copied whole or not at all
// (AtomicFile), never over another; one that is there and cannot be read or written fails and does
// not keep others from being copied. Throws Cancelled.
MaterialCopy copy_material_files(std::span<const std::string> material_libraries,
                                 const std::string& from, const std::string& to,
                                 const Progress& progress = {}, const MaterialLimits& limits = {});

}  // namespace pectin
