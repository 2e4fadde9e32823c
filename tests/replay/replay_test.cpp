// Tests the program with scripts: exit status, messages and the files it writes.
#include <gtest/gtest.h>

#include <algorithm>

#include "replay/program.h"
#include "support/paths.h"

namespace pectin {
namespace {

const std::string kSphere = R"({"cmd": "shape", "kind": "sphere", "resolution": 3})";
const std::string kDrag = R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.1, 0, 1.3]}]})";

std::string save(const std::string& name) { return R"({"cmd": "save", "path": ")" + name + "\"}"; }

void expect_done(const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

// ---- Valid scripts

TEST(Replay, WritesTheDemoAndItsStatistics) {
    const ScratchFolder folder;
    folder.write("build/.keep", "");
    std::filesystem::create_directory(folder.path("assets"));
    std::filesystem::copy_file(test::source_path("assets/demo.jsonl"),
                               folder.path("assets/demo.jsonl"));
    expect_done(run_program({"replay", folder.path("assets/demo.jsonl")}));
    const std::string object = folder.read("build/demo.obj");
    EXPECT_NE(object.find("\nv "), object.npos);
    EXPECT_NE(object.find("\nf "), object.npos);
    EXPECT_NE(folder.read("build/demo.json").find("\"angle_min_deg\": "), std::string::npos);
}

TEST(Replay, GivesTheSameBytesAfterUndoAndAfterRedo) {
    const ScratchFolder folder;
    const std::string brush = R"({"cmd": "brush", "radius": 0.5})";
    const std::string again =
        R"({"cmd": "drag", "moves": [{"from": [0, 1, 0], "to": [0, 1.2, 0]}], )"
        R"("pins": [[0.2, 0.98, 0]]})";
    expect_done(run_program(
        {"replay", write_script(folder, "s.jsonl",
                                {kSphere, save("0.obj"), kDrag, save("1.obj"), brush, again,
                                 save("2.obj"), R"({"cmd": "undo"})", save("1 undone.obj"),
                                 R"({"cmd": "undo"})", save("0 undone.obj"),
                                 R"({"cmd": "redo", "count": 2})", save("2 redone.obj")})}));
    EXPECT_EQ(folder.read("0.obj"), folder.read("0 undone.obj"));
    EXPECT_EQ(folder.read("1.obj"), folder.read("1 undone.obj"));
    EXPECT_EQ(folder.read("2.obj"), folder.read("2 redone.obj"));
    EXPECT_NE(folder.read("0.obj"), folder.read("1.obj"));
    EXPECT_NE(folder.read("1.obj"), folder.read("2.obj"));
}

TEST(Replay, ReportsThatTheOldestStepsWereDropped) {
    const ScratchFolder folder;
    const std::string script =
        write_script(folder, "s.jsonl",
                     {kSphere, kDrag, R"({"cmd": "history", "megabytes": 0.001})",
                      R"({"cmd": "drag", "moves": [{"from": [0, 1, 0], "to": [0, 1.2, 0]}]})"});
    const Outcome outcome = run_program({"replay", script});
    EXPECT_EQ(outcome.exit_status, 0);
    EXPECT_EQ(outcome.err,
              script +
                  ":5: drag: the oldest step can no longer be undone, since undo may "
                  "take at most 0.001 MB of memory; a larger limit keeps more steps\n");
}

TEST(Replay, GivesTheSameBytesEveryTime) {
    const ScratchFolder folder;
    for (const char* name : {"a", "b"})
        expect_done(run_program(
            {"replay", write_script(folder, std::string(name) + ".jsonl",
                                    {kSphere, kDrag, save(name + std::string(".obj"))})}));
    EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj"));
}

TEST(Replay, DragsFoldFreeSymmetricallyConnectedAndByControlPoints) {
    const ScratchFolder folder;
    const std::string undo_all = R"({"cmd": "undo", "count": 4})";
    for (const char* name : {"a", "b"}) {
        const std::string n = name;
        expect_done(run_program(
            {"replay",
             write_script(
                 folder, n + ".jsonl",
                 {kSphere, save(n + "0.obj"), R"({"cmd": "brush", "radius": 0.4})",
                  R"({"cmd": "symmetry", "plane": "x", "through": [0, 0, 0]})",
                  R"({"cmd": "drag", "moves": [{"from": [0.6, 0.8, 0], "to": [1.4, 1.5, 0.2]}], )"
                  R"("connected": true, "fold_free": true, "via": [[1, 0.9, 0]]})",
                  R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0, 0, 1.1], )"
                  R"("twist": {"axis": [1, 0, 0], "degrees": 30}, "scale": 1.3}]})",
                  R"({"cmd": "symmetry", "plane": null})",
                  R"({"cmd": "drag", "moves": [{"from": [0, 0, -1], "to": [0, 1.2, -1]}], )"
                  R"("fold_free": true})",
                  R"({"cmd": "stats", "path": ")" + n + R"(.json"})",
                  R"({"cmd": "cage", "fit": [4, 4, 4]})",
                  R"({"cmd": "control", "points": [{"index": [0, 3, 1], "to": [-2, 2, 0]}, )"
                  R"({"index": [3, 3, 1], "to": [2, 2, 0]}]})",
                  save(n + "4.obj"), undo_all, save(n + " undone.obj"),
                  R"({"cmd": "redo", "count": 4})", save(n + " redone.obj")})}));
    }
    EXPECT_EQ(folder.read("a4.obj"), folder.read("b4.obj"));
    EXPECT_EQ(folder.read("a0.obj"), folder.read("a undone.obj"));
    EXPECT_EQ(folder.read("a4.obj"), folder.read("a redone.obj"));
    EXPECT_NE(folder.read("a0.obj"), folder.read("a4.obj"));
    const std::string figures = folder.read("a.json");
    EXPECT_NE(figures.find("\"folded_vertices\": 0"), figures.npos) << figures;
    EXPECT_EQ(figures.find("\"steps\": 1,"), figures.npos) << figures;
    EXPECT_NE(figures.find("\"steps\": "), figures.npos) << figures;
}

