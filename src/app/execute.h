// A command done for a person: whatever goes wrong becomes a sentence.
#pragma once

#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include "session/session.h"

namespace pectin {

// What to say where there is no memory for something, such as "drag".
inline std::string not_enough_memory(const std::string& what, const History& history) {
    const double megabytes = 1e-6 * static_cast<double>(history.memory_bytes());
    return "not enough memory for this " + what + "; undo history takes " +
           std::to_string(std::llround(megabytes)) +
           " MB; lower its limit, or use a lower resolution, budget or model";
}

// What `work`, which does the command, answers is wrong, or what it throws.
template <typename Work>
std::optional<std::string> complaint_about(const Command& command, const Session& session,
                                           Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return not_enough_memory(name(command), session.history());
    } catch (const std::exception& error) {
        return error.what();
    }
}

// What is wrong with the command; nothing if it was done.
inline std::optional<std::string> execute(Session& session, const Command& command) {
    return complaint_about(command, session, [&] { return session.execute(command); });
}

}  // namespace pectin
