#include "io/png.h"

#include <gtest/gtest.h>

#include <random>

#include "io/file_error.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

class Png : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }

    ScratchFolder folder_;
};

std::vector<std::uint8_t> random_pixels(int count, bool opaque) {
    std::mt19937 bits(1);
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 4 * count; ++i)
        rgba.push_back(opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(bits()));
    return rgba;
}

TEST_F(Png, ReadsBackThePixelsThatWereWritten) {
    for (const bool opaque : {true, false}) {
        const auto rgba = random_pixels(31 * 17, opaque);
        write_png(path("a.png"), 31, 17, rgba);
        const PngPixels back = read_png(path("a.png"));
        EXPECT_EQ(back.width, 31);
        EXPECT_EQ(back.height, 17);
        EXPECT_EQ(back.rgba, rgba);
    }
}

TEST_F(Png, RefusesAFileThatIsNoPicture) {
    folder_.write("a.png", "hello");
    try {
        read_png(path("a.png"));
        FAIL() << "was read";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("is no PNG that can be read"), std::string::npos);
    }
    EXPECT_THROW(read_png(path("none.png")), FileError);
}

TEST_F(Png, LeavesTheOldFileWhereItCannotWrite) {
    EXPECT_THROW(write_png(path("none/a.png"), 1, 1, random_pixels(1, true)), FileError);
}

}  // namespace
}  // namespace pectin
