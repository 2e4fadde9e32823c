// The signatures come from the database of file(1) and from the specifications of the formats.
#include "io/file_kind.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace pectin {
namespace {

using namespace std::string_view_literals;
using enum FileCategory;

constexpr std::string_view kUnpack = "unpack it and open the OBJ file in it";
constexpr std::string_view kExport = "open it in a program that reads it, and export it as OBJ";
constexpr std::string_view kUtf8 = "save it as UTF-8 and open it again";

struct Signature {
    std::size_t offset;
    std::string_view bytes;
    FileKind kind;
};

// The first match counts, so a longer signature precedes one that is a prefix of it.
constexpr std::array kSignatures{
    Signature{0, "\x1f\x8b"sv, {packed, "is a gzip file", kUnpack}},
    Signature{0, "PK\x03\x04"sv, {packed, "is a zip archive", kUnpack}},
    Signature{0, "PK\x05\x06"sv, {packed, "is an empty zip archive", kUnpack}},
    Signature{0, "\x28\xb5\x2f\xfd"sv, {packed, "is a zstd file", kUnpack}},
    Signature{0,
              "\xfd"
              "7zXZ\0"sv,
              {packed, "is an xz file", kUnpack}},
    Signature{0, "BZh"sv, {packed, "is a bzip2 file", kUnpack}},
    Signature{0, "7z\xbc\xaf\x27\x1c"sv, {packed, "is a 7z archive", kUnpack}},
    Signature{0, "Rar!\x1a\x07"sv, {packed, "is a rar archive", kUnpack}},
    Signature{0, "\x04\x22\x4d\x18"sv, {packed, "is an lz4 file", kUnpack}},
    Signature{0, "LZIP\x01"sv, {packed, "is an lzip file", kUnpack}},
    Signature{0, "\x1f\x9d"sv, {packed, "is a compress (.Z) file", kUnpack}},
    Signature{257, "ustar"sv, {packed, "is a tar archive", kUnpack}},

    Signature{0, "\xff\xfe\0\0"sv, {text, "is text in UTF-32", kUtf8}},
    Signature{0, "\0\0\xfe\xff"sv, {text, "is text in UTF-32", kUtf8}},
    Signature{0, "\xff\xfe"sv, {text, "is text in UTF-16", kUtf8}},
    Signature{0, "\xfe\xff"sv, {text, "is text in UTF-16", kUtf8}},

    Signature{0, "ply\n"sv, {model, "is a PLY model", kExport}},
    Signature{0, "ply\r"sv, {model, "is a PLY model", kExport}},
    Signature{0, "glTF"sv, {model, "is a binary glTF model (GLB)", kExport}},
    Signature{0, "Kaydara FBX Binary"sv, {model, "is an FBX model", kExport}},
    Signature{0, "; FBX "sv, {model, "is an FBX model", kExport}},
    Signature{0, "BLENDER"sv, {model, "is a Blender file", kExport}},
    Signature{0, "OFF\n"sv, {model, "is an OFF model", kExport}},
    Signature{0, "OFF\r"sv, {model, "is an OFF model", kExport}},
    Signature{0, "COFF"sv, {model, "is an OFF model", kExport}},
    Signature{0, "NOFF"sv, {model, "is an OFF model", kExport}},
    Signature{0, "PXR-USDC"sv, {model, "is a USD model", kExport}},
    Signature{0, "#usda"sv, {model, "is a USD model", kExport}},
    Signature{0, "//Maya ASCII"sv, {model, "is a Maya file", kExport}},
    Signature{8, "LWO2"sv, {model, "is a LightWave model", kExport}},
    Signature{8, "LWOB"sv, {model, "is a LightWave model", kExport}},
    Signature{0, "Ogawa"sv, {model, "is an Alembic file", kExport}},
    Signature{0, "ISO-10303-21"sv, {model, "is a STEP file", kExport}},
    Signature{0, "#VRML"sv, {model, "is a VRML model", kExport}},

    Signature{0, "\x89PNG\r\n\x1a\n"sv, {image, "is a PNG picture", ""}},
    Signature{0, "\xff\xd8\xff"sv, {image, "is a JPEG picture", ""}},
    Signature{0, "GIF87a"sv, {image, "is a GIF picture", ""}},
    Signature{0, "GIF89a"sv, {image, "is a GIF picture", ""}},
    Signature{0, "II*\0"sv, {image, "is a TIFF picture", ""}},
    Signature{0, "MM\0*"sv, {image, "is a TIFF picture", ""}},
    Signature{0, "II+\0"sv, {image, "is a TIFF picture", ""}},
    Signature{0, "MM\0+"sv, {image, "is a TIFF picture", ""}},
    Signature{0, "\x76\x2f\x31\x01"sv, {image, "is an OpenEXR picture", ""}},
    Signature{0, "#?RADIANCE"sv, {image, "is a Radiance HDR picture", ""}},
    Signature{0, "#?RGBE"sv, {image, "is a Radiance HDR picture", ""}},
    Signature{0, "DDS |\0\0\0"sv, {image, "is a DDS picture", ""}},
    Signature{0, "8BPS\0"sv, {image, "is a Photoshop picture", ""}},
    Signature{8, "WEBPVP8"sv, {image, "is a WebP picture", ""}},
    Signature{0, "\xabKTX "sv, {image, "is a KTX picture", ""}},
    Signature{0, "\0\0\0\x0cjP  \r\n\x87\n"sv, {image, "is a JPEG 2000 picture", ""}},
    Signature{0, "\xff\x4f\xff\x51"sv, {image, "is a JPEG 2000 picture", ""}},
    Signature{4, "ftypavif"sv, {image, "is an AVIF picture", ""}},
    Signature{4, "ftypheic"sv, {image, "is a HEIC picture", ""}},
    Signature{0, "\0\0\0\x0cJXL \r\n\x87\n"sv, {image, "is a JPEG XL picture", ""}},
    Signature{0, "gimp xcf "sv, {image, "is a GIMP picture", ""}},
    Signature{0, "qoif"sv, {image, "is a QOI picture", ""}},
    Signature{8, "ILBM"sv, {image, "is an IFF picture", ""}},
    Signature{0, "\x01\xda\x00\x01"sv, {image, "is an SGI picture", ""}},
    Signature{0, "\x01\xda\x01\x01"sv, {image, "is an SGI picture", ""}},

    Signature{0, "%PDF-"sv, {other, "is a PDF file", ""}},
    Signature{0,
              "\x7f"
              "ELF"sv,
              {other, "is a program", ""}},
    Signature{0, "SQLite format 3\0"sv, {other, "is an SQLite data base", ""}},
    Signature{0,
              "version https://git-lfs"sv,
              {other, "is a Git LFS pointer to a file", "fetch the file itself with git lfs pull"}},
    Signature{0, "{\"pectin\""sv, {other, "is a script of pectin", "run it with pectin replay"}},
};

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = count; i-- > 0;) {
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return number;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

// In UTF-16, every second byte of an ASCII character is zero. A few other characters are allowed.
bool is_utf16_without_mark(std::string_view head) {
    const std::size_t pairs = std::min(head.size(), kSignatureBytes) / 2;
    if (pairs < 4) return false;
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < 2 * pairs; ++i) zeros[i % 2] += head[i] == '\0' ? 1u : 0u;
    const std::size_t most = std::max(zeros[0], zeros[1]), least = std::min(zeros[0], zeros[1]);
    return 10 * most > 9 * pairs && least == 0;
}

