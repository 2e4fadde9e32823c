// The table of file formats that models are read from and written to.
//
// To add a format, write its reader (and writer) in a file of this module and add a line to
// kFormats in model_format.cpp. Opening, saving, the file browser and messages use this table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/progress.h"
#include "io/read_report.h"
#include "mesh/indexed_face_set.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct ModelFormat {
    std::string_view name;       // for messages: "OBJ"
    std::string_view extension;  // in lower case with its dot: ".obj"
    // Reads a model. report: receives what was dropped, if not null. Throws FileError, Cancelled.
    IndexedFaceSet (*read)(const std::string& path, const Progress& progress, ReadReport* report);
    // Writes a model, whole or not at all; null for a format that is only read.
    // Throws FileError, Cancelled.
    void (*write)(const TriMesh& mesh, const std::string& path, const Progress& progress);
};

// All formats. The first can be written, and models without a file name are saved in it.
std::span<const ModelFormat> model_formats();

// The extensions of all formats that can be read or written; the first format's comes first.
std::vector<std::string> readable_extensions();
std::vector<std::string> writable_extensions();

// Whether write_model() writes files with the extension of this path.
bool has_writable_format(const std::string& path);

// Whether the path ends in the extension, in upper or lower case. extension: in lower case.
bool has_extension(std::string_view path, std::string_view extension);

// The format in which read_model() reads the file: that of its extension. Files with other
// extensions are read in the first format, whose reader says what kind of file it cannot read.
const ModelFormat& format_for_reading(const std::string& path);

// Reads a model. report: receives what was dropped, if not null. Throws FileError, Cancelled.
// Cost: O(n).
IndexedFaceSet read_model(const std::string& path, const Progress& progress = {},
                          ReadReport* report = nullptr);

// Writes the file in the format of its extension, whole or not at all. Throws FileError, also if no
// format with this extension can be written, and Cancelled. Cost: O(n).
void write_model(const TriMesh& mesh, const std::string& path, const Progress& progress = {});

}  // namespace pectin
