#include "app/replay.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "app/execute.h"
#include "app/offscreen_viewport.h"
#include "command/script.h"
#include "io/printable.h"
#include "session/session.h"

namespace pectin {

namespace {

bool replay_lines(std::istream& text, const std::string& title, const std::string& folder,
                  std::ostream& errors, ReplayStatus& status) {
    OffscreenViewport viewport;
    Session session;
    session.set_viewport(&viewport);
    ScriptReader reader(text);
    bool is_all_done = true;
    while (std::optional<ScriptLine> line = reader.next()) {
        const auto report = [&](const std::string& command, const std::string& what) {
            errors << printable(title) << ':' << line->number << ": " << printable(command) << ": "
                   << printable(what) << '\n';
        };
        const auto refuse = [&](const std::string& command, const std::string& what) {
            report(command, what);
            return false;
        };
        if (const auto* error = std::get_if<CommandError>(&line->command))
            return refuse(error->command, error->what);
        auto& command = std::get<Command>(line->command);
        resolve_paths(command, folder);
        status.begin(title, line->number, name(command));
        const Done done = execute(session, command);
        if (!done) return refuse(name(command), done.refusal().reason);
        status.finish();
        if (!session.remark().empty()) report(name(command), session.remark());
        if (session.has_failed_partly()) is_all_done = false;
    }
    return is_all_done;
}

}  // namespace

void ReplayStatus::begin(std::string title, std::size_t line, std::string command) {
    const std::lock_guard lock(mutex_);
    title_ = std::move(title);
    line_ = line;
    command_ = std::move(command);
}

void ReplayStatus::finish() {
    const std::lock_guard lock(mutex_);
    command_.clear();
    ++done_;
}

std::string ReplayStatus::exit_message(const std::string& signal) const {
    const std::lock_guard lock(mutex_);
    const std::string commands = done_ == 1 ? "1 command" : std::to_string(done_) + " commands";
    const std::string are_done = done_ == 1 ? " is done" : " are done";
    if (command_.empty()) return "pectin: ended by " + signal + "; " + commands + are_done;
    return printable(title_) + ":" + std::to_string(line_) + ": " + command_ + ": ended by " +
           signal + "; " + commands + " before it" + are_done;
}

bool replay(const std::string& script_path, std::ostream& errors, ReplayStatus& status) {
    if (script_path == "-") return replay_lines(std::cin, "standard input", "", errors, status);
    const auto refuse = [&](const std::string& why) {
        errors << printable(script_path) << ": cannot be read: " << why
               << "; give the path of a script\n";
        return false;
    };
    if (std::error_code ignored; std::filesystem::is_directory(script_path, ignored))
        return refuse("it is a folder");
    std::ifstream text(script_path, std::ios::binary);
    if (!text) return refuse(std::strerror(errno));
    return replay_lines(text, script_path,
                        std::filesystem::path(script_path).parent_path().string(), errors, status);
}

}  // namespace pectin
