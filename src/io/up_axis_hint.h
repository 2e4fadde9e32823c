// What the comments of an OBJ file say about the axis that points upwards.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/up_axis.h"

namespace pectin {

// Reads the comments among the first 4 KiB of the text. Words such as "z up" or "up axis: y" count
// first. Without them, the name of the program that wrote the file does, if its OBJ files have the
// same axis up unless the user chooses another: y for Blender, ZBrush and others, which turn their
// models for this format, and z for FreeCAD and OpenSCAD, which do not. Nothing if there is no
// hint, as in files of MeshLab, which keeps the axes of what it was given, or if both axes are
// named.
std::optional<UpAxis> up_axis_hint(std::string_view text);

}  // namespace pectin
