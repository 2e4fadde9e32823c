// Loads and saves models. This may take long, uses no session, and may run on any thread. It calls
// the readers and writers of io; docs/architecture.md says how to add a format.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "command/command.h"
#include "geometry/box.h"
#include "io/progress.h"
#include "io/read_report.h"
#include "mesh/active_set.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// An object with the data that depends on it alone, for Session::adopt(). It is on the heap, since
// the active set refers to the mesh.
struct LoadedModel {
    std::unique_ptr<TriMesh> mesh;
    std::unique_ptr<ActiveSet> active;
    std::unique_ptr<FaceTree> tree;  // null if it is to be built when first needed
    BuildReport report;              // what building the mesh has found
    ReadReport read_report;          // what reading the file has dropped
    Box box;                         // of all vertices
    // Absolute paths of the folders that may contain the material files, the most likely first.
    std::vector<std::string> material_folders{};
};

// As many splits as a drag may make by default where it moves few faces. They take some 30 MB.
inline constexpr std::uint32_t kPreparedSplits = 100'000;

// The folder of the material files of the model in this file.
std::string material_folder(const std::string& model_path);

// Makes a model without a tree. Cost: O(n).
LoadedModel make_model(BuiltMesh built);

// Reads the file and makes a model with a tree, so that neither the first pick nor the first drag
// has to wait. Throws Cancelled, and FileError if read_model() does or if the file contains no
// surface. Cost: O(n log n).
LoadedModel load_model(const command::Open& open, const Progress& progress = {});

// Reports which material files were copied with a saved model, which were not found, and which were
// not copied and why. Empty if there are none.
struct SaveReport {
    std::string text;
    bool has_failed = false;  // a file that should have been copied could not be copied
};

// Writes the mesh to the file, completely or not at all, and then copies the material files that
// its folder lacks. Precondition: nobody changes the mesh meanwhile. Throws Cancelled, and
// FileError if write_model() does; the file is then unchanged. Cost: O(n), and that of copying.
SaveReport save_model(const TriMesh& mesh, const command::Save& save, const Progress& progress = {},
                      std::span<const std::string> material_folders = {});

}  // namespace pectin
