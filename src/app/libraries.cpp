#include "app/libraries.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <png.h>
#include <tbb/version.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace pectin {
namespace {

std::string joined(int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::string program_version() { return PECTIN_VERSION; }

std::span<const Library> libraries() {
    static const std::vector<Library> kLibraries{
        {"CLI11", joined(CLI11_VERSION_MAJOR, CLI11_VERSION_MINOR, CLI11_VERSION_PATCH)},
        {"Dear ImGui", IMGUI_VERSION},
        {"Eigen", joined(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"GLFW", joined(GLFW_VERSION_MAJOR, GLFW_VERSION_MINOR, GLFW_VERSION_REVISION)},
        {"GLM", joined(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH)},
        {"libpng", PNG_LIBPNG_VER_STRING},
        {"nlohmann-json", joined(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                 NLOHMANN_JSON_VERSION_PATCH)},
        {"oneTBB", joined(TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
    };
    return kLibraries;
}

}  // namespace pectin
