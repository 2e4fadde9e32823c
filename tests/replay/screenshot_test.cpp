// Tests pictures that the program draws without a display and a window.
#include <gtest/gtest.h>

#include "io/png.h"
#include "replay/program.h"

namespace pectin {
namespace {

const std::string kSphere = R"({"cmd": "shape", "kind": "sphere", "resolution": 3})";

bool can_draw() {
    const ScratchFolder folder;
    const Outcome outcome = run_program(
        {"replay",
         write_script(folder, "s.jsonl", {kSphere, R"({"cmd": "screenshot", "path": "a.png"})"})});
    EXPECT_TRUE(outcome.exit_status == 0 || outcome.err.find("install") != std::string::npos)
        << outcome.err;
    return outcome.exit_status == 0;
}

TEST(ReplayScreenshot, WritesAPictureBesideTheScript) {
    if (!can_draw()) GTEST_SKIP() << "nothing can be drawn here";
    const ScratchFolder folder;
    const Outcome outcome = run_program(
        {"replay",
         write_script(
             folder, "s.jsonl",
             {kSphere, R"({"cmd": "screenshot", "path": "a.png", "size": [100, 50]})",
              R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0, 0, 1.2]}]})",
              R"({"cmd": "screenshot", "path": "b.png", "show": ["lattice", "wireframe"]})"})});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const PngPixels first = read_png(folder.path("a.png")), second = read_png(folder.path("b.png"));
    EXPECT_EQ(first.width, 100);
    EXPECT_EQ(first.height, 50);
    EXPECT_EQ(second.width, 1280);
    EXPECT_EQ(second.height, 960);
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.png", "b.png", "s.jsonl"}));
}

TEST(ReplayScreenshot, GivesTheSameBytesEveryTime) {
    if (!can_draw()) GTEST_SKIP() << "nothing can be drawn here";
    const ScratchFolder folder;
    const std::string script =
        write_script(folder, "s.jsonl",
                     {kSphere, R"({"cmd": "screenshot", "path": "a.png", "show": ["wireframe"]})"});
    run_program({"replay", script});
    const std::string once = folder.read("a.png");
    run_program({"replay", script});
    EXPECT_EQ(folder.read("a.png"), once);
}

TEST(ReplayScreenshot, ReportsTheLineOfAPictureThatCannotBeWrittenAndLeavesNoFile) {
    if (!can_draw()) GTEST_SKIP() << "nothing can be drawn here";
    const ScratchFolder folder;
    const std::string script = write_script(
        folder, "s.jsonl", {kSphere, R"({"cmd": "screenshot", "path": "none/a.png"})"});
    const Outcome outcome = run_program({"replay", script});
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_TRUE(outcome.err.starts_with(script + ":3: screenshot: ")) << outcome.err;
    EXPECT_EQ(folder.files(), std::set<std::string>{"s.jsonl"});
}

// The host can be chosen. Both draw with the same rasteriser, so the pictures are the same.
TEST(ReplayScreenshot, GivesTheSamePictureWithEitherHost) {
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const ScratchFolder folder;
    const std::string script = write_script(
        folder, "s.jsonl",
        {kSphere, R"({"cmd": "screenshot", "path": "a.png", "show": ["wireframe", "levels"]})"});
    std::vector<std::string> pictures;
    for (const char* host : {"osmesa", "egl"}) {
        ::setenv("PECTIN_OFFSCREEN", host, 1);
        const Outcome outcome = run_program({"replay", script});
        ::unsetenv("PECTIN_OFFSCREEN");
        if (outcome.exit_status != 0) {
            EXPECT_NE(outcome.err.find("install"), std::string::npos) << outcome.err;
            GTEST_SKIP() << outcome.err;
        }
        pictures.push_back(folder.read("a.png"));
    }
    EXPECT_TRUE(pictures[0] == pictures[1]);
}

TEST(ReplayScreenshot, RefusesAnUnknownHost) {
    const ScratchFolder folder;
    const std::string script =
        write_script(folder, "s.jsonl", {kSphere, R"({"cmd": "screenshot", "path": "a.png"})"});
    ::setenv("PECTIN_OFFSCREEN", "glx", 1);
    const Outcome outcome = run_program({"replay", script});
    ::unsetenv("PECTIN_OFFSCREEN");
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("PECTIN_OFFSCREEN must be osmesa or egl"), std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace pectin
