#include "app/recovery.h"

#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <variant>

#include "command/json.h"
#include "io/file_error.h"
#include "io/model_format.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "recovery-";
constexpr const char* kSuffix = ".jsonl";
constexpr const char* kSetAside = ".incomplete";
// Begins the line in front of a command that opens a model.
constexpr const char* kFingerprint = "# fingerprint: ";
constexpr const char* kHeader = "{\"pectin\": 1}";

bool is_recovery_file(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(kPrefix) && name.ends_with(kSuffix);
}

// Whether the path still leads to this open file, which another process may have removed.
bool leads_to(const std::string& path, const FileDescriptor& file) {
    struct stat named {
    }, open{};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(file.get(), &open) == 0 &&
           named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

// Whoever has the lock owns the file. It may have been removed before the lock was there, so that
// is looked at once the lock is held.
bool lock(const std::string& path, const FileDescriptor& file) {
    return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 && leads_to(path, file);
}

bool changes_object(const Command& command) {
    return std::holds_alternative<command::Drag>(command) ||
           std::holds_alternative<command::Control>(command) ||
           std::holds_alternative<command::Readapt>(command) ||
           std::holds_alternative<command::Bake>(command) ||
           std::holds_alternative<command::Undo>(command) ||
           std::holds_alternative<command::Redo>(command);
}

void add(Command command, std::string fingerprint, LostSession& session) {
    if (const auto* open = std::get_if<command::Open>(&command)) {
        session.object = fs::path(open->path).filename().string();
    }
    if (const auto* save = std::get_if<command::Save>(&command)) {
        session.object = fs::path(save->path).filename().string();
    }
    if (std::holds_alternative<command::Shape>(command)) session.object = "untitled";
    const bool is_kept = std::holds_alternative<command::Open>(command) ||
                         std::holds_alternative<command::Shape>(command) ||
                         std::holds_alternative<command::Save>(command);
    if (is_kept) session.unsaved = 0;
    session.unsaved += changes_object(command);
    session.commands.push_back(std::move(command));
    session.fingerprints.push_back(std::move(fingerprint));
}

// Reads one line into the session; whether that is possible. fingerprint: of the next model.
bool read_line(const std::string& line, std::string& fingerprint, LostSession& session) {
    if (line.starts_with(kFingerprint)) fingerprint = line.substr(std::strlen(kFingerprint));
    if (line.starts_with('#')) return true;
    auto parsed = parse_command(line);
    auto* const command = std::get_if<Command>(&parsed);
    if (!command) return false;
    const bool opens = std::holds_alternative<command::Open>(*command);
    add(std::move(*command), opens ? std::exchange(fingerprint, {}) : "", session);
    return true;
}

// Whether all of the file can be read, but for a last line that was not written to its end. Where
// that line is all that there would be to restore, it counts.
bool read_session(const std::string& path, LostSession& session) {
    session.path = path;
    session.object = "untitled";
    std::ifstream text(path, std::ios::binary);
    std::string line, fingerprint;
    if (!std::getline(text, line)) return !text.bad() && text.eof();
    // Not even the first line is whole.
    if (text.eof()) return std::string_view(kHeader).starts_with(line);
    if (check_header(line)) return false;
    while (std::getline(text, line)) {
        if (read_line(line, fingerprint, session)) continue;
        return text.eof() && session.unsaved > 0;
    }
    return !text.bad();
}

FileDescriptor create_locked(const std::string& path) {
    FileDescriptor file(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (!file.is_open() || lock(path, file)) return file;
    errno = EEXIST;  // another window has taken it for abandoned
    return {};
}

Recorder begin_file(const std::string& folder) {
    constexpr int kMostTries = 10000;  // past what earlier processes of this number have left
    std::error_code error, ignored;
    // For its owner alone, as models may be.
    if (fs::create_directories(folder, error)) {
        fs::permissions(folder, fs::perms::owner_all, ignored);
    }
    for (int i = 0; i < kMostTries && !error; ++i) {
        const std::string path =
            folder + "/" + kPrefix + std::to_string(::getpid()) + "-" + std::to_string(i) + kSuffix;
        if (fs::exists(path + kSetAside, ignored)) continue;  // and so may be its copies
        FileDescriptor file = create_locked(path);
        if (file.is_open()) return Recorder(path, std::move(file));
        if (errno != EEXIST) error.assign(errno, std::generic_category());
    }
    throw FileError(folder, "the session cannot be kept there for recovery: " + error.message());
}

// What the names of the copies begin with that belong to the recovery file.
std::string copy_prefix(const std::string& path) {
    return path.substr(0, path.size() - std::strlen(kSuffix)) + "-model-";
}

// The copy is read in the same format as the model.
std::string copy_path_for(const std::string& path, const std::string& model,
                          const std::string& fingerprint) {
    return copy_prefix(path) + fingerprint + std::string(format_for_reading(model).extension);
}

// The copies first: whatever is left then is still found.
void remove_with_copies(const std::string& path) {
    const std::string prefix = fs::path(copy_prefix(path)).filename().string();
    std::error_code error, ignored;
    std::vector<fs::path> copies;
    for (fs::directory_iterator entry(fs::path(path).parent_path(), error), end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().filename().string().starts_with(prefix)) copies.push_back(entry->path());
    }
    for (const fs::path& copy : copies) fs::remove(copy, ignored);
    fs::remove(path, ignored);
}

}  // namespace

