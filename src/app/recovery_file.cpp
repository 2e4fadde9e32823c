#include "app/recovery_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include "app/command_kind.h"
#include "app/recovery_paths.h"
#include "io/file_error.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

// Models may be private, so only the owner may look into a new folder.
void create_private_folder(const std::string& folder, std::error_code& error) {
    std::error_code ignored;
    if (fs::create_directories(folder, error)) {
        fs::permissions(folder, fs::perms::owner_all, ignored);
    }
}

// Returns a closed descriptor, with the reason in errno, if the file cannot be created.
FileDescriptor create_locked(const std::string& path) {
    FileDescriptor file(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (!file.is_open() || lock_recovery_file(path, file)) return file;
    // A window that was starting has locked the new file first and treats it as a lost session.
    errno = EEXIST;
    return {};
}

Recorder begin_record(const std::string& folder) {
    constexpr int kMaxNumber = 10000;  // earlier processes with this id may have left files
    std::error_code error, ignored;
    create_private_folder(folder, error);
    for (int number = 0; number < kMaxNumber && !error; ++number) {
        const std::string path = recovery_path(folder, number);
        // A file that was set aside may still have copies of models under this number.
        if (fs::exists(set_aside_path(path), ignored)) continue;
        FileDescriptor file = create_locked(path);
        if (file.is_open()) return Recorder(path, std::move(file));
        if (errno != EEXIST) error.assign(errno, std::generic_category());
    }
    throw FileError(folder, "cannot be written: " + error.message());
}

}  // namespace

RecoveryFile::RecoveryFile(const std::string& folder) : recorder_(begin_record(folder)) {}

void RecoveryFile::record(const Command& command, const std::string& fingerprint) {
    const bool is_needed = is_restored(command) || std::holds_alternative<command::Save>(command);
    if (has_failed_ || !is_needed) return;
    try {
        const auto* open = std::get_if<command::Open>(&command);
        if (open && !fingerprint.empty()) {
            recorder_.write_comment(kFingerprintComment + fingerprint);
            std::erase_if(opened_, [&](const ModelCopy& m) { return m.from == open->path; });
            opened_.push_back({open->path, copy_path(open->path, fingerprint), fingerprint});
        }
        recorder_.record(command);
    } catch (...) {
        has_failed_ = true;
        throw;
    }
}

std::vector<ModelCopy> RecoveryFile::copies_before_save(const std::string& path) const {
    std::vector<ModelCopy> copies;
    std::error_code ignored;
    if (has_failed_) return copies;
    for (const ModelCopy& model : opened_) {
        if (!fs::exists(model.to, ignored) && fs::equivalent(model.from, path, ignored)) {
            copies.push_back(model);
        }
    }
    return copies;
}

std::string RecoveryFile::copy_path(const std::string& model,
                                    const std::string& fingerprint) const {
    return model_copy_path(path(), model, fingerprint);
}

void RecoveryFile::remove() { remove_recovery_files(path()); }

bool is_restored(const Command& command) {
    return !is_any_of<command::Save, command::Stats, command::Screenshot>(command);
}

}  // namespace pectin
