// A command done for a person: whatever goes wrong becomes a sentence.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>

#include "session/session.h"

namespace pectin {

// What is wrong with the command; nothing if it was done. Throws nothing of its own.
inline std::optional<std::string> execute(Session& session, const Command& command) {
    try {
        return session.execute(command);
    } catch (const std::bad_alloc&) {
        return "there is not enough memory; use a lower resolution, budget or model";
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace pectin
