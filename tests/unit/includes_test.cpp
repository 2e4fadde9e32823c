// Checks every #include line of src/ against a table of the modules that each module may include,
// and of the files that may include each library.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/paths.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using Modules = std::set<std::string>;

const std::map<std::string, Modules>& modules_known_to() {
    static const std::map<std::string, Modules> kTable{
        {"geometry", {}},
        {"mesh", {"geometry"}},
        {"ffd", {"geometry"}},
        {"command", {"geometry"}},
        {"embedding", {"geometry", "mesh", "ffd"}},
        {"adapt", {"geometry", "mesh", "ffd", "embedding"}},
        {"io", {"geometry", "mesh"}},
        {"session", {"geometry", "mesh", "ffd", "command", "embedding", "adapt", "io"}},
        {"render", {"geometry", "mesh", "ffd"}},
        {"app",
         {"geometry", "mesh", "ffd", "command", "embedding", "adapt", "io", "session", "render"}}};
    return kTable;
}

struct Restricted {
    std::string header;              // the beginning of its name
    std::vector<std::string> users;  // beginnings of the paths of files that may include it
};

const std::vector<Restricted>& restricted_headers() {
    static const std::vector<Restricted> kTable{
        {"tiny_obj_loader", {"io/material_library.cpp"}},
        {"png.h", {"io/png.cpp", "app/libraries.cpp"}},
        {"nlohmann/", {"command/json_values.h", "app/preferences.cpp", "app/libraries.cpp"}},
        {"CLI/", {"app/"}},
        {"Eigen/", {"ffd/", "geometry/error_ellipsoid.cpp", "app/libraries.cpp"}},
        {"eigen3/", {"ffd/"}},
        {"GLFW/", {"app/"}},
        {"GL/", {"render/", "app/"}},
        {"EGL/", {"render/", "app/"}},
        {"GLES", {"render/", "app/"}},
        {"glad/", {"render/", "app/"}},
        {"KHR/", {"render/", "app/"}},
        {"imgui", {"render/", "app/ui/", "app/window.cpp", "app/libraries.cpp"}},
        {"thread", {"app/", "geometry/parallel.cpp", "io/timed_calls.cpp"}},
        {"tbb/", {"geometry/parallel.cpp", "app/libraries.cpp"}},
        {"future", {"app/"}}};
    return kTable;
}

// Folders within a module that may not include some headers of the same module.
struct Separated {
    std::string folder;
    std::vector<std::string> others;  // beginnings of the headers that its files may not include
};

const std::vector<Separated>& separated_folders() {
    // Tools know the editor only as ToolContext, and nobody knows a single tool except the list of
    // tools and the table of actions.
    static const std::vector<Separated> kTable{
        {"app/tools/", {"app/ui/", "app/host/", "app/editor"}}, {"app/ui/", {"app/tools/"}}};
    return kTable;
}

// Returns what is wrong with a line of the file at `path`, relative to src/, or nothing.
std::optional<std::string> complaint(const std::string& path, const std::string& line) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]*)[>"].*)");
    std::smatch match;
    if (!std::regex_match(line, match, kInclude)) return std::nullopt;
    const std::string target = match[2];
    const std::string module = path.substr(0, path.find('/'));
    const auto known = modules_known_to().find(module);
    if (known == modules_known_to().end())
        return path + ": the module " + module + " is not in the table";
    for (const Restricted& restricted : restricted_headers())
        if (target.starts_with(restricted.header) &&
            std::none_of(restricted.users.begin(), restricted.users.end(),
                         [&path](const std::string& user) { return path.starts_with(user); }))
            return path + ": <" + target + "> is not for this file";
    const std::string other = target.substr(0, target.find('/'));
    if (match[1] == "<") {
        if (modules_known_to().contains(other))
            return path + ": \"" + target + "\" is the project's own and takes quotes";
        return std::nullopt;
    }
    // A header of a library in quotes would bypass the table of modules.
    if (target.find('/') == target.npos || !modules_known_to().contains(other))
        return path + ": \"" + target + "\" does not begin with a module of the table";
    if (target.find("..") != target.npos) return path + ": \"" + target + "\" climbs out";
    if (other != module && !known->second.contains(other))
        return path + ": " + module + " may not include " + other + " (" + target + ")";
    for (const Separated& separated : separated_folders())
        for (const std::string& header : separated.others)
            if (path.starts_with(separated.folder) && target.starts_with(header))
                return path + ": " + separated.folder + " may not include " + target;
    return std::nullopt;
}

bool is_source(const fs::path& path) {
    static const Modules kExtensions{".h", ".cpp", ".hpp", ".cc", ".c", ".inl", ".ipp"};
    return kExtensions.contains(path.extension().string());
}

