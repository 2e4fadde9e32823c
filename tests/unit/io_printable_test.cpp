// Tests that text from files and paths becomes one line that a zero byte does not truncate.
#include "io/printable.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "io/file_error.h"
#include "io/obj_reader.h"

namespace pectin {
namespace {

TEST(Printable, KeepsTextAndEscapesControlCharacters) {
    EXPECT_EQ(printable("a b\\c \"d\" \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80"),
              "a b\\c \"d\" \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80");
    EXPECT_EQ(printable(std::string("a\0b\n\x1b[1m\x7f", 9)), "a\\x00b\\x0A\\x1B[1m\\x7F");
    EXPECT_EQ(printable("\xC2\x9B"), "\\xC2\\x9B") << "a control character of ISO 6429";
    EXPECT_EQ(printable("\xE2\x80\xAE"), "\\xE2\\x80\\xAE") << "turns the text that follows";
}

TEST(Printable, EscapesInvalidUtf8) {
    EXPECT_EQ(printable("\xFF\x80"), "\\xFF\\x80");
    EXPECT_EQ(printable("\xC3"), "\\xC3") << "cut short";
    EXPECT_EQ(printable("\xC0\xAF"), "\\xC0\\xAF") << "longer than it need be";
    EXPECT_EQ(printable("\xE0\x80\xAF"), "\\xE0\\x80\\xAF");
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80") << "a surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(Printable, QuotesAWordAndShortensALongOne) {
    EXPECT_EQ(quoted_word("v"), "'v'");
    EXPECT_EQ(quoted_word(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
    EXPECT_EQ(quoted_word(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
    EXPECT_EQ(quoted_word(std::string(59, 'x') + "\xC3\xA4 and more"),
              "'" + std::string(59, 'x') + "...'");
    EXPECT_EQ(quoted_word(std::string(5000, '\x80')).size(), 2 + 4 * 60 + 3u);
}

// The text after the zero byte says what is wrong, so it must not be lost.
TEST(Printable, KeepsTheMessagesOfFilesWithAZeroByteWhole) {
    const std::string text("v 0 0\0x 0\n", 10);
    try {
        parse_obj(text, std::string("a\0b.obj", 7));
        FAIL() << "was read";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(),
                     "a\\x00b.obj:1: '0\\x00x' is no number; numbers look like -1.5 "
                     "or 2e-3");
        EXPECT_EQ(std::strlen(error.message().c_str()), error.message().size());
    }
}

}  // namespace
}  // namespace pectin
