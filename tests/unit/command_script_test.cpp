#include "command/script.h"

#include <gtest/gtest.h>

#include <sstream>

namespace pectin {
namespace {

std::vector<ScriptLine> read(const std::string& text) {
    std::istringstream stream(text);
    ScriptReader reader(stream);
    std::vector<ScriptLine> lines;
    while (auto line = reader.next()) lines.push_back(*line);
    return lines;
}

bool is_error(const ScriptLine& line) { return std::holds_alternative<CommandError>(line.command); }

TEST(ScriptReader, SkipsBlankLinesAndCommentsButCountsThem) {
    const auto lines = read(
        "{\"pectin\": 1}\n\n# drag something\n{\"cmd\": \"readapt\"}\n   \n{\"cmd\": \"undo\"}\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].number, 4u);
    EXPECT_TRUE(std::get<Command>(lines[0].command) == Command(command::Readapt{}));
    EXPECT_EQ(lines[1].number, 6u);
}

TEST(ScriptReader, ReturnsTheCommentRightBeforeACommand) {
    const auto lines = read(
        "{\"pectin\": 1}\n# of nothing\n\n#  the first \r\n# command.\n{\"cmd\": \"undo\"}\n"
        "{\"cmd\": \"redo\"}\n#\n{\"cmd\": \"bake\"}\n");
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].comment, "the first command.");
    EXPECT_EQ(lines[1].comment, "");
    EXPECT_EQ(lines[2].comment, "");
}

TEST(ScriptReader, AcceptsCarriageReturnsAByteOrderMarkAndAMissingFinalNewline) {
    const auto lines = read(
        "\xEF\xBB\xBF{\"pectin\": 1}\r\n\r\n{\"cmd\": \"undo\"}\r\n# x\r\n{\"cmd\": \"redo\"}");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_FALSE(is_error(lines[0]));
    EXPECT_TRUE(std::get<Command>(lines[1].command) == Command(command::Redo{}));
}

TEST(ScriptReader, StopsAtAnInvalidFirstLine) {
    for (const char* text : {"", "\n{\"pectin\": 1}\n", "# x\n{\"pectin\": 1}\n",
                             "{\"cmd\": \"undo\"}\n", "{\"pectin\": 2}\n{\"cmd\": \"undo\"}\n"}) {
        const auto lines = read(text);
        ASSERT_EQ(lines.size(), 1u) << text;
        EXPECT_EQ(lines[0].number, 1u);
        ASSERT_TRUE(is_error(lines[0]));
        EXPECT_EQ(std::get<CommandError>(lines[0].command).command, "script");
        EXPECT_NE(std::get<CommandError>(lines[0].command).what.find("{\"pectin\": 1}"),
                  std::string::npos);
    }
}

TEST(ScriptReader, ReturnsTheCommandsBeforeAnInvalidLineFirst) {
    const auto lines = read("{\"pectin\": 1}\n{\"cmd\": \"undo\"}\n{\"cmd\": \n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_FALSE(is_error(lines[0]));
    EXPECT_TRUE(is_error(lines[1]));
    EXPECT_EQ(lines[1].number, 3u);
}

TEST(ScriptReader, ReadsAHeaderAloneAsNoCommands) { EXPECT_TRUE(read("{\"pectin\": 1}").empty()); }

TEST(ResolvePaths, MakesRelativePathsRelativeToTheFolderAndKeepsAbsoluteOnes) {
    Command open = command::Open{.path = "models/a.obj"};
    resolve_paths(open, "/some where");
    EXPECT_EQ(std::get<command::Open>(open).path, "/some where/models/a.obj");
    Command save = command::Save{.path = "/tmp/b.obj"};
    resolve_paths(save, "/some where");
    EXPECT_EQ(std::get<command::Save>(save).path, "/tmp/b.obj");
    Command stats = command::Stats{.path = "c.json"};
    resolve_paths(stats, "");
    EXPECT_EQ(std::get<command::Stats>(stats).path, "c.json");
    Command undo = command::Undo{};
    resolve_paths(undo, "/x");
    EXPECT_TRUE(undo == Command(command::Undo{}));
}

}  // namespace
}  // namespace pectin
