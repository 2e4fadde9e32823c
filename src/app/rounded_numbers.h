// Messages with numbers that are easy to read.
#pragma once

#include <string>
#include <string_view>

namespace pectin {

// Rounds every decimal fraction in the sentence to four digits. All digits matter only in scripts,
// and not in a window.
std::string rounded_numbers(std::string_view sentence);

}  // namespace pectin
