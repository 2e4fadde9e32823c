#include "session/model_file.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "io/file_error.h"
#include "io/material_files.h"
#include "io/model_format.h"
#include "io/printable.h"

namespace pectin {
namespace {

// The fractions of the time of loading at which reading and building end.
constexpr double kRead = 0.4, kBuilt = 0.75;
// The fraction of the time of saving at which writing ends and copying material files begins.
constexpr double kWritten = 0.95;

// Combines the results of several folders. A file that one folder has is not missing in the others.
class MaterialReport {
  public:
    void add(const MaterialCopy& copy);
    SaveReport take(const std::string& folder) const;

  private:
    using Reasons = std::map<std::string, std::string>;
    static void add(const std::vector<MaterialCopy::Reason>& reasons, Reasons& all) {
        for (const MaterialCopy::Reason& reason : reasons) all.emplace(reason.name, reason.why);
    }

    std::set<std::string> copied_, missing_;
    Reasons refused_, failed_;
};

void MaterialReport::add(const MaterialCopy& copy) {
    copied_.insert(copy.copied.begin(), copy.copied.end());
    missing_.insert(copy.missing.begin(), copy.missing.end());
    add(copy.refused, refused_);
    add(copy.failed, failed_);
}

// folder: the folder into which the files are copied.
SaveReport MaterialReport::take(const std::string& folder) const {
    SaveReport report;
    const char* last_part = "";
    const auto tell = [&](const char* part, const std::string& name, const std::string& why) {
        if (part == last_part) {
            report.text += ", ";
        } else {
            report.text += (report.text.empty() ? "" : "; ") + std::string(part) + ": ";
        }
        last_part = part;
        report.text += printable(name) + (why.empty() ? "" : " (" + printable(why) + ")");
    };
    const auto is_there = [&](const std::string& name) {
        std::error_code error;
        return copied_.contains(name) ||
               std::filesystem::exists(std::filesystem::path(folder) / name, error);
    };
    for (const std::string& name : copied_) tell("material files copied", name, {});
    for (const std::string& name : missing_) {
        if (!is_there(name)) tell("material files not found", name, {});
    }
    for (const auto& [name, why] : refused_) {
        if (!copied_.contains(name)) tell("material files not copied", name, why);
    }
    for (const auto& [name, why] : failed_) {
        if (is_there(name)) continue;
        tell("material files that could not be copied", name, why);
        report.has_failed = true;
    }
    return report;
}

SaveReport copy_materials(const TriMesh& mesh, const std::string& folder,
                          std::span<const std::string> material_folders, const Progress& progress) {
    MaterialReport report;
    const auto count = static_cast<double>(material_folders.size());
    for (std::size_t i = 0; i < material_folders.size(); ++i) {
        const auto begin = static_cast<double>(i);
        report.add(copy_material_files(mesh.input_form().material_libraries, material_folders[i],
                                       folder, progress.part(begin / count, (begin + 1) / count)));
    }
    progress.advance(1.0);
    return report.take(folder);
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

LoadedModel load_model(const command::Open& open, const Progress& progress) try {
    ReadReport read_report;
    const StopToken stop([&] { return progress.is_stop_requested(); });
    LoadedModel model =
        make_model(build_mesh(read_model(open.path, progress.part(0.0, kRead), &read_report),
                              {.crease_angle = open.crease_angle}, stop));
    model.read_report = std::move(read_report);
    if (model.mesh->face_slots() == 0) {
        throw FileError(open.path,
                        "has no face with three different vertices; a model needs at least one");
    }
    model.material_folders = {material_folder(open.path)};
    progress.advance(kBuilt);
    model.tree = std::make_unique<FaceTree>(*model.mesh, stop);
    progress.advance(1.0);
    return model;
} catch (const Stopped&) {
    throw Cancelled();
}

SaveReport save_model(const TriMesh& mesh, const command::Save& save, const Progress& progress,
                      std::span<const std::string> material_folders) {
    write_model(mesh, save.path, progress.part(0.0, kWritten));
    const std::string name = printable(std::filesystem::path(save.path).filename().string());
    try {
        SaveReport report = copy_materials(mesh, material_folder(save.path), material_folders,
                                           progress.part(kWritten, 1.0));
        if (report.text.empty()) return report;
        return {name + ": " + report.text, report.has_failed};
    } catch (const Cancelled&) {
        return {name + ": not all material files were copied: cancelled", true};
    }
}

}  // namespace pectin
