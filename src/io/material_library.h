// Material libraries (MTL files): the materials of OBJ files and the textures that they name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/progress.h"

namespace pectin {

struct Material {
    std::string name;  // empty for what stands before the first newmtl
    // The files that its statements name, as they are written there, in no particular order: map_*,
    // bump, disp, decal, refl (six of them for a cube) and norm, without their options.
    std::vector<std::string> textures;

    bool operator==(const Material&) const = default;
};

// Read by tinyobjloader's material parser. What it would lose is given to it in pieces that lose
// nothing, or is found among its unknown parameters. Lines end and continue as those of OBJ files.
// Nothing is an error: what is no statement of a material is ignored. Throws Cancelled.
// Cost: O(n), some microseconds for each texture.
std::vector<Material> parse_materials(std::string_view text, const Progress& progress = {});

// Whether a text may be a material library: it has none but statements that material libraries have
// before its first material, and no more others than such behind that, as extensions of exporters
// are. A script that names its interpreter (#!) is none. An empty text may be one.
bool may_be_material_library(std::string_view text);

}  // namespace pectin
