#include "session/model_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/file_error.h"
#include "io/material_files.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"

namespace pectin {
namespace {

// Where reading ends and building ends, of the time that loading takes.
constexpr double kRead = 0.4, kBuilt = 0.75;
// Where writing ends and copying material files begins, of the time that saving takes.
constexpr double kWritten = 0.95;

bool has_extension(const std::string& path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    return std::equal(
        extension.begin(), extension.end(),
        path.end() - static_cast<std::ptrdiff_t>(extension.size()),
        [](char y, char x) { return std::tolower(static_cast<unsigned char>(x)) == y; });
}

std::string copy_materials(const TriMesh& mesh, const std::string& folder,
                           std::span<const std::string> material_folders,
                           const Progress& progress) {
    std::string failed;
    for (const std::string& from : material_folders) {
        const MaterialCopy copy =
            copy_material_files(mesh.input_form().material_libraries, from, folder, progress);
        for (const std::string& why : copy.failed) {
            failed += (failed.empty() ? "saved, but not all of its material files: " : "; ") + why;
        }
    }
    progress.advance(1.0);
    return failed;
}

}  // namespace

std::string material_folder(const std::string& model_path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path whole = fs::absolute(model_path, error);
    return (error ? fs::path(model_path) : whole).parent_path().string();
}

LoadedModel make_model(BuiltMesh built) {
    LoadedModel model;
    model.mesh = std::make_unique<TriMesh>(std::move(built.mesh));
    model.active = std::make_unique<ActiveSet>(*model.mesh);
    model.report = built.report;
    model.box = model.mesh->bounding_box();
    return model;
}

LoadedModel load_model(const command::Open& open, const Progress& progress) {
    ReadReport read_report;
    LoadedModel model =
        make_model(build_mesh(read_obj(open.path, progress.part(0.0, kRead), &read_report),
                              {.crease_angle = open.crease_angle}));
    model.read_report = std::move(read_report);
    if (model.mesh->face_slots() == 0) {
        throw FileError(open.path,
                        "has no face with three different vertices; a model needs at least one");
    }
    model.material_folders = {material_folder(open.path)};
    progress.advance(kBuilt);
    model.tree = std::make_unique<FaceTree>(*model.mesh);
    progress.advance(1.0);
    return model;
}

std::string save_model(const TriMesh& mesh, const command::Save& save, const Progress& progress,
                       std::span<const std::string> material_folders) {
    if (!has_extension(save.path, ".obj")) {
        throw FileError(save.path, "does not end in .obj; save writes OBJ files");
    }
    write_obj(mesh, save.path, progress.part(0.0, kWritten));
    try {
        return copy_materials(mesh, material_folder(save.path), material_folders,
                              progress.part(kWritten, 1.0));
    } catch (const Cancelled&) {
        return "saved, but not all of its material files were copied: cancelled";
    }
}

}  // namespace pectin
