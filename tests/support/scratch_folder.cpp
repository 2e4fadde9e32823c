#include "support/scratch_folder.h"

#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace pectin {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "pectin test XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for a test: " + name);
    folder_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::string ScratchFolder::path(const std::string& name) const {
    return name.empty() ? folder_.string() : (folder_ / name).string();
}

void ScratchFolder::write(const std::string& name, const std::string& contents) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << contents;
}

std::string ScratchFolder::read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path(name));
    return {std::istreambuf_iterator<char>(file), {}};
}

bool ScratchFolder::holds(const std::string& name) const { return fs::exists(path(name)); }

std::set<std::string> ScratchFolder::files(const std::string& subfolder) const {
    const std::string folder = path(subfolder);
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory())
            names.insert(entry.path().lexically_relative(folder).generic_string());
    return names;
}

}  // namespace pectin
