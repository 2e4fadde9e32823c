// A command done for a person: whatever goes wrong becomes a sentence.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>

#include "session/session.h"

namespace pectin {

// What `work` answers is wrong, or what it throws. Throws nothing of its own.
template <typename Work>
std::optional<std::string> complaint_about(Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return "there is not enough memory; use a lower resolution, budget or model";
    } catch (const std::exception& error) {
        return error.what();
    }
}

// What is wrong with the command; nothing if it was done.
inline std::optional<std::string> execute(Session& session, const Command& command) {
    return complaint_about([&] { return session.execute(command); });
}

}  // namespace pectin
