// What kind of file some bytes are, by the signatures at their beginning.
#pragma once

#include <cstddef>
#include <string_view>

namespace pectin {

// What recognise_file() needs of a file; it can do with less where the file is shorter.
inline constexpr std::size_t kSignatureBytes = 4096;

enum class FileCategory {
    packed,  // compressed, or an archive: a model may be in it
    text,    // text in an encoding that is not UTF-8
    model,   // a model in another format than OBJ
    image,   // pixels, as textures are
    other,
};

struct FileKind {
    FileCategory category = FileCategory::other;
    std::string_view is;  // "is a gzip file", behind the file's name; empty where unknown
    std::string_view
        advice;  // what to do in order to open it as a model; empty where nothing helps

    bool is_known() const { return !is.empty(); }
    bool is_image() const { return category == FileCategory::image; }
};

// head: the first bytes of the file, kSignatureBytes of them where it has so many. bytes: the size
// of the whole file. Knows compressed files, text in UTF-16 and UTF-32, models and pictures in
// well-known formats, and some others that come by accident, such as the page that a server sends
// in place of a file. OBJ has no signature. TGA has none at the beginning: see is_tga().
FileKind recognise_file(std::string_view head, std::size_t bytes);

// Whether the file is a TGA picture (Truevision, TGA File Format Specification 2.0, 1991). tail:
// its last bytes, at least 26 of them, where version 2 has a signature. Version 1 has none, so the
// fields of the head must agree with each other and with the size of the file.
bool is_tga(std::string_view head, std::string_view tail, std::size_t bytes);

}  // namespace pectin
