// Tests that every invalid input is refused with its line and a reason. The object is unchanged and
// no incomplete file is left.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/script.h"
#include "replay/program.h"
#include "session/session.h"

namespace pectin {
namespace {

struct BadInput {
    std::string name;
    std::vector<std::string> settings;  // valid commands before the invalid line
    std::string line;
    std::string command;  // with which the message begins
    std::string said;     // what it must contain
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.name; }

std::vector<BadInput> bad_files() {
    return {
        {"MissingFile", {}, R"({"cmd": "open", "path": "missing.obj"})", "open", "missing.obj"},
        {"FolderForAFile", {}, R"({"cmd": "open", "path": "folder"})", "open", "folder"},
        {"EmptyFile", {}, R"({"cmd": "open", "path": "empty.obj"})", "open", "no faces"},
        {"NoFaces", {}, R"({"cmd": "open", "path": "points.obj"})", "open", "no faces"},
        {"IndexTooLarge", {}, R"({"cmd": "open", "path": "large.obj"})", "open", "large.obj:4: "},
        {"IndexTooSmall", {}, R"({"cmd": "open", "path": "small.obj"})", "open", "small.obj:4: "},
        {"IndexZero", {}, R"({"cmd": "open", "path": "zero.obj"})", "open", "zero.obj:4: "},
        {"NaN", {}, R"({"cmd": "open", "path": "nan.obj"})", "open", "nan.obj:2: "},
        {"Infinity", {}, R"({"cmd": "open", "path": "inf.obj"})", "open", "inf.obj:2: "},
        {"Overflow", {}, R"({"cmd": "open", "path": "overflow.obj"})", "open", "overflow.obj:2: "},
        {"SaveInNoFolder", {}, R"({"cmd": "save", "path": "none/a.obj"})", "save", "none/a.obj"},
        {"SaveInAFile", {}, R"({"cmd": "save", "path": "nan.obj/a.obj"})", "save", "nan.obj/a.obj"},
        {"SaveAsAFolder", {}, R"({"cmd": "save", "path": "folder"})", "save", "folder"},
        {"StatsInNoFolder", {}, R"({"cmd": "stats", "path": "none/a.json"})", "stats", "none"},
    };
}

std::vector<BadInput> bad_lines() {
    return {
        {"BadLine", {}, R"({"cmd": "undo")", "script", "not valid JSON"},
        {"UnknownCommand", {}, R"({"cmd": "explode"})", "explode", "unknown command"},
        {"UnknownField", {}, R"({"cmd": "undo", "times": 1})", "undo", "unknown field \"times\""},
        {"WrongType", {}, R"({"cmd": "brush", "radius": "1"})", "brush", "radius must be a length"},
        {"RadiusZero", {}, R"({"cmd": "brush", "radius": 0})", "brush", "radius must be"},
        {"RadiusNegative", {}, R"({"cmd": "brush", "radius": -1})", "brush", "radius must be"},
        {"CellZero",
         {},
         R"({"cmd": "cage", "origin": [0,0,0], "cell": [1,0,1], "deformable": [2,2,2]})",
         "cage",
         "cell[1] must be"},
        {"CellNegative",
         {},
         R"({"cmd": "cage", "origin": [0,0,0], "cell": [1,1,-1], "deformable": [2,2,2]})",
         "cage",
         "cell[2] must be"},
        {"ResolutionTooHigh",
         {},
         R"({"cmd": "shape", "kind": "sphere", "resolution": 1000})",
         "shape",
         "resolution"},
        {"ThetasInOneCommand",
         {},
         R"({"cmd": "adapt", "theta_max": 20, "theta_min": 20})",
         "adapt",
         "theta_min"},
        {"ThetasInTwoCommands",
         {R"({"cmd": "adapt", "theta_max": 20})"},
         R"({"cmd": "adapt", "theta_min": 25})",
         "adapt",
         "theta_min"},
        {"ThetasInTwoCommandsTheOtherWay",
         {R"({"cmd": "adapt", "theta_max": 20, "theta_min": 15})"},
         R"({"cmd": "adapt", "theta_max": 10})",
         "adapt",
         "theta_m"},
    };
}

std::vector<BadInput> bad_drags() {
    const std::string cage = R"({"cmd": "cage", "origin": [-0.5,-0.5,0.5], "cell": [0.5,0.5,0.5], )"
                             R"("deformable": [3,3,3]})";
    return {
        {"OnePointToTwoPlaces",
         {},
         R"({"cmd": "drag", "moves": [{"from": [0,1,0], "to": [0,1.1,0]}, )"
         R"({"from": [0,1,0], "to": [0,1.2,0]}]})",
         "drag",
         "(0, 1, 0)"},
        {"MovedPointIsPinned",
         {},
         R"({"cmd": "drag", "moves": [{"from": [0,1,0], "to": [0,1.1,0]}], "pins": [[0,1,0]]})",
         "drag",
         "(0, 1, 0)"},
        {"PointOutsideTheCage",
         {cage},
         R"({"cmd": "drag", "moves": [{"from": [0,0,-1], "to": [0,0,-1.2]}]})",
         "drag",
         "(0, 0, -1)"},
        {"SecondPointOutsideTheBrush",
         {R"({"cmd": "brush", "radius": 0.3})"},
         R"({"cmd": "drag", "moves": [{"from": [0,1,0], "to": [0,1.1,0]}, )"
         R"({"from": [0,-1,0], "to": [0,-1.1,0]}]})",
         "drag",
         "(0, -1, 0)"},
        {"NothingToUndo", {R"({"cmd": "undo"})"}, R"({"cmd": "undo"})", "undo", "undo"},
        {"NothingLeftToUndo",
         {R"({"cmd": "drag", "moves": [{"from": [0, 1, 0], "to": [0, 1.2, 0]}]})",
          R"({"cmd": "history", "megabytes": 0.0001})", R"({"cmd": "undo"})"},
         R"({"cmd": "undo", "count": 3})",
         "undo",
         "only 0 steps to undo, not 3; 1 older step was dropped"},
        {"NoMemoryForUndo", {}, R"({"cmd": "history", "megabytes": -1})", "history", "or null"},
        {"NothingToRedo", {}, R"({"cmd": "redo"})", "redo", "redo"},
    };
}

class BadInputs : public testing::TestWithParam<BadInput> {
  protected:
    BadInputs() {
        const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        folder_.write("folder/inside.txt", "");
        folder_.write("empty.obj", "");
        folder_.write("points.obj", triangle);
        folder_.write("large.obj", triangle + "f 1 2 4\n");
        folder_.write("small.obj", triangle + "f 1 2 -4\n");
        folder_.write("zero.obj", triangle + "f 0 1 2\n");
        folder_.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
        folder_.write("inf.obj", "v 0 0 0\nv 1 -inf 0\nv 0 1 0\nf 1 2 3\n");
        folder_.write("overflow.obj", "v 0 0 0\nv 1 0 1e400\nv 0 1 0\nf 1 2 3\n");
    }

