// Names of the triggers for tests that run with each of them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <tuple>

#include "command/schema.h"

namespace pectin::test {

inline std::string word_of(command::Adapt::Trigger trigger) {
    const auto& words = std::get<1>(Schema<command::Adapt>::kFields).type.words;
    return words[static_cast<std::size_t>(trigger)];
}

inline std::string name_of_trigger(const testing::TestParamInfo<command::Adapt::Trigger>& info) {
    return word_of(info.param);
}

}  // namespace pectin::test
