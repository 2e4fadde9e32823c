#include "io/temporary_files.h"

#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace pectin {
namespace {

struct List {
    std::mutex mutex;
    std::vector<std::string> paths;
};

List& list() {
    static List files;
    return files;
}

}  // namespace

TemporaryFileEntry::TemporaryFileEntry(std::string path) : path_(std::move(path)) {
    const std::lock_guard lock(list().mutex);
    list().paths.push_back(path_);
}

TemporaryFileEntry::~TemporaryFileEntry() {
    if (path_.empty()) return;
    const std::lock_guard lock(list().mutex);
    std::erase(list().paths, path_);
}

TemporaryFileEntry::TemporaryFileEntry(TemporaryFileEntry&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFileEntry& TemporaryFileEntry::operator=(TemporaryFileEntry&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
}

std::unique_lock<std::mutex> remove_temporary_files() noexcept {
    std::unique_lock lock(list().mutex);
    for (const std::string& path : list().paths) ::unlink(path.c_str());
    return lock;
}

}  // namespace pectin
