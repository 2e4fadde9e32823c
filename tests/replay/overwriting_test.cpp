// Tests that stats and screenshot only replace files of their own kind, so that a mistake in a
// script does not destroy a model.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "replay/program.h"

namespace pectin {
namespace {

using namespace std::string_literals;

const std::string kShape = R"({"cmd": "shape", "kind": "cube", "resolution": 1})";
const std::string kModel = "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Outcome write_stats(const ScratchFolder& folder, const std::string& name) {
    return run_program(
        {"replay", write_script(folder, "s.jsonl",
                                {kShape, R"({"cmd": "stats", "path": ")" + name + "\"}"})});
}

TEST(Stats, RefusesToReplaceAFileOfAnotherKindAndSaysWhatItIs) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {kModel, "is an OBJ model"},
        {"newmtl a\nKd 1 1 1\n", "is a material library (MTL)"},
        {"\x89PNG\r\n\x1a\n\0\0"s, "is a PNG picture"},
        {"{\"pectin\": 1}\n", "is a script of pectin"},
        {"{\"asset\": {\"version\": \"2.0\"}}", "is a glTF model"},
        {"PK\x03\x04\x14\0"s, "is a zip archive"},
        {"dear diary\n", "is a text file"},
        {"{\"cut\": ", "is a text file"},
        {"\x01\x02\x03\0"s, "is a file of another kind"},
    };
    for (const auto& [contents, what] : files) {
        const ScratchFolder folder;
        folder.write("kept", contents);
        const Outcome outcome = write_stats(folder, "kept");
        EXPECT_EQ(outcome.exit_status, 1) << what;
        EXPECT_EQ(folder.read("kept"), contents) << what;
        EXPECT_EQ(outcome.err, folder.path("s.jsonl") + ":3: stats: " + folder.path("kept") + ": " +
                                   what +
                                   " and is not replaced; stats writes JSON files, so give "
                                   "it another name\n");
    }
}

TEST(Stats, ReplacesJsonAndEmptyFiles) {
    for (const std::string& contents : {""s, "{}"s, " [1, 2]\n"s, "{\"faces\": 12}"s}) {
        const ScratchFolder folder;
        folder.write("s.json", contents);
        const Outcome outcome = write_stats(folder, "s.json");
        EXPECT_EQ(outcome.exit_status, 0) << contents << outcome.err;
        EXPECT_NE(folder.read("s.json").find("\"faces\""), std::string::npos) << contents;
        EXPECT_EQ(write_stats(folder, "s.json").exit_status, 0) << "its own result";
    }
}

TEST(Screenshot, ReplacesOnlyPngPictures) {
    const auto draw = [](const ScratchFolder& folder) {
        return run_program(
            {"replay",
             write_script(
                 folder, "s.jsonl",
                 {kShape, R"({"cmd": "screenshot", "path": "p.png", "size": [32, 32]})"})});
    };
    for (const std::string& contents : {kModel, "\xff\xd8\xff\xe0 JFIF"s, "{}"s}) {
        const ScratchFolder folder;
        folder.write("p.png", contents);
        const Outcome outcome = draw(folder);
        EXPECT_EQ(outcome.exit_status, 1);
        EXPECT_EQ(folder.read("p.png"), contents);
        EXPECT_NE(outcome.err.find("and is not replaced; screenshot writes PNG pictures"),
                  std::string::npos)
            << outcome.err;
    }
    const ScratchFolder folder;
    ASSERT_EQ(draw(folder).exit_status, 0);
    const std::string picture = folder.read("p.png");
    folder.write("p.png", picture.substr(0, 40));
    EXPECT_EQ(draw(folder).exit_status, 0);
    EXPECT_EQ(folder.read("p.png"), picture);
}

}  // namespace
}  // namespace pectin