TEST(Includes, FollowTheTable) {
    const fs::path root = test::source_path("src");
    int files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        if (!entry.is_regular_file() || !is_source(entry.path())) continue;
        ++files;
        const std::string path = entry.path().lexically_relative(root).generic_string();
        EXPECT_NE(path.find('/'), path.npos) << path << " is in no module";
        std::ifstream text(entry.path());
        ASSERT_TRUE(text) << path;
        for (std::string line; std::getline(text, line);) {
            const auto wrong = complaint(path, line);
            EXPECT_FALSE(wrong) << *wrong;
        }
    }
    EXPECT_GT(files, 20) << "under " << root << "; was anything read?";
}

TEST(Includes, AreReportedIfTheyBreakTheTable) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"geometry/box.h", "#include \"mesh/tri_mesh.h\""},
        {"mesh/tri_mesh.h", "#include \"ffd/lattice.h\""},
        {"ffd/lattice.cpp", "  #  include   \"mesh/ids.h\"  // why"},
        {"command/json.cpp", "#include \"session/session.h\""},
        {"adapt/refine.cpp", "#include \"command/command.h\""},
        {"io/obj.cpp", "#include \"command/command.h\""},
        {"session/session.cpp", "#include \"app/replay.h\""},
        {"session/session.cpp", "#include \"render/gpu_mesh.h\""},
        {"render/gpu_mesh.cpp", "#include \"session/session.h\""},
        {"kitchen/sink.h", "#include <vector>"},
        {"mesh/split.cpp", "#include \"kitchen/sink.h\""},
        {"mesh/split.cpp", "#include \"tri_mesh.h\""},
        {"mesh/split.cpp", "#include \"mesh/../session/session.h\""},
        {"mesh/split.cpp", "#include <session/session.h>"},
        {"io/obj_reader.cpp", "#include <tiny_obj_loader.h>"},
        {"mesh/split.cpp", "#include \"tiny_obj_loader.h\""},
        {"command/json_format.cpp", "#include <nlohmann/json.hpp>"},
        {"command/json.h", "#include <nlohmann/json_fwd.hpp>"},
        {"command/command.cpp", "#include <CLI/CLI.hpp>"},
        {"session/gesture.cpp", "#include <Eigen/Dense>"},
        {"session/gesture.cpp", "#include <thread>"},
        {"session/session.cpp", "#include <GL/gl.h>"},
        {"io/png.cpp", "#include <imgui.h>"},
        {"render/canvas.cpp", "#include <png.h>"},
        {"render/canvas.cpp", "#include \"io/png.h\""},
        {"session/viewport.h", "#include \"render/canvas.h\""},
        {"render/host.cpp", "#include <GLFW/glfw3.h>"},
        {"app/tools/pin_tool.cpp", "#include \"app/ui/interface.h\""},
        {"app/tools/pin_tool.h", "#include \"app/editor.h\""},
        {"app/tools/pin_tool.h", "#include \"app/editor_scene.h\""},
        {"app/ui/interface.cpp", "#include \"app/tools/pin_tool.h\""}};
    for (const auto& [path, line] : bad) EXPECT_TRUE(complaint(path, line)) << path << ": " << line;
}

TEST(Includes, AreAcceptedIfTheyFollowTheTable) {
    const std::vector<std::pair<std::string, std::string>> good{
        {"geometry/box.h", "#include \"geometry/vec.h\""},
        {"mesh/tri_mesh.h", "#include \"geometry/vec.h\""},
        {"adapt/refine.cpp", "#include \"ffd/drag_field.h\""},
        {"session/session.cpp", "#include \"io/obj_reader.h\""},
        {"app/main.cpp", "#include \"session/session.h\""},
        {"app/main.cpp", "#include <CLI/CLI.hpp>"},
        {"app/window.cpp", "#include <GLFW/glfw3.h>"},
        {"render/pass.cpp", "#include <glad/glad.h>"},
        {"ffd/drag_solver.cpp", "#include <Eigen/Dense>"},
        {"io/png.cpp", "#include <png.h>"},
        {"command/json_values.h", "#include <nlohmann/json.hpp>"},
        {"app/tools/pin_tool.cpp", "#include \"app/tool_context.h\""},
        {"app/tools/pin_tool.cpp", "#include \"render/overlay.h\""},
        {"app/actions.cpp", "#include \"app/tools/pin_tool.h\""},
        {"app/ui/interface.cpp", "#include \"app/editor.h\""},
        {"mesh/split.cpp", "#include <vector>"},
        {"mesh/split.cpp", "// #include \"session/session.h\""},
        {"mesh/split.cpp", "split(edge);"}};
    for (const auto& [path, line] : good) {
        const auto wrong = complaint(path, line);
        EXPECT_FALSE(wrong) << *wrong;
    }
}

}  // namespace
}  // namespace pectin
