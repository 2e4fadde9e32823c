// Sentences with numbers in them, for a person to read.
#pragma once

#include <string>
#include <string_view>

namespace pectin {

// The sentence with every decimal fraction of more than four digits rounded to four: a script needs
// all of them, a person in front of a window none.
std::string rounded_numbers(std::string_view sentence);

}  // namespace pectin
