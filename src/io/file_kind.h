// Recognises the kind of a file by the signature at its beginning.
#pragma once

#include <cstddef>
#include <string_view>

namespace pectin {

// The number of bytes that recognise_file() needs; fewer if the file is shorter.
inline constexpr std::size_t kSignatureBytes = 4096;

enum class FileCategory {
    packed,  // compressed or an archive, which may contain a model
    text,    // text in an encoding that is not UTF-8
    model,   // a model in a format other than OBJ
    image,   // a picture, which may be a texture
    other,
};

struct FileKind {
    FileCategory category = FileCategory::other;
    std::string_view is;      // follows the file's name: "is a gzip file"; empty if unknown
    std::string_view advice;  // how to open it as a model; empty if nothing helps

    bool is_known() const { return !is.empty(); }
    bool is_image() const { return category == FileCategory::image; }
};

// Recognises compressed files, text in UTF-16 and UTF-32, models and pictures in well-known
// formats, and some others that are opened by accident, such as the web page that a server sends
// instead of a file. OBJ has no signature. TGA has none at the beginning: see is_tga().
// head: the first kSignatureBytes bytes of the file, or all if it has fewer.
// bytes: the size of the whole file.
FileKind recognise_file(std::string_view head, std::size_t bytes);

// Whether the file is a TGA picture (Truevision. TGA File Format Specification, version 2.0. 1991).
// Version 2 has a signature at the end. Version 1 has none, so the fields of the header must agree
// with each other and with the size of the file.
// head: as for recognise_file(). tail: at least the last 26 bytes, or all if it has fewer.
bool is_tga(std::string_view head, std::string_view tail, std::size_t bytes);

}  // namespace pectin
