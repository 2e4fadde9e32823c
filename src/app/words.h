// Messages of the session and of files in the words of the window: full sentences that name what
// the user sees there, without coordinates and folders.
#pragma once

#include <exception>
#include <string>

#include "command/result.h"
#include "io/file_error.h"

namespace pectin {

// Makes sentences of a remark, whose parts are separated by semicolons and begin with small
// letters: "one place; undo" becomes "One place. Undo.".
std::string sentences(const std::string& remark);

// The kind of refusals whose reason is in the words of the window already.
inline constexpr const char* kInWords = "in words";

// Why something was not done.
std::string words_of(const Refusal& refusal);
// What is wrong with a file, such as "pic.png is not an OBJ model.".
std::string words_of(const FileError& error);

// The same for any error; one that is about no file is a sentence of its own.
std::string words_of(const std::exception& error);

// The kinds of refusals for which there are words of their own, for tests.
bool has_words(const std::string& kind);

}  // namespace pectin
