// Tests that files of other kinds are recognised, with advice on how to open them.
#include "io/file_kind.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "io/file_error.h"
#include "io/obj_reader.h"

namespace pectin {
namespace {

using namespace std::string_literals;

std::string refusal(const std::string& text) {
    try {
        parse_obj(text, "t.obj");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

// OBJ text of a cube in UTF-16.
std::string utf16(bool little_endian, bool with_mark) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", wide;
    if (with_mark) wide += little_endian ? "\xff\xfe"s : "\xfe\xff"s;
    for (char c : text) wide += little_endian ? std::string{c, '\0'} : std::string{'\0', c};
    return wide;
}

TEST(OtherFiles, AreNamedWithAdvice) {
    std::string stl = std::string(80, 'x') + "\x02\0\0\0"s + std::string(100, '\0');
    const std::vector<std::pair<std::string, std::string>> files = {
        {"\x1f\x8b\x08\0\0\0\0\0"s, "is a gzip file"},
        {"PK\x03\x04\x14\0"s, "is a zip archive"},
        {"\x28\xb5\x2f\xfd\x04"s, "is a zstd file"},
        {"\xfd"s + "7zXZ\0\0"s, "is an xz file"},
        {"BZh91AY&SY"s, "is a bzip2 file"},
        {"7z\xbc\xaf\x27\x1c\0\x04"s, "is a 7z archive"},
        {utf16(true, true), "is text in UTF-16"},
        {utf16(true, false), "is text in UTF-16"},
        {utf16(false, true), "is text in UTF-16"},
        {utf16(false, false), "is text in UTF-16"},
        {stl, "is an STL model"},
        {"solid cube\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n", "is an STL model"},
        {"ply\nformat ascii 1.0\nelement vertex 3\n", "is a PLY model"},
        {"glTF\x02\0\0\0"s, "is a binary glTF model"},
        {"{\n  \"asset\": {\"version\": \"2.0\"}, \"meshes\": []}", "is a glTF model"},
        {"Kaydara FBX Binary  \0\x1a\0"s, "is an FBX model"},
        {"; FBX 7.4.0 project file\n", "is an FBX model"},
        {"BLENDER-v300REND", "is a Blender file"},
        {"OFF\n3 1 0\n", "is an OFF model"},
        {"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">", "is a COLLADA model"},
        {"<!DOCTYPE html>\n<html>404</html>", "is a web page"},
        {"version https://git-lfs.github.com/spec/v1\n", "is a Git LFS pointer"},
        {"\x89PNG\r\n\x1a\n\0\0"s, "is a PNG picture"},
        {"{\"pectin\": 1}\n", "is a script of pectin"},
        {"# Blender MTL\n\n# 2 materials\nnewmtl red\nKd 1 0 0\n", "is a material library (MTL)"},
        {"PK\x03\x04\x14\0\0\0 3D/3dmodel.model"s, "is a 3MF model"},
        {"MM\x0e\0\0\0\x02\0\x0a\0\0\0\x03\0"s, "is a 3DS model"},
    };
    for (const auto& [text, what] : files) {
        const std::string message = refusal(text);
        EXPECT_TRUE(message.starts_with("t.obj: " + what)) << message;
        EXPECT_NE(message.find("not an OBJ model"), message.npos) << message;
    }
    EXPECT_EQ(refusal("\x1f\x8b\x08\0v 1 2 3\n"s),
              "t.obj: is a gzip file, not an OBJ model; unpack it and open the OBJ file in it");
    EXPECT_EQ(refusal(utf16(true, false)),
              "t.obj: is text in UTF-16, not an OBJ model; save it as UTF-8 and open it again");
}

TEST(OtherFiles, DoNotIncludeReadableModels) {
    for (const char* first : {"solid cube facet", "ply", "OFF", "#usda", "#?RADIANCE", "P3 1 1"}) {
        EXPECT_EQ(refusal(first + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"s), "accepted") << first;
    }
}

TEST(OtherFiles, DoNotIncludeDamagedObjText) {
    for (const char* text : {"v 0 0 0\nv 1 0 0\nf 1 2 3\n", "# Blender v2.79\nv x\n", "g \n\nv 1\n",
                             "mtllib a.mtl\nf 0\n", "o solid\nf 1 2 3\n"}) {
        EXPECT_FALSE(recognise_file(text, std::string(text).size()).is_known()) << text;
    }
    constexpr std::uint32_t kSeed = 3;
    std::mt19937 random(kSeed);
    for (int i = 0; i < 2000; ++i) {  // random letters, which contain no signature
        std::string text;
        for (int k = 0; k < 200; ++k) text += "vfnt 0123456789./-\n"[random() % 19];
        EXPECT_FALSE(recognise_file(text, text.size()).is_known()) << "seed " << kSeed << text;
    }
}

TEST(Pictures, AreRecognisedByTheirContent) {
    const std::string bmp = "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0"s + std::string(40, '\0');
    for (const std::string& head :
         {"\x89PNG\r\n\x1a\n"s, "\xff\xd8\xff\xe0"s, "GIF89a"s, "II*\0"s, "MM\0*"s, bmp,
          "\x76\x2f\x31\x01"s, "#?RADIANCE\n"s, "DDS |\0\0\0"s, "8BPS\0\1"s,
          "RIFF\0\0\0\0WEBPVP8 "s, "P6\n1 1 255\n"s, "P5 640 480 255\n"s}) {
        EXPECT_TRUE(recognise_file(head, head.size()).is_image()) << head;
    }
    for (const std::string& head :
         {"not a texture\n"s, "BM is how this begins"s, "[Desktop Entry]\n"s, "\x7f"s + "ELF"s, ""s,
          "P"s, "-----BEGIN OPENSSH PRIVATE KEY-----"s, "#!/bin/sh\n"s, "RIFF\0\0\0\0WAVEfmt "s}) {
        EXPECT_FALSE(recognise_file(head, head.size()).is_image()) << head;
    }
}

// An uncompressed TGA picture of this size and depth.
std::string tga(int width, int height, int depth) {
    std::string bytes(18, '\0');
    bytes[2] = 2;
    bytes[12] = static_cast<char>(width);
    bytes[14] = static_cast<char>(height);
    bytes[16] = static_cast<char>(depth);
    return bytes + std::string(static_cast<std::size_t>(width * height * depth / 8), '\x7f');
}

TEST(Pictures, InTgaFormatAreRecognisedByFieldsThatAgreeWithTheirSize) {
    const auto is = [](const std::string& bytes) { return is_tga(bytes, bytes, bytes.size()); };
    EXPECT_TRUE(is(tga(4, 3, 24)));
    EXPECT_TRUE(is(tga(1, 1, 32)));
    EXPECT_FALSE(is(tga(4, 3, 24).substr(0, 50))) << "too short for its pixels";
    EXPECT_FALSE(is(tga(0, 3, 24)));
    EXPECT_FALSE(is(tga(4, 3, 8))) << "colours of 8 bits without a map";
    std::string packed = tga(8, 8, 24).substr(0, 18 + 4);  // one run of 64 equal pixels
    packed[2] = 10;
    EXPECT_TRUE(is(packed));
    EXPECT_FALSE(is("[Desktop Entry]\nType=Application\nExec=/bin/true\n"));
    EXPECT_FALSE(is(""));
}

}  // namespace
}  // namespace pectin