// A binary STL file has 80 arbitrary bytes, the number of triangles and 50 bytes for each triangle.
bool is_binary_stl(std::string_view head, std::size_t bytes) {
    constexpr std::size_t kHeader = 84, kTriangle = 50;
    return head.size() >= kHeader && bytes > kHeader &&
           bytes == kHeader + kTriangle * std::size_t{little_endian(head, 80, 4)};
}

bool is_bmp(std::string_view head, std::size_t bytes) {
    constexpr std::size_t kFileHeader = 14;
    if (!head.starts_with("BM") || head.size() < kFileHeader + 4) return false;
    const std::uint32_t pixels = little_endian(head, 10, 4), header = little_endian(head, 14, 4);
    return header >= 12 && header <= 124 && pixels >= kFileHeader + header && pixels <= bytes;
}

// Netpbm pictures begin with P1 to P7, PF or Pf, white space and a number.
bool is_netpbm(std::string_view head) {
    if (head.size() < 8 || head[0] != 'P') return false;
    if ((head[1] < '1' || head[1] > '7') && head[1] != 'F' && head[1] != 'f') return false;
    if (head[1] == '7') return head.starts_with("P7\nWIDTH ");
    const bool is_space = head[2] == '\n' || head[2] == ' ' || head[2] == '\r';
    return is_space && ((head[3] >= '0' && head[3] <= '9') || head[3] == '#');
}

// A file of Autodesk 3D Studio begins with a chunk that contains the length of the file.
bool is_3ds(std::string_view head, std::size_t bytes) {
    return head.starts_with("MM") && head.size() >= 6 && little_endian(head, 2, 4) == bytes;
}

