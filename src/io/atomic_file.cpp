#include "io/atomic_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "io/file_error.h"

namespace pectin {
namespace {

// Follows symbolic links to the file that writing to `path` would change. That file need not exist.
std::string follow_links(const std::string& path) {
    constexpr int kMaxLinks = 40;  // the limit of Linux
    std::filesystem::path target(path);
    std::error_code error;
    for (int i = 0; i < kMaxLinks && std::filesystem::is_symlink(target, error); ++i) {
        const auto link = std::filesystem::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / link;  // an absolute link replaces the folder
    }
    return target.string();
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path)
    : path_(path), target_(follow_links(path)), folder_(folder_of(target_)) {
    if (std::filesystem::path(target_).filename().empty()) {
        throw FileError(path_, "names a folder; give the file a name");
    }
    struct stat status {};
    const bool replaces = ::stat(target_.c_str(), &status) == 0;
    if (!replaces && errno != ENOENT) fail(errno);
    if (replaces) {
        if (S_ISDIR(status.st_mode)) fail(EISDIR);
        if (!S_ISREG(status.st_mode)) {
            throw FileError(path_, "is a device or a pipe; save to a file");
        }
        // Renaming would ignore the file's write protection.
        if (::access(target_.c_str(), W_OK) != 0) {
            throw FileError(path_, "is write-protected; allow writing or save under another name");
        }
    }
    open_temporary();
    if (replaces) {
        // Changing the owner fails without privileges, which is accepted. It comes first because
        // chown clears bits of the mode.
        if (::fchown(file_.get(), status.st_uid, status.st_gid) != 0) errno = 0;
        if (::fchmod(file_.get(), status.st_mode & 07777) != 0) errno = 0;
    }
}

AtomicFile::~AtomicFile() {
    if (!temporary_.path().empty()) ::unlink(temporary_.path().c_str());
}

void AtomicFile::open_temporary() {
    constexpr int kMaxTries = 10000;  // more than the files that killed processes may have left
    constexpr mode_t kModeOfNewFiles = 0666;  // minus the umask
    const std::string prefix = folder_ + "/.pectin-" + std::to_string(::getpid()) + "-";
    for (int i = 0; i < kMaxTries; ++i) {
        std::string name = prefix + std::to_string(i) + ".tmp";
        // The file is listed before it exists, so that a signal at any time removes it.
        TemporaryFileEntry entry(name);
        file_ = FileDescriptor(name.c_str(), O_WRONLY | O_CREAT | O_EXCL, kModeOfNewFiles);
        if (file_.is_open()) {
            temporary_ = std::move(entry);
            return;
        }
        if (errno != EEXIST) fail(errno);
    }
    fail(EEXIST);
}

void AtomicFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file_.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) fail(errno);
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::commit() {
    flush();
    if (std::rename(temporary_.path().c_str(), target_.c_str()) != 0) fail(errno);
    finish();
}

void AtomicFile::commit_new() {
    flush();
    if (::renameat2(AT_FDCWD, temporary_.path().c_str(), AT_FDCWD, target_.c_str(),
                    RENAME_NOREPLACE) != 0) {
        // Some file systems do not support RENAME_NOREPLACE. Then a file that appears between the
        // check and the renaming is replaced.
        if (errno != EINVAL && errno != ENOSYS) fail(errno);
        struct stat status {};
        if (::lstat(target_.c_str(), &status) == 0) fail(EEXIST);
        if (std::rename(temporary_.path().c_str(), target_.c_str()) != 0) fail(errno);
    }
    finish();
}

void AtomicFile::flush() {
    while (::fsync(file_.get()) != 0) {
        if (errno == EINVAL) break;  // the file system does not support it
        if (errno != EINTR) fail(errno);
    }
    if (!file_.close()) fail(errno);
}

void AtomicFile::finish() {
    temporary_ = {};
    // The new file is in place, so a failure to flush its name to the disk is ignored.
    const FileDescriptor folder(folder_.c_str(), O_RDONLY | O_DIRECTORY);
    if (folder.is_open()) ::fsync(folder.get());
}

void AtomicFile::fail(int error) const {
    switch (error) {
        case ENOENT:
            throw FileError(path_, "there is no folder " + folder_ + "; make it first");
        case ENOTDIR:
            throw FileError(path_, folder_ + " is not a folder; save to another");
        case EISDIR:
            throw FileError(path_, "is a folder; give the file another name");
        case EACCES:
        case EPERM:
            throw FileError(path_, "no permission to write in " + folder_ + "; save elsewhere");
        case EROFS:
            throw FileError(path_, folder_ + " is read-only; save elsewhere");
        case ENOSPC:
        case EDQUOT:
            throw FileError(path_, "no space left; free some or save elsewhere");
        case EFBIG:
            throw FileError(path_,
                            "is larger than files may be here (see ulimit -f, or the file "
                            "system's limit); raise the limit or save elsewhere");
        case EEXIST:
            throw FileError(path_, "is there already; it is not replaced");
        case ENAMETOOLONG:
            throw FileError(path_, "the name is too long; give it a shorter one");
        default:
            throw FileError(path_, "cannot be written: " + std::generic_category().message(error));
    }
}

void write_file_atomically(const std::string& path, std::string_view contents) {
    AtomicFile file(path);
    file.write(contents);
    file.commit();
}

}  // namespace pectin
