// Text from files and paths, made fit to be shown in a message.
#pragma once

#include <string>
#include <string_view>

namespace pectin {

// The text in one line that any terminal and any C string can hold: control characters (the zero
// byte among them) and bytes that are not UTF-8 become \x and two hexadecimal digits. All other
// text stays as it is. Cost: O(n).
std::string printable(std::string_view text);

// The same between single quotes, for a word of a file inside a message. A word of more than 60
// bytes is shortened; it ends in "..." then.
std::string quoted_word(std::string_view word);

}  // namespace pectin
