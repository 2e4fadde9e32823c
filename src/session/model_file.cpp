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

bool has_extension(const std::string& path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    return std::equal(
        extension.begin(), extension.end(),
        path.end() - static_cast<std::ptrdiff_t>(extension.size()),
        [](char y, char x) { return std::tolower(static_cast<unsigned char>(x)) == y; });
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
    LoadedModel model = make_model(build_mesh(read_obj(open.path, progress.part(0.0, kRead)),
                                              {.crease_angle = open.crease_angle}));
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

void save_model(const TriMesh& mesh, const command::Save& save, const Progress& progress,
                std::span<const std::string> material_folders) {
    if (!has_extension(save.path, ".obj")) {
        throw FileError(save.path, "does not end in .obj; save writes OBJ files");
    }
    const std::string folder = material_folder(save.path);
    for (const std::string& from : material_folders) {
        copy_material_files(mesh.input_form().material_libraries, from, folder,
                            progress.part(0.0, 0.0));
    }
    write_obj(mesh, save.path, progress);
}

}  // namespace pectin
