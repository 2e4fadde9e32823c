// Models from files and to files: long work that touches no session, on whatever thread.
#pragma once

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

// An object with all that follows from it alone, for Session::adopt. Behind pointers: the active
// set refers to the mesh wherever the object goes.
struct LoadedModel {
    std::unique_ptr<TriMesh> mesh;
    std::unique_ptr<ActiveSet> active;
    std::unique_ptr<FaceTree> tree;  // none: it is made when first asked for
    BuildReport report;              // what building it took
    ReadReport read_report;          // what reading its file dropped
    Box box;                         // of all its vertices
    // Where the files that its material libraries name may lie, the likeliest first; absolute.
    std::vector<std::string> material_folders{};
};

// Where the material files of the model in this file lie.
std::string material_folder(const std::string& model_path);

// Without a tree. Cost: O(n).
LoadedModel make_model(BuiltMesh built);

// Reads the file and makes a model of it, tree and all, so that neither the first pick nor the
// first drag has to wait. Throws Cancelled, FileError: read_model's, or that there is no surface.
// Cost: O(n log n).
LoadedModel load_model(const command::Open& open, const Progress& progress = {});

// What there is to tell of a model that is saved: which material files were copied along, which
// were not found, and which were not copied, and why. Empty where there are none.
struct SaveReport {
    std::string text;
    bool has_failed = false;  // a file should have been copied and could not be
};

// Writes the mesh to the file, whole or not at all, then copies the material files that are not
// there yet into its folder. Nobody may change the mesh meanwhile. Throws Cancelled (the file is as
// it was), FileError: write_model's. Cost: O(n), and that of copying.
SaveReport save_model(const TriMesh& mesh, const command::Save& save, const Progress& progress = {},
                      std::span<const std::string> material_folders = {});

}  // namespace pectin
