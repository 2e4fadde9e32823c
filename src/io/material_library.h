// Reads material libraries (MTL files) for the names of their materials and textures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/progress.h"

namespace pectin {

struct Material {
    std::string name;  // empty for statements before the first newmtl
    // The file names in the statements map_*, bump, disp, decal, refl (six for a cube) and norm, as
    // written but without options, in no particular order.
    std::vector<std::string> textures;

    bool operator==(const Material&) const = default;
};

// Uses tinyobjloader's material parser. The parser would lose some textures, so it gets the text in
// pieces in which no statement replaces another, and its unknown parameters are searched for
// textures. Lines end and continue as in OBJ files. There are no errors: statements that do not
// belong to a material are ignored. Throws Cancelled. Cost: O(n), some microseconds per texture.
std::vector<Material> parse_materials(std::string_view text, const Progress& progress = {});

// Whether a text may be a material library. Before the first newmtl it must have known statements
// only. In all it may have as many unknown statements, such as extensions of exporters, as known
// ones. A script that names its interpreter (#!) is not a library. An empty text may be one.
bool may_be_material_library(std::string_view text);

}  // namespace pectin
