// Tests that the program with little memory either does its work or says why it cannot.
#include <gtest/gtest.h>

#include "replay/program.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/test_run.h"

namespace pectin {
namespace {

TEST(ReplayMemoryLimit, EndsWithAMessageAndNeverByASignal) {
    if (test::is_sanitized()) {
        GTEST_SKIP() << "a sanitizer needs more memory than there is";
    }
    const ScratchFolder folder;
    const std::string script = write_script(
        folder, "s.jsonl",
        {R"({"cmd": "shape", "kind": "sphere", "resolution": 5})",
         R"({"cmd": "brush", "radius": 1.5})", R"({"cmd": "adapt", "theta_max": 5})",
         R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.3, 0, 2.2]}], "fold_free": true, "connected": true})",
         R"({"cmd": "drag", "moves": [{"from": [0, 1, 0], "to": [0.3, 1.9, 0.2]}], "fold_free": true})",
         R"({"cmd": "undo", "count": 2})", R"({"cmd": "redo", "count": 2})", R"({"cmd": "bake"})",
         R"({"cmd": "save", "path": "whole.obj"})"});
    ASSERT_EQ(run_program({"replay", script}).exit_status, 0);
    const std::string whole = folder.read("whole.obj");
    int refusals = 0;
    // In steps of 3 % plus 500 KB, from less than the program needs to be loaded to all the memory
    // that it uses.
    for (int kilobytes = 16'000; kilobytes < 2'000'000; kilobytes += 500 + kilobytes / 33) {
        std::filesystem::remove(folder.path("whole.obj"));
        Process shell({"/bin/sh", "-c", "ulimit -v $2; exec \"$0\" replay \"$1\"",
                       test::program_path(), script, std::to_string(kilobytes)},
                      {}, folder.path("err"));
        const int status = shell.wait().value_or(-2);
        const std::string said = folder.read("err");
        constexpr int kNotLoaded = 127;  // exit status if the system cannot load the program
        ASSERT_TRUE(status == 0 || status == 1 || status == kNotLoaded)
            << kilobytes << " KB: " << status << ' ' << said;
        if (status == 0) {
            ASSERT_TRUE(folder.read("whole.obj") == whole) << kilobytes;
        }
        if (status == 1) {
            ++refusals;
            EXPECT_NE(said.find("memory"), std::string::npos) << said;
            EXPECT_FALSE(folder.holds("whole.obj")) << kilobytes;
        }
    }
    EXPECT_GT(refusals, 5);
}

}  // namespace
}  // namespace pectin
