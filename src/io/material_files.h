// The files that an OBJ names beside itself: material libraries (MTL) and their textures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/progress.h"

namespace pectin {

// Paths below the folders, with slashes, sorted, each once.
struct MaterialCopy {
    std::vector<std::string> copied;
    std::vector<std::string> missing;  // named, but in neither folder or not to be read
    std::vector<std::string> outside;  // absolute or leading out of the folder: not looked at
    std::vector<std::string> failed;   // sentences: what could not be copied, and why
};

// Copies the MTL files that the mtllib statements name, and the textures that those name, from the
// folder `from` into the folder `to`, below the same names; subfolders are made as needed. What is
// in `to` already stays as it is, and so does everything where both are one folder or where there
// is no folder `to`.
//
// material_libraries: as IndexedFaceSet has them; each names one file, also with blanks, or several
// that end in .mtl. Textures lie beside their MTL file or, as some exporters have it, below `from`;
// they are named by map_*, bump, disp, decal, refl and norm, behind options, with slashes or
// backslashes.
//
// Symbolic links that lead out of the folder are not followed, neither in `from` nor in `to`. Each
// file is copied whole or not at all (AtomicFile); one that cannot be does not keep others from
// being copied. Throws Cancelled.
MaterialCopy copy_material_files(std::span<const std::string> material_libraries,
                                 const std::string& from, const std::string& to,
                                 const Progress& progress = {});

}  // namespace pectin
