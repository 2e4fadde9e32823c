// Executes commands so that every exception becomes an error message.
#pragma once

#include <cmath>
#include <exception>
#include <new>
#include <string>

#include "command/result.h"
#include "session/session.h"

namespace pectin {

// The message for a lack of memory. what: what needed it, such as "drag".
inline std::string not_enough_memory(const std::string& what, const History& history) {
    const double megabytes = 1e-6 * static_cast<double>(history.memory_bytes());
    return "not enough memory for this " + what + "; the undo history uses " +
           std::to_string(std::llround(megabytes)) +
           " MB; lower its limit, or use a lower resolution or budget or a smaller model";
}

// Calls `work`, which does something and returns Done. Returns the same, or a refusal with the
// message of the exception that it throws. what: as for not_enough_memory().
template <typename Work>
Done try_to(const std::string& what, const Session& session, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Refusal{not_enough_memory(what, session.history())};
    } catch (const std::exception& error) {
        return Refusal{error.what()};
    }
}

// The same with work that executes the command.
template <typename Work>
Done try_command(const Command& command, const Session& session, Work work) {
    return try_to(name(command), session, work);
}

// Executes the command.
inline Done execute(Session& session, const Command& command) {
    return try_command(command, session, [&] { return session.execute(command); });
}

}  // namespace pectin
