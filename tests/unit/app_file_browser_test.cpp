// Tests FileBrowser.
#include "app/file_browser.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/file_error.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using Purpose = FileBrowser::Purpose;

class FileBrowserTest : public testing::Test {
  protected:
    FileBrowserTest() {
        fs::create_directory(path("models"));
        fs::create_directory(path("Attic"));
        for (const char* file : {"b.obj", "A.OBJ", "notes.txt", ".hidden.obj", "models/c.obj"}) {
            folder_.write(file, "v 0 0 0\n");
        }
    }
    std::string path(const std::string& name = "") const { return folder_.path(name); }

  private:
    ScratchFolder folder_;
};

TEST_F(FileBrowserTest, ListsFoldersFirstThenModelsWithoutRegardToCase) {
    const std::vector<FileEntry> expected{
        {"Attic", true, 0}, {"models", true, 0}, {"A.OBJ", false, 8}, {"b.obj", false, 8}};
    const std::vector<std::string> extensions{".obj"};
    EXPECT_EQ(list_folder(path(), extensions), expected);
    EXPECT_THROW(list_folder(path("absent"), extensions), FileError);
}

TEST_F(FileBrowserTest, StartsInTheFolderOfTheFileAndSavesUnderItsName) {
    const FileBrowser opening(Purpose::open, path("b.obj"));
    EXPECT_EQ(opening.folder(), path());
    EXPECT_TRUE(opening.name.empty());
    const FileBrowser saving(Purpose::save, path("b.obj"));
    EXPECT_EQ(saving.name, "b.obj");
}

TEST_F(FileBrowserTest, NamesAreRelativeToTheFolderShownOrAbsolute) {
    FileBrowser browser(Purpose::open, path("b.obj"));
    browser.name = "b.obj";
    EXPECT_EQ(browser.choose(), path("b.obj"));
    browser.name = "models/../models/c.obj";
    EXPECT_EQ(browser.choose(), path("models/c.obj"));
    browser.name = "/etc/passwd";
    EXPECT_EQ(browser.choose(), "/etc/passwd");
    browser.name = "";
    EXPECT_EQ(browser.choose(), "");
}

TEST_F(FileBrowserTest, ChoosingTheNameOfAFolderOpensIt) {
    FileBrowser browser(Purpose::open, path("b.obj"));
    browser.name = "models";
    EXPECT_EQ(browser.choose(), "");
    EXPECT_EQ(browser.folder(), path("models"));
    browser.open_parent_folder();
    EXPECT_EQ(browser.folder(), path());
}

TEST_F(FileBrowserTest, SavingAddsTheExtensionIfItIsMissing) {
    FileBrowser browser(Purpose::save, path("b.obj"));
    browser.name = "ball";
    EXPECT_EQ(browser.choose(), path("ball.obj"));
    browser.name = "ball.OBJ";
    EXPECT_EQ(browser.choose(), path("ball.OBJ"));
    FileBrowser picture(Purpose::save_picture, path("ball.png"));
    picture.name = "ball";
    EXPECT_EQ(picture.choose(), path("ball.png"));
}

TEST_F(FileBrowserTest, AFolderThatCannotBeReadIsReportedAndNotOpened) {
    FileBrowser browser(Purpose::open, path("b.obj"));
    browser.open_folder(path("absent"));
    EXPECT_EQ(browser.folder(), path());
    EXPECT_FALSE(browser.error().empty());
}

TEST_F(FileBrowserTest, BreadcrumbsLeadFromTheRootToTheFolder) {
    const FileBrowser browser(Purpose::open, path("models/c.obj"));
    const auto breadcrumbs = browser.breadcrumbs();
    ASSERT_GE(breadcrumbs.size(), 3u);
    EXPECT_EQ(breadcrumbs.front().path, "/");
    EXPECT_EQ(breadcrumbs.back().name, "models");
    EXPECT_EQ(breadcrumbs.back().path, path("models"));
}

}  // namespace
}  // namespace pectin
