// Tests that a script gives the same bytes on every machine, with every compiler, with and without
// optimisation. The file that each of a few scripts saves must have the digest that is given here.
// The released build (g++ -O3, vectorised if the processor allows it) and the build with sanitizers
// (clang, not optimised) must both have it.
//
// All arithmetic for positions is exactly rounded by IEEE 754, with a few exceptions in which the
// last digit depends on the C library. The scripts avoid these as far as possible:
//   cos, tan of thresholds    matter only for values within that digit of a threshold
//   atan2 in corner normals   gives weights of faces; the sums are rounded to float
//   cos, sin in shapes        occur in the torus and the cylinder, which no script here makes
//   sin, cos, pow of a twist  are used for right angles and powers of two, which are exact
#include <gtest/gtest.h>

#include <cstdint>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "replay/program.h"

namespace pectin {
namespace {

// FNV-1a with 64 bits. G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake. The FNV Non-Cryptographic Hash
// Algorithm. Internet-Draft.
std::uint64_t digest(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001b3u;
    }
    return hash;
}

TEST(Digest, MatchesTheReferenceImplementation) {
    EXPECT_EQ(digest(""), 0xcbf29ce484222325u);
    EXPECT_EQ(digest("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(digest("foobar"), 0x85944171f73967e8u);
}

// The number as a C++ literal.
std::string literal(std::uint64_t number) {
    std::ostringstream text;
    text << "0x" << std::hex << std::setw(16) << std::setfill('0') << number << "u";
    return text.str();
}

struct FixedScript {
    const char* name;
    std::uint64_t digest;  // of the OBJ file that the script saves at its end
    std::vector<std::string> lines;
};

void operator<<(std::ostream& out, const FixedScript& script) { out << script.name; }

const std::string kSphere = R"({"cmd": "shape", "kind": "sphere", "resolution": 4})";
const std::string kFine = R"({"cmd": "adapt", "theta_max": 11})";

std::vector<FixedScript> fixed_scripts() {
    return {
        {"BrushThatRefinesAndThins",
         0xa66bff88006f7946u,
         {kSphere, kFine, R"({"cmd": "brush", "radius": 0.8})",
          R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.1, 0.05, 1.5]}]})",
          R"({"cmd": "drag", "moves": [{"from": [0.1, 0.05, 1.5], "to": [0, 0.1, 1.1]}]})",
          R"({"cmd": "adapt", "theta_max": 17})", R"({"cmd": "readapt"})"}},
        {"DragOfEverythingOnAllThreads",
         0x609987612d9c3ab7u,
         {R"({"cmd": "shape", "kind": "sphere", "resolution": 6})",
          R"({"cmd": "adapt", "theta_max": 1.5})", R"({"cmd": "brush", "radius": 4})",
          R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.3, 0.1, 1.5]}]})"}},
        {"SeveralConstraintsWithPins",
         0x64c2c963d9fb2705u,
         {R"({"cmd": "shape", "kind": "cube", "resolution": 12})", kFine,
          R"({"cmd": "cage", "fit": [4, 5, 6]})",
          R"({"cmd": "drag", "moves": [{"from": [1, 1, 1], "to": [1.3, 1.4, 1.2]}, )"
          R"({"from": [-1, 0.5, 0.25], "to": [-1.2, 0.4, 0.3]}], )"
          R"("pins": [[1, -1, 1], [0, 1, 0], [-1, -1, -1]]})"}},
        {"Twist",
         0xb6677e90704c267bu,
         {kSphere, kFine, R"({"cmd": "brush", "radius": 0.9, "span": 4})",
          R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0, 0.1, 1.2], )"
          R"("twist": {"axis": [0, 0, 1], "degrees": 90}, "scale": 2}]})"}},
        {"FoldFreeAlongWaypoints",
         0xb1ca23ffa41da71fu,
         {kSphere, kFine, R"({"cmd": "brush", "radius": 0.6})",
          R"({"cmd": "drag", "moves": [{"from": [0.6, 0.8, 0], "to": [1.5, 1.5, 0.3]}], )"
          R"("connected": true, "fold_free": true, "via": [[1, 1.2, 0.1]]})"}},
        {"Symmetry",
         0x34a21284ff54e639u,
         {kSphere, kFine, R"({"cmd": "symmetry", "plane": "x"})",
          R"({"cmd": "brush", "radius": 0.7})",
          R"({"cmd": "drag", "moves": [{"from": [0.6, 0, 0.8], "to": [0.8, 0.1, 1.2]}], )"
          R"("pins": [[0, 0, 1]]})"}},
        {"ControlPoints",
         0x8de6fa1fff2d81f4u,
         {kSphere, R"({"cmd": "adapt", "theta_max": 5})", R"({"cmd": "cage", "fit": [3, 4, 3]})",
          R"({"cmd": "control", "points": [{"index": [0, 3, 1], "to": [-1.5, 1.75, 0.25]}, )"
          R"({"index": [2, 0, 2], "to": [1.25, -1.5, 1]}]})"}},
        {"PlateauWithPinsTwistAndSymmetry",
         0x9b12fa58e1d6e4e8u,
         {kSphere, kFine, R"({"cmd": "symmetry", "plane": "x"})",
          R"({"cmd": "brush", "radius": 0.7, "span": 5, "falloff": "plateau"})",
          R"({"cmd": "drag", "moves": [{"from": [0.6, 0, 0.8], "to": [0.8, 0.1, 1.2], )"
          R"("twist": {"axis": [0, 0, 1], "degrees": 90}}], "pins": [[0, 0, 1]]})",
          R"({"cmd": "drag", "moves": [{"from": [0, 0.6, -0.8], "to": [0, 1, -1.5]}], )"
          R"("fold_free": true})"}},
        {"BakeAndUndo",
         0xc2d214d94a53c6b4u,
         {kSphere, kFine, R"({"cmd": "drag", "moves": [{"from": [0, 1, 0], "to": [0.3, 1.5, 0]}]})",
          R"({"cmd": "bake"})",
          R"({"cmd": "drag", "moves": [{"from": [0, 0, -1], "to": [0, 0.3, -1.4]}]})",
          R"({"cmd": "drag", "moves": [{"from": [1, 0, 0], "to": [1.5, 0.3, -0.1]}]})",
          R"({"cmd": "undo"})"}},
    };
}

class FixedBytes : public testing::TestWithParam<FixedScript> {};

TEST_P(FixedBytes, AreTheSameOnEveryMachineAndInEveryBuild) {
    const FixedScript& script = GetParam();
    const ScratchFolder folder;
    std::vector<std::string> lines = script.lines;
    lines.push_back(R"({"cmd": "save", "path": "result.obj"})");
    const Outcome outcome = run_program({"replay", write_script(folder, "script.jsonl", lines)});
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
    const std::string bytes = folder.read("result.obj");
    const std::string found = literal(digest(bytes));
    EXPECT_EQ(found, literal(script.digest))
        << "Where both builds find the same and the meshes were meant to change, " << found
        << " is the new digest of " << script.name << " in " << __FILE__
        << ". Where the builds differ, results depend on the compiler or the machine: a fused"
           " multiplication, an order of evaluation, something uninitialised.";
}

std::string test_name(const testing::TestParamInfo<FixedScript>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Scripts, FixedBytes, testing::ValuesIn(fixed_scripts()), test_name);

}  // namespace
}  // namespace pectin
