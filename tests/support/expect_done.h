// Executes commands that tests expect to succeed.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "session/session.h"

namespace pectin::test {

inline void expect_done(Session& session, const Command& command) {
    const Done done = session.execute(command);
    EXPECT_TRUE(done) << name(command) << ": " << done.refusal().reason;
}

// Why the session refuses the command; empty if it is done, which is a failure of the test.
inline std::string refusal_of(Session& session, const Command& command) {
    const Done done = session.execute(command);
    EXPECT_FALSE(done) << name(command) << " was done";
    return done ? std::string() : done.refusal().reason;
}

}  // namespace pectin::test