TEST(Replay, OpensItsSavedFiles) {
    const ScratchFolder folder;
    expect_done(run_program(
        {"replay", write_script(folder, "s.jsonl",
                                {kSphere, kDrag, save("a.obj"),
                                 R"({"cmd": "open", "path": "a.obj"})", save("b.obj")})}));
    EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj"));
}

TEST(Replay, ReportsFindingsInTheInputAndContinues) {
    const ScratchFolder folder;
    // Three faces on the edge 1 2, and a vertex without faces.
    folder.write("fan.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 9 9 9\n"
                 "f 1 2 3\nf 2 1 4\nf 1 2 5\n");
    folder.write("clean.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string script = write_script(
        folder, "s.jsonl",
        {R"({"cmd": "open", "path": "clean.obj"})", R"({"cmd": "open", "path": "fan.obj"})",
         R"({"cmd": "stats", "path": "fan.json"})"});
    const Outcome outcome = run_program({"replay", script});
    EXPECT_EQ(outcome.exit_status, 0);
    EXPECT_TRUE(outcome.err.starts_with(
        script + ":3: open: fan.obj: opened with repairs: 1 non-manifold edge split"))
        << outcome.err;
    EXPECT_NE(outcome.err.find("; 1 unused vertex kept\n"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const std::string figures = folder.read("fan.json");
    EXPECT_NE(figures.find("\"nonmanifold_edges\": 1"), std::string::npos) << figures;
    EXPECT_NE(figures.find("\"isolated_vertices\": 1"), std::string::npos) << figures;
}

TEST(Replay, ReadsTheScriptFromStandardInput) {
    const ScratchFolder folder;
    const std::string script =
        "{\"pectin\": 1}\n" + kSphere + "\n" + save(folder.path("a.obj")) + "\n";
    expect_done(run_program({"replay", "-"}, script));
    EXPECT_TRUE(folder.holds("a.obj"));
}

TEST(Replay, WritesOnlyTheRequestedFiles) {
    const ScratchFolder folder;
    expect_done(run_program({"replay", write_script(folder, "s.jsonl",
                                                    {kSphere, kDrag, save("a.obj"), save("a.obj"),
                                                     R"({"cmd": "stats", "path": "a.json"})"})}));
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.json", "a.obj", "s.jsonl"}));
}

// ---- The command line

TEST(CommandLine, ShowsVersionAndHelp) {
    EXPECT_EQ(run_program({"--version"}).exit_status, 0);
    EXPECT_EQ(run_program({"--version"}).out.substr(0, 7), "pectin ");
    const Outcome help = run_program({"--help"});
    EXPECT_EQ(help.exit_status, 0);
    for (const char* word :
         {"pectin replay SCRIPT", "readapt", "theta_max", "deformable", "\"to\""})
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST(CommandLine, RefusesBadUsageAndShowsTheUsage) {
    const std::vector<std::vector<std::string>> bad{
        {"replay"},     {"replay", "a", "b"}, {"--frobnicate"},
        {"a.obj", "b"}, {"--record"},         {"--record", "a.jsonl", "replay", "b.jsonl"}};
    for (const auto& arguments : bad) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.exit_status, 2) << testing::PrintToString(arguments);
        EXPECT_NE(outcome.err.find("usage: pectin"), std::string::npos);
        EXPECT_EQ(outcome.out, "");
    }
}

TEST(CommandLine, NamesAScriptThatCannotBeRead) {
    const ScratchFolder folder;
    for (const std::string& script : {folder.path("missing.jsonl"), folder.path("")}) {
        const Outcome outcome = run_program({"replay", script});
        EXPECT_EQ(outcome.exit_status, 1);
        EXPECT_TRUE(outcome.err.starts_with(script + ": cannot be read: ")) << outcome.err;
    }
}

TEST(CommandLine, RefusesAScriptWithoutTheFirstLine) {
    const ScratchFolder folder;
    folder.write("s.jsonl", kSphere + "\n" + save("a.obj") + "\n");
    const Outcome outcome = run_program({"replay", folder.path("s.jsonl")});
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_TRUE(outcome.err.starts_with(folder.path("s.jsonl") + ":1: script: ")) << outcome.err;
    EXPECT_FALSE(folder.holds("a.obj"));
}

}  // namespace
}  // namespace pectin
