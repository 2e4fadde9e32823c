// Prepares text from files and paths for messages.
#pragma once

#include <string>
#include <string_view>

namespace pectin {

// The text as one line without control characters. These, including the zero byte, and bytes that
// are not UTF-8 become \x and two hexadecimal digits. All other text is unchanged. Cost: O(n).
std::string printable(std::string_view text);

// The printable() word in single quotes. A word of more than 60 bytes is shortened and ends in
// "...".
std::string quoted_word(std::string_view word);

}  // namespace pectin
