// Tests that files of other programs open even if they lack attributes or have unusual statements,
// and that files of other kinds are recognised.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "replay/program.h"

namespace pectin {
namespace {

using namespace std::string_literals;

// Opens the file and saves it as out.obj.
Outcome open_and_save(const ScratchFolder& folder, const std::string& name) {
    return run_program({"replay", write_script(folder, "s.jsonl",
                                               {R"({"cmd": "open", "path": ")" + name + "\"}",
                                                R"({"cmd": "save", "path": "out.obj"})",
                                                R"({"cmd": "stats", "path": "out.json"})"})});
}

TEST(ForeignFiles, OpenWithoutAttributesThatTheirFacesReferTo) {
    const ScratchFolder folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/2/1 3/3/1\n");
    const Outcome outcome = open_and_save(folder, "t.obj");
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(folder.read("out.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(outcome.err,
              folder.path("s.jsonl") +
                  ":2: open: t.obj: 3 corners name texture coordinates that the file does not have "
                  "and get none (first in line 4); 3 corners name normals that the file does not "
                  "have and get them from their faces (first in line 4)\n");
    EXPECT_NE(folder.read("out.json").find("\"missing_uvs\": 3"), std::string::npos);
}

// ZBrush writes a cube like this, with its colours in a comment.
TEST(ForeignFiles, KeepThePolypaintOfZBrushAsVertexColours) {
    const ScratchFolder folder;
    folder.write("cube.obj",
                 "g \n\nv 0.5 -0.5 0.5\nv -0.5 -0.5 0.5\nv 0.5 0.5 0.5\nv -0.5 0.5 0.5\n"
                 "v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv 0.5 0.5 -0.5\n\n"
                 "#MRGB ffff00ffff0000ffffffffffff00ffffff000000ffff0000ff00ff00ffffff00\n\ng \n\n"
                 "f 1 3 4 2\nf 5 7 8 6\nf 7 4 3 8\nf 6 1 2 5\nf 6 8 3 1\nf 2 4 7 5\n");
    const Outcome outcome = open_and_save(folder, "cube.obj");
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(folder.read("out.obj").starts_with(
        "v 0.5 -0.5 0.5 1 0 1\nv -0.5 -0.5 0.5 0 0 1\nv 0.5 0.5 0.5 1 1 1\n"
        "v -0.5 0.5 0.5 0 1 1\nv -0.5 -0.5 -0.5 0 0 0\nv 0.5 -0.5 -0.5 1 0 0\n"
        "v -0.5 0.5 -0.5 0 1 0\nv 0.5 0.5 -0.5 1 1 0\n"))
        << folder.read("out.obj");
}

TEST(ForeignFiles, OpenWithColoursThatAreNotNumbers) {
    const ScratchFolder folder;
    folder.write("t.obj", "v 0 0 0 nan nan nan\nv 1 0 0 1 0 0\nv 0 1 0 inf 0 0\nf 1 2 3\n");
    const Outcome outcome = open_and_save(folder, "t.obj");
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_TRUE(folder.read("out.obj").starts_with("v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\n"));
    EXPECT_NE(outcome.err.find("2 vertices have colours that are no numbers and get none (first in "
                               "line 1)\n"),
              std::string::npos)
        << outcome.err;
}

TEST(ForeignFiles, SaveDegeneratePolygonsWithoutZeroNormals) {
    const ScratchFolder folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\nf 1 2\nf\n");
    const Outcome outcome = open_and_save(folder, "t.obj");
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(folder.read("out.obj").find("vn 0 0 0"), std::string::npos) << folder.read("out.obj");
    EXPECT_NE(outcome.err.find("1 f, l or p without corners dropped (line 8)"), std::string::npos)
        << outcome.err;
}

TEST(ForeignFiles, AreReportedByTheirKindIfTheyAreNotObj) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {"\x1f\x8b\x08\0\0\0\0\0\0\x03"s, "is a gzip file"},
        {"\xff\xfe"s + "v\0 \0001\0"s, "is text in UTF-16"},
        {"V 0 0 0\nF 1 2 3\n", "'V' in line 1 should be 'v'; 'F' in line 2 should be 'f'"},
    };
    for (const auto& [bytes, what] : files) {
        const ScratchFolder folder;
        folder.write("t.obj", bytes);
        const Outcome outcome = open_and_save(folder, "t.obj");
        EXPECT_EQ(outcome.exit_status, 1);
        EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
    }
}

TEST(Messages, AreNotCutOffByAZeroByteInAFile) {
    const ScratchFolder folder;
    folder.write("t.obj", "v 0 0\0x 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"s);
    const Outcome outcome = open_and_save(folder, "t.obj");
    EXPECT_NE(outcome.err.find("t.obj:1: '0\\x00x' is no number; numbers look like"),
              std::string::npos)
        << outcome.err;
}

// A save in another folder reports the material files. The system would read the first name as "a".
TEST(Messages, AreNotCutOffByAZeroByteInAName) {
    const ScratchFolder folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nmtllib a\0b.mtl\nmtllib c.mtl\n"s);
    folder.write("a", "newmtl a\n");
    folder.write("c.mtl", "newmtl c\nmap_Kd d\0e.png\n"s);
    folder.write("to/own.txt", "");
    const std::string script = write_script(
        folder, "s.jsonl",
        {R"({"cmd": "open", "path": "t.obj"})", R"({"cmd": "save", "path": "to/t.obj"})"});
    const Outcome outcome = run_program({"replay", script});
    EXPECT_EQ(outcome.exit_status, 0);
    EXPECT_EQ(outcome.err,
              script +
                  ":3: save: t.obj: material files copied: c.mtl; material files not copied: "
                  "a\\x00b.mtl (leads out of the model's folder), d\\x00e.png (leads out of "
                  "the model's folder)\n");
    EXPECT_FALSE(folder.holds("to/a"));
    EXPECT_NE(folder.read("to/t.obj").find("mtllib a\0b.mtl\n"s), std::string::npos);
}

TEST(Messages, AreNotCutOffByAZeroByteInAScript) {
    const Outcome outcome =
        run_program({"replay", "-"}, "{\"pectin\": 1}\n{\"cmd\": \"explode\\u0000\\u001b[1m\"}\n");
    EXPECT_EQ(outcome.err.find('\0'), std::string::npos);
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
    EXPECT_NE(outcome.err.find("unknown command"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace pectin