std::string recovery_folder() {
    const auto folder_in = [](const char* variable) -> std::string {
        const char* const value = std::getenv(variable);
        return value && value[0] == '/' ? value : "";  // a relative one is invalid, and ignored
    };
    if (const std::string state = folder_in("XDG_STATE_HOME"); !state.empty()) {
        return state + "/pectin";
    }
    const std::string home = folder_in("HOME");
    return home.empty() ? "" : home + "/.local/state/pectin";
}

RecoveryFile::RecoveryFile(const std::string& folder) : recorder_(begin_file(folder)) {}

void RecoveryFile::record(const Command& command, const std::string& fingerprint) {
    const bool is_needed = is_restored(command) || std::holds_alternative<command::Save>(command);
    if (has_failed_ || !is_needed) return;
    try {
        const auto* open = std::get_if<command::Open>(&command);
        if (open && !fingerprint.empty()) {
            recorder_.remark(std::string(kFingerprint).substr(2) + fingerprint);
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
    return copy_path_for(path(), model, fingerprint);
}

void RecoveryFile::remove() { remove_with_copies(path()); }

LostSessions find_lost_sessions(const std::string& folder) {
    std::vector<std::pair<fs::file_time_type, LostSession>> found;
    LostSessions lost;
    std::vector<fs::path> files;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->is_regular_file(ignored) && is_recovery_file(entry->path())) {
            files.push_back(entry->path());
        }
    }
    for (const fs::path& file : files) {
        FileDescriptor descriptor(file.c_str(), O_RDWR | O_NONBLOCK);
        if (!lock(file, descriptor)) continue;
        LostSession session;
        session.lock = std::move(descriptor);
        if (!read_session(file, session)) {
            lost.damaged.push_back(set_aside(file));
        } else if (session.unsaved == 0) {
            remove_lost_session(session);
        } else {
            found.emplace_back(fs::last_write_time(file, ignored), std::move(session));
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::tie(b.first, b.second.path) < std::tie(a.first, a.second.path);
    });
    for (auto& [time, session] : found) lost.sessions.push_back(std::move(session));
    return lost;
}

std::string copy_path(const LostSession& session, const std::string& model,
                      const std::string& fingerprint) {
    return copy_path_for(session.path, model, fingerprint);
}

void remove_lost_session(const LostSession& session) { remove_with_copies(session.path); }

std::string set_aside(const std::string& session_path) {
    const std::string kept = session_path + kSetAside;
    std::error_code error;
    fs::rename(session_path, kept, error);
    return error ? session_path : kept;
}

bool is_restored(const Command& command) {
    return !std::holds_alternative<command::Save>(command) &&
           !std::holds_alternative<command::Stats>(command) &&
           !std::holds_alternative<command::Screenshot>(command);
}

}  // namespace pectin
