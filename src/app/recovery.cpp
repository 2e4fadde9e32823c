#include "app/recovery.h"

#include <sys/file.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <variant>

#include "command/script.h"
#include "io/file_error.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "recovery-";
constexpr const char* kSuffix = ".jsonl";

bool is_recovery_file(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(kPrefix) && name.ends_with(kSuffix);
}

// Whether no window has the file locked.
bool is_abandoned(const fs::path& path) {
    const FileDescriptor file(path.c_str(), O_RDONLY | O_NONBLOCK);
    return file.is_open() && ::flock(file.get(), LOCK_SH | LOCK_NB) == 0;
}

bool changes_object(const Command& command) {
    return std::holds_alternative<command::Drag>(command) ||
           std::holds_alternative<command::Control>(command) ||
           std::holds_alternative<command::Readapt>(command) ||
           std::holds_alternative<command::Bake>(command) ||
           std::holds_alternative<command::Undo>(command) ||
           std::holds_alternative<command::Redo>(command);
}

// A file that was cut off by a crash still has all lines before the last.
LostSession read_session(const fs::path& path) {
    LostSession session{.path = path.string(), .object = "untitled", .commands = {}};
    std::ifstream text(path, std::ios::binary);
    ScriptReader reader(text);
    while (auto line = reader.next()) {
        auto* const command = std::get_if<Command>(&line->command);
        if (!command) break;
        if (const auto* open = std::get_if<command::Open>(command)) {
            session.object = fs::path(open->path).filename().string();
        }
        if (const auto* save = std::get_if<command::Save>(command)) {
            session.object = fs::path(save->path).filename().string();
        }
        const bool is_kept = std::holds_alternative<command::Open>(*command) ||
                             std::holds_alternative<command::Shape>(*command) ||
                             std::holds_alternative<command::Save>(*command);
        if (is_kept) session.unsaved = 0;
        if (std::holds_alternative<command::Shape>(*command)) session.object = "untitled";
        session.unsaved += changes_object(*command);
        session.commands.push_back(std::move(*command));
    }
    return session;
}

FileDescriptor create_locked(const std::string& path) {
    FileDescriptor file(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return {};
    return file;
}

Recorder begin_file(const std::string& folder) {
    constexpr int kMostTries = 10000;  // past what earlier processes of this number have left
    std::error_code error;
    fs::create_directories(folder, error);
    for (int i = 0; i < kMostTries && !error; ++i) {
        const std::string path =
            folder + "/" + kPrefix + std::to_string(::getpid()) + "-" + std::to_string(i) + kSuffix;
        FileDescriptor file = create_locked(path);
        if (file.is_open()) return Recorder(path, std::move(file));
        if (errno != EEXIST) error.assign(errno, std::generic_category());
    }
    throw FileError(folder, "the session cannot be kept there for recovery: " + error.message());
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

void RecoveryFile::remove() {
    std::error_code ignored;
    fs::remove(path(), ignored);
}

std::vector<LostSession> find_lost_sessions(const std::string& folder) {
    std::vector<std::pair<fs::file_time_type, LostSession>> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored) || !is_recovery_file(entry->path())) continue;
        if (!is_abandoned(entry->path())) continue;
        LostSession session = read_session(entry->path());
        if (session.unsaved == 0) {
            remove_lost_session(session);
        } else {
            found.emplace_back(entry->last_write_time(ignored), std::move(session));
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::tie(b.first, b.second.path) < std::tie(a.first, a.second.path);
    });
    std::vector<LostSession> sessions;
    for (auto& [time, session] : found) sessions.push_back(std::move(session));
    return sessions;
}

void remove_lost_session(const LostSession& session) {
    std::error_code ignored;
    fs::remove(session.path, ignored);
}

bool is_restored(const Command& command) {
    return !std::holds_alternative<command::Save>(command) &&
           !std::holds_alternative<command::Stats>(command) &&
           !std::holds_alternative<command::Screenshot>(command);
}

}  // namespace pectin
