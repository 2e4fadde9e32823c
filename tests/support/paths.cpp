// Only this file knows the paths, so that a compiler cache can use all others in another folder.
#include "support/paths.h"

namespace pectin::test {

std::string source_path(const std::string& relative) {
    return std::string(PECTIN_SOURCE_DIR) + "/" + relative;
}

std::string models_folder() { return PECTIN_MODELS; }

std::string model_path(const std::string& name) { return models_folder() + "/" + name + ".obj"; }

std::string pictures_folder() { return PECTIN_PICTURES; }

std::string program_path() { return PECTIN_BINARY; }

}  // namespace pectin::test
