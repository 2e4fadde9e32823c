#include "app/recovery_paths.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "io/model_format.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "recovery-";
constexpr const char* kSuffix = ".jsonl";
constexpr const char* kSetAsideSuffix = ".incomplete";

// The common beginning of the paths of a recovery file's model copies.
std::string model_copy_prefix(const std::string& recovery_path) {
    return recovery_path.substr(0, recovery_path.size() - std::strlen(kSuffix)) + "-model-";
}

bool leads_to(const std::string& path, const FileDescriptor& file) {
    struct stat named {
    }, open{};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(file.get(), &open) == 0 &&
           named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

// Returns the variable's value if it is an absolute path. A relative one is invalid and ignored.
std::string folder_in(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && value[0] == '/' ? value : "";
}

}  // namespace

std::string recovery_folder() {
    if (const std::string state = folder_in("XDG_STATE_HOME"); !state.empty()) {
        return state + "/pectin";
    }
    const std::string home = folder_in("HOME");
    return home.empty() ? "" : home + "/.local/state/pectin";
}

std::string recovery_path(const std::string& folder, int number) {
    return folder + "/" + kPrefix + std::to_string(::getpid()) + "-" + std::to_string(number) +
           kSuffix;
}

bool is_recovery_path(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    return name.starts_with(kPrefix) && name.ends_with(kSuffix);
}

std::string set_aside_path(const std::string& recovery_path) {
    return recovery_path + kSetAsideSuffix;
}

std::string model_copy_path(const std::string& recovery_path, const std::string& model,
                            const std::string& fingerprint) {
    return model_copy_prefix(recovery_path) + fingerprint +
           std::string(format_for_reading(model).extension);
}

// Whoever holds the lock owns the file. Another window may have removed the file before the lock
// was taken, so the path is checked afterwards.
bool lock_recovery_file(const std::string& recovery_path, const FileDescriptor& file) {
    return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 &&
           leads_to(recovery_path, file);
}

// The copies are removed first: if that is interrupted, the next window still finds the others
// through the recovery file.
void remove_recovery_files(const std::string& recovery_path) {
    const std::string prefix = fs::path(model_copy_prefix(recovery_path)).filename().string();
    std::error_code error, ignored;
    std::vector<fs::path> copies;
    for (fs::directory_iterator entry(fs::path(recovery_path).parent_path(), error), end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().filename().string().starts_with(prefix)) copies.push_back(entry->path());
    }
    for (const fs::path& copy : copies) fs::remove(copy, ignored);
    fs::remove(recovery_path, ignored);
}

}  // namespace pectin
