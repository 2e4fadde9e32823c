#include "app/lost_sessions.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

#include "app/command_kind.h"
#include "app/recorder.h"
#include "app/recovery_paths.h"
#include "command/json.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUntitled = "untitled";

bool changes_object(const Command& command) {
    return is_any_of<command::Drag, command::Control, command::Readapt, command::Bake,
                     command::Undo, command::Redo>(command);
}

// The object's name after a command that begins a new object or saves the present one.
std::optional<std::string> object_name_after(const Command& command) {
    const auto name_of = [](const std::string& path) { return fs::path(path).filename().string(); };
    if (const auto* open = std::get_if<command::Open>(&command)) return name_of(open->path);
    if (const auto* save = std::get_if<command::Save>(&command)) return name_of(save->path);
    if (std::holds_alternative<command::Shape>(command)) return kUntitled;
    return std::nullopt;
}

void add(Command command, std::string fingerprint, LostSession& session) {
    if (const auto name = object_name_after(command)) {
        session.object = *name;
        session.unsaved = 0;
    }
    session.unsaved += changes_object(command);
    session.commands.push_back(std::move(command));
    session.fingerprints.push_back(std::move(fingerprint));
}

// Reads one line into the session. Returns whether that is possible.
// fingerprint: of the next model to be opened, carried from one line to the next.
bool read_line(const std::string& line, std::string& fingerprint, LostSession& session) {
    const std::string mark = std::string("# ") + kFingerprintComment;
    if (line.starts_with(mark)) fingerprint = line.substr(mark.size());
    if (line.starts_with('#')) return true;
    auto parsed = parse_command(line);
    auto* const command = std::get_if<Command>(&parsed);
    if (!command) return false;
    const bool opens = std::holds_alternative<command::Open>(*command);
    add(std::move(*command), opens ? std::exchange(fingerprint, {}) : "", session);
    return true;
}

// Returns whether the whole file can be read. An incomplete last line may be skipped, but not if
// there are no unsaved changes before it: then that line is all that could be restored.
bool read_session(const std::string& path, LostSession& session) {
    session.path = path;
    session.object = kUntitled;
    std::ifstream text(path, std::ios::binary);
    std::string line, fingerprint;
    if (!std::getline(text, line)) return !text.bad() && text.eof();
    const bool is_cut_off = text.eof();
    if (is_cut_off) return std::string_view(kScriptHeader).starts_with(line);
    if (!check_header(line)) return false;
    while (std::getline(text, line)) {
        if (read_line(line, fingerprint, session)) continue;
        return text.eof() && session.unsaved > 0;
    }
    return !text.bad();
}

std::vector<fs::path> recovery_files(const std::string& folder) {
    std::vector<fs::path> files;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->is_regular_file(ignored) && is_recovery_path(entry->path())) {
            files.push_back(entry->path());
        }
    }
    return files;
}

}  // namespace

LostSessions find_lost_sessions(const std::string& folder) {
    std::vector<std::pair<fs::file_time_type, LostSession>> found;
    LostSessions lost;
    std::error_code ignored;
    for (const fs::path& file : recovery_files(folder)) {
        FileDescriptor descriptor(file.c_str(), O_RDWR | O_NONBLOCK);
        if (!lock_recovery_file(file, descriptor)) continue;
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
    return model_copy_path(session.path, model, fingerprint);
}

void remove_lost_session(const LostSession& session) { remove_recovery_files(session.path); }

std::string set_aside(const std::string& recovery_path) {
    const std::string kept = set_aside_path(recovery_path);
    std::error_code error;
    fs::rename(recovery_path, kept, error);
    return error ? recovery_path : kept;
}

}  // namespace pectin
