// Tests the reading of material libraries, including what tinyobjloader's parser alone would lose.
#include "io/material_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pectin {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;

Names textures(const std::string& text) {
    Names names;
    for (const Material& material : parse_materials(text)) {
        names.insert(names.end(), material.textures.begin(), material.textures.end());
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(MaterialLibrary, ListsNamesAndTexturesOfMaterials) {
    const std::vector<Material> materials = parse_materials(
        "# c\nnewmtl red metal\nKd 1 0.5 0.25\nmap_Kd red.png\n\nnewmtl plain\n"
        "newmtl white\r\n\tKd 1 1 1\r\n\tmap_Ks shine.png\r\n");
    ASSERT_EQ(materials.size(), 3u);
    EXPECT_EQ(materials[0], (Material{"red metal", {"red.png"}}));
    EXPECT_EQ(materials[1], (Material{"plain", {}}));
    EXPECT_EQ(materials[2], (Material{"white", {"shine.png"}}));
}

TEST(MaterialLibrary, NamesEveryTextureOfAMaterial) {
    EXPECT_EQ(textures("newmtl m\nmap_Ka a\nmap_Kd b\nmap_Ks c\nmap_Ns d\nmap_d e\nmap_bump f\n"
                       "map_Bump g\nbump h\ndisp i\nmap_disp j\nrefl k\nmap_Pr l\nmap_Pm m\n"
                       "map_Ps n\nmap_Ke o\nnorm p\ndecal q\nmap_opacity r\nMAP_KD s\n"),
              (Names{"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p",
                     "q", "r", "s"}));
}

// A reflection cube has six textures; the parser alone would keep only the last.
TEST(MaterialLibrary, NamesAllTexturesOfOneKeyword) {
    EXPECT_EQ(textures("newmtl m\nrefl -type cube_top 1.png\nrefl -type cube_bottom 2.png\n"
                       "refl -type cube_front 3.png\nrefl -type cube_back 4.png\n"
                       "refl -type cube_left 5.png\nrefl -type cube_right 6.png\n"
                       "decal 7.png\ndecal 8.png\nmap_Kd 9.png\nmap_Kd 10.png\n"),
              (Names{"1.png", "10.png", "2.png", "3.png", "4.png", "5.png", "6.png", "7.png",
                     "8.png", "9.png"}));
}

TEST(MaterialLibrary, DoesNotMistakeTheAntialiasingSwitchForATexture) {
    EXPECT_EQ(textures("newmtl m\nmap_aat on\nMAP_AAT off\nmap_Kd a.png\n"), Names{"a.png"});
}

TEST(MaterialLibrary, KeepsStatementsBeforeTheFirstMaterial) {
    EXPECT_EQ(textures("map_Kd a.png\nnewmtl m\nmap_Kd b.png\n"), (Names{"a.png", "b.png"}));
}

TEST(MaterialLibrary, DistinguishesNamesFromOptions) {
    EXPECT_EQ(
        textures("map_Kd -clamp on -o 1 2 -s 1 1 1 my gloss.png \nmap_Ks -s 1 1 t.png\n"
                 "map_Ka -o 1 2.png\nmap_d -texres 512 -t 0.5 7\nbump -bm 0.5 b.png\n"
                 "map_Bump -mm 0 1 -imfchan l c.png\nmap_Ke -cc on e.png\nnorm -s.png\n"
                 "decal -o 0.5 d.png\nmap_Ns -blendu off -blendv off -colorspace sRGB n.png\n"),
        (Names{"-s.png", "2.png", "7", "b.png", "c.png", "d.png", "e.png", "my gloss.png", "n.png",
               "t.png"}));
    EXPECT_EQ(textures("map_Kd\nmap_Ks -s 1 1 1\nmap_d -o\nmap_Ke -mm 1\n"), Names{"1"})
        << "a number that is the last word is a name";
}

TEST(MaterialLibrary, ReadsEveryKindOfLine) {
    EXPECT_EQ(
        textures("\xEF\xBB\xBFnewmtl m\rmap_Kd a \\\n b.png\rmap_Ks\tc.png\r\n\tdecal\td e.png"),
        (Names{"a   b.png", "c.png", "d e.png"}));
}

TEST(MaterialLibrary, KeepsANameWithAZeroByteWhole) {
    EXPECT_EQ(textures("map_d ..\0x/secret.png\nmap_Kd a.png\n"s),
              (Names{"..\0x/secret.png"s, "a.png"}));
}

TEST(MaterialLibrary, TakesLittleMemoryForManyMaterials) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += "newmtl " + std::to_string(i) + "\n";
    EXPECT_EQ(parse_materials(text).size(), 20000u);
}

TEST(MaterialLibrary, IsDistinguishedFromOtherText) {
    for (const std::string& text : {""s, "# nothing yet\n"s, "newmtl a\nKd 1 1 1\nan extension\n"s,
                                    "map_Kd a.png\nKd 1 1 1\nillum 2\nmap_aat on\n"s,
                                    "\xEF\xBB\xBFNewmtl a\r\nillum 2\r\n"s}) {
        EXPECT_TRUE(may_be_material_library(text)) << text;
    }
    for (const std::string& text :
         {"alias ls='ls -l'\n"s, "-----BEGIN OPENSSH PRIVATE KEY-----\n"s,
          "machine example.org login me password secret\n"s, "v 0 0 0\n"s,
          "[Desktop Entry]\nExec=evil\nnewmtl a\n"s, "#!/bin/sh\nnewmtl a\n"s,
          "newmtl a\nexport TOKEN=secret\nexport OTHER=secret\n"s}) {
        EXPECT_FALSE(may_be_material_library(text)) << text;
    }
}

}  // namespace
}  // namespace pectin
