// Executes commands that tests expect to succeed.
#pragma once

#include <gtest/gtest.h>

#include "session/session.h"

namespace pectin::test {

inline void expect_done(Session& session, const Command& command) {
    const auto refusal = session.execute(command);
    EXPECT_FALSE(refusal.has_value()) << name(command) << ": " << *refusal;
}

}  // namespace pectin::test