// Whether the first line that is not a comment begins a material.
bool begins_material(std::string_view head) {
    while (true) {
        const std::size_t begin = head.find_first_not_of(" \t\r\n");
        if (begin == head.npos) return false;
        head.remove_prefix(begin);
        if (head.front() != '#') return head.starts_with("newmtl ") || head.starts_with("newmtl\t");
        head.remove_prefix(std::min(head.find('\n'), head.size()));
    }
}

// Recognises text formats that have no signature at a fixed offset.
FileKind recognise_text(std::string_view head) {
    const std::size_t begin = head.find_first_not_of(" \t\r\n");
    if (begin == head.npos) return {};
    const std::string start = lower_case(head.substr(begin));
    const auto has = [&](std::string_view word) { return start.find(word) != start.npos; };
    if (start.starts_with("solid") && has("facet")) return {model, "is an STL model", kExport};
    if (start[0] == '{' && has("\"asset\"") && (has("\"version\"") || has("\"meshes\""))) {
        return {model, "is a glTF model", kExport};
    }
    if (start.starts_with("<?xml") || start[0] == '<') {
        if (has("<collada")) return {model, "is a COLLADA model", kExport};
        if (has("<x3d")) return {model, "is an X3D model", kExport};
        if (has("<!doctype html") || has("<html")) {
            return {other, "is a web page", "download the model itself"};
        }
        if (start.starts_with("<?xml")) return {other, "is an XML file", ""};
    }
    if (begins_material(head)) {
        return {other, "is a material library (MTL)", "open the OBJ file that names it"};
    }
    if (start.starts_with("0\n") && has("section")) return {model, "is a DXF file", kExport};
    return {};
}

}  // namespace

FileKind recognise_file(std::string_view head, std::size_t bytes) {
    if (head.starts_with("PK") && head.find("3D/3dmodel.model") != head.npos) {
        return {model, "is a 3MF model", kExport};
    }
    const auto found =
        std::find_if(kSignatures.begin(), kSignatures.end(), [&](const Signature& s) {
            return head.size() >= s.offset && head.substr(s.offset).starts_with(s.bytes);
        });
    if (found != kSignatures.end()) return found->kind;
    if (is_bmp(head, bytes)) return {image, "is a BMP picture", ""};
    if (is_netpbm(head)) return {image, "is a Netpbm picture", ""};
    if (is_3ds(head, bytes)) return {model, "is a 3DS model", kExport};
    if (is_binary_stl(head, bytes)) return {model, "is an STL model", kExport};
    if (is_utf16_without_mark(head)) return {text, "is text in UTF-16", kUtf8};
    return recognise_text(head.substr(0, kSignatureBytes));
}

bool is_tga(std::string_view head, std::string_view tail, std::size_t bytes) {
    constexpr std::size_t kHeader = 18;
    constexpr std::string_view kFooter = "TRUEVISION-XFILE.\0"sv;
    if (head.size() < kHeader) return false;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
    const unsigned map = byte(1), type = byte(2), depth = byte(16);
    const std::size_t pixels = std::size_t{little_endian(head, 12, 2)} * little_endian(head, 14, 2);
    const bool is_mapped = type == 1 || type == 9, is_grey = type == 3 || type == 11;
    const bool is_color = type == 2 || type == 10, is_packed = type >= 9;
    if (!(is_mapped || is_grey || is_color) || map > 1 || (is_mapped && map != 1)) return false;
    if (pixels == 0 || (byte(17) & 0xc0) != 0) return false;
    const bool has_depth = is_color ? depth == 15 || depth == 16 || depth == 24 || depth == 32
                                    : depth == 8 || depth == 16;
    const bool has_map_depth =
        map == 0 || byte(7) == 15 || byte(7) == 16 || byte(7) == 24 || byte(7) == 32;
    if (!has_depth || !has_map_depth) return false;
    if (tail.ends_with(kFooter)) return true;
    const std::size_t map_bytes =
        map == 0 ? 0 : std::size_t{little_endian(head, 5, 2)} * ((byte(7) + 7u) / 8);
    const std::size_t before = kHeader + byte(0) + map_bytes, pixel_bytes = (depth + 7u) / 8;
    // A run of packed pixels has at most 128 pixels.
    const std::size_t least =
        is_packed ? (pixels + 127) / 128 * (1 + pixel_bytes) : pixels * pixel_bytes;
    return bytes >= before + least;
}

}  // namespace pectin
