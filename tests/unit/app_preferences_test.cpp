// Preferences in their file: what is read, what is kept, and what happens to files that are broken.
#include "app/preferences.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/file_error.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

class PreferencesTest : public testing::Test {
  protected:
    std::string path() const { return folder_.path("pectin/preferences.json"); }
    void write(const std::string& text) const {
        std::filesystem::create_directories(folder_.path("pectin"));
        folder_.write("pectin/preferences.json", text);
    }
    std::string text() const { return folder_.read("pectin/preferences.json"); }
    PreferencesFile::Loaded loaded() const { return PreferencesFile(path()).load(); }
    bool exists() const { return std::filesystem::exists(path()); }

    ScratchFolder folder_;
};

TEST_F(PreferencesTest, AreReadAsTheyWereSaved) {
    PreferencesFile file(path());
    EXPECT_EQ(file.load().preferences, Preferences{});
    const Preferences chosen{
        .theme = Theme::light, .scale = 1.25, .hides_panels = true, .mouse = MousePreset::maya};
    file.save(chosen);
    const PreferencesFile::Loaded again = loaded();
    EXPECT_EQ(again.preferences, chosen);
    EXPECT_EQ(again.notice, "");
}

TEST_F(PreferencesTest, AreNotWrittenUnlessSomethingHasChanged) {
    PreferencesFile file(path());
    file.save(file.load().preferences);
    EXPECT_FALSE(exists());
    PreferencesFile("").save({.scale = 2.0});
    EXPECT_TRUE(folder_.files().empty());
}

TEST_F(PreferencesTest, FieldsThatAreNotKnownStayInTheFile) {
    write("{\"future\": {\"a\": [1, 2]}, \"scale\": 1.5}");
    PreferencesFile file(path());
    Preferences preferences = file.load().preferences;
    EXPECT_EQ(preferences.scale, 1.5);
    preferences.theme = Theme::light;
    file.save(preferences);
    EXPECT_NE(text().find("\"future\""), std::string::npos) << text();
    EXPECT_EQ(loaded().preferences, preferences);
}

TEST_F(PreferencesTest, ValuesThatCannotBeUsedAreReportedAndStayInTheFile) {
    write("{\"theme\": \"blue\", \"scale\": 40, \"hides_panels\": true}");
    PreferencesFile file(path());
    const PreferencesFile::Loaded first = file.load();
    EXPECT_EQ(first.preferences, (Preferences{.hides_panels = true}));
    EXPECT_NE(first.notice.find("theme, scale"), std::string::npos) << first.notice;
    Preferences changed = first.preferences;
    changed.hides_panels = false;
    file.save(changed);
    EXPECT_NE(text().find("\"blue\""), std::string::npos) << text();
    EXPECT_EQ(loaded().preferences, changed);
}

TEST_F(PreferencesTest, AFileThatCannotBeReadIsKeptUnderAnotherName) {
    for (const char* broken : {"{\"theme\": ", "[1, 2]", "", "\xff\xfe"}) {
        SCOPED_TRACE(broken);
        write(broken);
        PreferencesFile file(path());
        const PreferencesFile::Loaded first = file.load();
        EXPECT_EQ(first.preferences, Preferences{});
        EXPECT_NE(first.notice.find("cannot be read"), std::string::npos) << first.notice;
        EXPECT_EQ(text(), broken) << "reading changes nothing";
        file.save({.scale = 2.0});
        EXPECT_EQ(loaded().preferences.scale, 2.0);
        EXPECT_EQ(loaded().notice, "");
        EXPECT_EQ(folder_.read("pectin/preferences.json.unreadable"), broken);
    }
}

TEST_F(PreferencesTest, WhatAnotherWindowHasChangedSinceIsNotLost) {
    PreferencesFile first(path()), second(path());
    Preferences a = first.load().preferences, b = second.load().preferences;
    a.theme = Theme::light;
    first.save(a);
    b.scale = 0.75;
    second.save(b);
    EXPECT_EQ(loaded().preferences, (Preferences{.theme = Theme::light, .scale = 0.75}));
}

TEST_F(PreferencesTest, AFolderThatCannotBeMadeIsReportedOnce) {
    folder_.write("pectin", "a file in the way");
    PreferencesFile file(path());
    EXPECT_THROW(file.save({.scale = 2.0}), FileError);
    EXPECT_NO_THROW(file.save({.scale = 2.0})) << "it has been said";
    EXPECT_EQ(folder_.read("pectin"), "a file in the way");
}

TEST(Scales, GoUpAndDownInTheSameStepsAndEnd) {
    double scale = kLeastTextScale;
    int steps = 0;
    for (; larger_scale(scale) != scale; ++steps) {
        const double next = larger_scale(scale);
        EXPECT_GT(next, scale);
        EXPECT_EQ(smaller_scale(next), scale);
        scale = next;
    }
    EXPECT_EQ(scale, kMostTextScale);
    EXPECT_GE(steps, 8);
    EXPECT_EQ(smaller_scale(kLeastTextScale), kLeastTextScale);
    EXPECT_EQ(larger_scale(1.17), 1.25) << "from a scale between the steps";
    EXPECT_EQ(smaller_scale(1.17), 1.1);
}

}  // namespace
}  // namespace pectin
