// Opening and saving in the real window.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/test_run.h"
#include "window/window_fixture.h"

namespace pectin {
namespace {

TEST_F(WindowTest, TheFileBrowserOpensAModel) {
    folder().write("models/wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    open_window();
    desktop().key("ctrl+o");
    desktop().type(path("models"));  // a folder: the browser goes there
    desktop().key("Return");
    desktop().type("wedge.obj");
    desktop().key("Return");
    ASSERT_TRUE(records("\"open\"")) << record();
    EXPECT_EQ(recorded("wedge.obj"), 1u);
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, DroppingAModelOpensItAndAnyOtherFileKeepsTheObject) {
    folder().write("a wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder().write("letter.obj", "Dear tetrahedron\n");
    open_window();
    ASSERT_TRUE(desktop().drop(path("a wedge.obj")));
    ASSERT_TRUE(records("\"open\""));
    EXPECT_EQ(recorded("a wedge.obj"), 1u);
    ASSERT_TRUE(desktop().drop(path("letter.obj")));
    save_as("window.obj");
    quit();
    EXPECT_EQ(recorded("letter.obj"), 0u);
    EXPECT_TRUE(folder().read("window.obj") == replayed());
    EXPECT_NE(folder().read("window.obj").find("v 0 0 1"), std::string::npos);
}

TEST_F(WindowTest, ALargeFileIsOpenedInTheBackgroundAndCanBeCancelled) {
    // With sanitizers, a quarter of the size takes as long.
    const int resolution = test::is_sanitized() ? 7 : 8;
    const std::string script = write_script(
        folder(), "large.jsonl",
        {R"({"cmd": "shape", "kind": "sphere", "resolution": )" + std::to_string(resolution) + "}",
         R"({"cmd": "save", "path": "large.obj"})"});
    ASSERT_EQ(run_program({"replay", script}).exit_status, 0);
    // A file is open if saving writes the same bytes to it again.
    const auto expect_open = [&](const std::string& name, std::size_t saves) {
        const std::string before = folder().read(name);
        std::filesystem::remove(path(name));
        desktop().key("ctrl+s");
        ASSERT_TRUE(records("\"save\"", saves)) << record();
        EXPECT_TRUE(folder().read(name) == before);
    };
    open_window();
    save_as("ball.obj");
    ASSERT_TRUE(desktop().drop(path("large.obj")));
    desktop().key("Escape");
    // The dialog takes all keys until it is closed.
    ASSERT_TRUE(eventually([&] {
        desktop().key("bracketleft");
        return recorded("\"brush\"") > 0;
    }));
    expect_open("ball.obj", 2);
    EXPECT_EQ(recorded("\"open\""), 0u);

    ASSERT_TRUE(desktop().drop(path("large.obj")));
    ASSERT_TRUE(eventually([&] { return recorded("\"open\"") == 1; }));
    expect_open("large.obj", 3);
    quit();
}

TEST_F(WindowTest, TheModelOnTheCommandLineIsOpenedAndAnInvalidOneGivesASphere) {
    folder().write("wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    open_window({path("wedge.obj")});
    EXPECT_EQ(recorded("\"shape\""), 0u);
    quit();
    folder().write("letter.obj", "Dear sphere\n");
    open_window({path("letter.obj")});
    EXPECT_EQ(recorded("\"open\""), 0u);
    EXPECT_EQ(recorded("\"shape\""), 1u);
    quit();
}

TEST_F(WindowTest, QuittingWithChangesAsksAndSaves) {
    open_window();
    save_as("ball.obj");
    const std::string before = folder().read("ball.obj");
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    desktop().key("ctrl+q");
    ASSERT_TRUE(eventually([&] {
        desktop().key("Return");  // the first answer, which saves
        return recorded("\"save\"") == 2;
    }));
    const std::string after = folder().read("ball.obj");
    EXPECT_TRUE(after != before);
    EXPECT_TRUE(after == replayed());
}

}  // namespace
}  // namespace pectin