    // A sphere after a drag, so that there is an undo step to lose.
    static std::vector<std::string> start() {
        return {R"({"cmd": "shape", "kind": "sphere", "resolution": 3})",
                R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.1, 0, 1.3]}]})"};
    }

    ScratchFolder folder_;
};

TEST_P(BadInputs, StopReplayWithTheirLineAndAReason) {
    const BadInput& bad = GetParam();
    std::vector<std::string> lines = start();
    lines.insert(lines.end(), bad.settings.begin(), bad.settings.end());
    lines.push_back(R"({"cmd": "save", "path": "before.obj"})");
    lines.push_back(bad.line);
    const std::size_t number = lines.size() + 1;  // the header is line 1
    lines.push_back(R"({"cmd": "save", "path": "after.obj"})");
    const std::string script = write_script(folder_, "bad.jsonl", lines);
    std::set<std::string> expected = folder_.files();
    expected.insert("before.obj");

    const Outcome outcome = run_program({"replay", script});
    EXPECT_EQ(outcome.exit_status, 1);
    const std::string heading = script + ":" + std::to_string(number) + ": " + bad.command + ": ";
    // Messages about earlier lines come before it.
    const std::size_t at = outcome.err.find(heading);
    ASSERT_NE(at, std::string::npos) << outcome.err << "not\n" << heading;
    const std::string said = outcome.err.substr(at);
    EXPECT_GT(said.size(), heading.size() + 10) << "says nothing: " << outcome.err;
    EXPECT_NE(said.find(bad.said, heading.size()), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << outcome.err;
    const bool has_notes = std::string(bad.name) == "NothingLeftToUndo";
    EXPECT_EQ(at > 0, has_notes) << outcome.err;
    EXPECT_EQ(folder_.files(), expected) << "what earlier lines wrote stays, and nothing else";
}

TEST_P(BadInputs, LeaveObjectSettingsAndHistoryUnchanged) {
    const BadInput& bad = GetParam();
    Session session;
    const auto execute = [&](const std::string& line) {
        auto parsed = parse_command(line);
        if (std::holds_alternative<CommandError>(parsed)) return false;
        Command& command = std::get<Command>(parsed);
        resolve_paths(command, folder_.path(""));
        try {
            return bool{session.execute(command)};
        } catch (const std::exception&) {
            return false;
        }
    };
    const std::string next =
        R"({"cmd": "drag", "moves": [{"from": [0, 0.1, 1], "to": [0, 0.1, 1.1]}]})";
    const auto result_of_next = [&](const std::string& file) {
        EXPECT_TRUE(execute(next));
        EXPECT_TRUE(execute(R"({"cmd": "save", "path": ")" + file + "\"}"));
        EXPECT_TRUE(execute(R"({"cmd": "undo"})"));
    };
    for (const std::string& line : start()) ASSERT_TRUE(execute(line)) << line;
    for (const std::string& line : bad.settings) ASSERT_TRUE(execute(line)) << line;
    ASSERT_TRUE(execute(R"({"cmd": "save", "path": "before.obj"})"));
    if (bad.name != "NothingToRedo") result_of_next("next before.obj");
    const std::set<std::string> files = folder_.files();

    EXPECT_FALSE(execute(bad.line));
    EXPECT_EQ(folder_.files(), files);
    EXPECT_TRUE(execute(R"({"cmd": "save", "path": "after.obj"})"));
    EXPECT_EQ(folder_.read("before.obj"), folder_.read("after.obj"));
    if (bad.name == "NothingToRedo") return;
    result_of_next("next after.obj");
    EXPECT_EQ(folder_.read("next before.obj"), folder_.read("next after.obj"));
}

std::string test_name(const testing::TestParamInfo<BadInput>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Files, BadInputs, testing::ValuesIn(bad_files()), test_name);
INSTANTIATE_TEST_SUITE_P(Lines, BadInputs, testing::ValuesIn(bad_lines()), test_name);
INSTANTIATE_TEST_SUITE_P(Drags, BadInputs, testing::ValuesIn(bad_drags()), test_name);

}  // namespace
}  // namespace pectin
