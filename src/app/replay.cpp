#include "app/replay.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/execute.h"
#include "app/offscreen_viewport.h"
#include "command/script.h"
#include "io/printable.h"
#include "session/session.h"

namespace pectin {

namespace {

bool replay_lines(std::istream& text, const std::string& title, const std::string& folder,
                  std::ostream& errors) {
    OffscreenViewport viewport;
    Session session;
    session.set_viewport(&viewport);
    ScriptReader reader(text);
    bool is_all_done = true;
    while (std::optional<ScriptLine> line = reader.next()) {
        const auto tell = [&](const std::string& command, const std::string& what) {
            errors << printable(title) << ':' << line->number << ": " << printable(command) << ": "
                   << printable(what) << '\n';
        };
        const auto refuse = [&](const std::string& command, const std::string& what) {
            tell(command, what);
            return false;
        };
        if (const auto* error = std::get_if<CommandError>(&line->command))
            return refuse(error->command, error->what);
        auto& command = std::get<Command>(line->command);
        resolve_paths(command, folder);
        if (const auto what = execute(session, command)) return refuse(name(command), *what);
        if (!session.remark().empty()) tell(name(command), session.remark());
        if (session.has_failed_partly()) is_all_done = false;
    }
    return is_all_done;
}

}  // namespace

bool replay(const std::string& script_path, std::ostream& errors) {
    if (script_path == "-") return replay_lines(std::cin, "standard input", "", errors);
    const auto refuse = [&](const std::string& why) {
        errors << printable(script_path) << ": cannot be read: " << why << "; give the path of a script\n";
        return false;
    };
    if (std::error_code ignored; std::filesystem::is_directory(script_path, ignored))
        return refuse("it is a folder");
    std::ifstream text(script_path, std::ios::binary);
    if (!text) return refuse(std::strerror(errno));
    return replay_lines(text, script_path,
                        std::filesystem::path(script_path).parent_path().string(), errors);
}

}  // namespace pectin
