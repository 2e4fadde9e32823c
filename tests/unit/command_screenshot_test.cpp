#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "command/json.h"

namespace pectin {
namespace {

command::Screenshot parsed(const std::string& fields) {
    const auto result = parse_command(R"({"cmd": "screenshot", )" + fields + "}");
    if (const auto* error = std::get_if<CommandError>(&result)) {
        ADD_FAILURE() << fields << ": " << error->what;
        return {};
    }
    return std::get<command::Screenshot>(std::get<Command>(result));
}

TEST(ScreenshotCommand, NeedsOnlyAPath) {
    const command::Screenshot screenshot = parsed(R"("path": "a.png")");
    EXPECT_EQ(screenshot.size.x, 1280);
    EXPECT_EQ(screenshot.size.y, 960);
    EXPECT_FALSE(screenshot.camera);
    EXPECT_TRUE(screenshot.show == command::Screenshot::Show{});
}

TEST(ScreenshotCommand, FitsTheObjectIfTheCameraIsFit) {
    EXPECT_FALSE(parsed(R"("path": "a.png", "camera": "fit")").camera);
}

TEST(ScreenshotCommand, UsesDefaultsForAMissingUpVectorAndFieldOfView) {
    const auto camera =
        parsed(R"("path": "a.png", "camera": {"eye": [1, 2, 3], "target": [0, 0, 0.5]})").camera;
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->eye, Vec3(1, 2, 3));
    EXPECT_EQ(camera->target, Vec3(0, 0, 0.5));
    EXPECT_EQ(camera->up, Vec3(0, 1, 0));
    EXPECT_EQ(camera->fov, 45.0);
}

TEST(ScreenshotCommand, IsDrawnInPerspectiveUnlessItSaysOtherwise) {
    const std::string camera =
        R"("path": "a.png", "camera": {"eye": [0, 0, 3], "target": [0, 0, 0])";
    EXPECT_EQ(parsed(camera + "}").camera->projection, Projection::perspective);
    const command::Screenshot flat = parsed(camera + R"(, "projection": "orthographic"})");
    EXPECT_EQ(flat.camera->projection, Projection::orthographic);
    EXPECT_NE(format_command(flat).find(R"("projection": "orthographic")"), std::string::npos);
    EXPECT_EQ(format_command(parsed(camera + "}")).find("projection"), std::string::npos);
}

TEST(ScreenshotCommand, ShowsTheListedParts) {
    const auto show = parsed(R"("path": "a.png", "show": ["levels", "wireframe", "levels"])").show;
    EXPECT_TRUE(show == (command::Screenshot::Show{.wireframe = true, .levels = true}));
    EXPECT_TRUE(parsed(R"("path": "a.png", "show": ["lattice"])").show ==
                command::Screenshot::Show{.lattice = true});
    EXPECT_TRUE(parsed(R"("path": "a.png", "show": ["light"])").show ==
                command::Screenshot::Show{.light = true});
}

TEST(ScreenshotCommand, FormatsOnlyFieldsThatDifferFromTheirDefaults) {
    EXPECT_EQ(format_command(command::Screenshot{.path = "a.png"}),
              R"({"cmd": "screenshot", "path": "a.png"})");
}

TEST(ScreenshotCommand, RefusesInvalidPictures) {
    struct Bad {
        std::string fields, said;
    };
    for (const Bad& bad : std::vector<Bad>{
             {R"("path": "a.jpg")", "must end in .png"},
             {R"("path": "a.png", "size": [640])", "an array of two whole numbers"},
             {R"("path": "a.png", "size": [640, 15])", "size[1] must be a whole number from 16"},
             {R"("path": "a.png", "size": [8193, 16])", "8192"},
             {R"("path": "a.png", "camera": "front")", "\"fit\" or an object"},
             {R"("path": "a.png", "camera": {"eye": [0, 0, 1]})", "camera.target is missing"},
             {R"("path": "a.png", "camera": {"eye": [0, 0, 1], "target": [0, 0, 1]})", "another"},
             {R"("path": "a.png", "camera": {"eye": [0, 9, 0], "target": [0, 0, 0]})", "up at an"},
             {R"("path": "a.png", "camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fov": 180})",
              "an angle from 1 to 170"},
             {R"("path": "a.png", "camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "roll": 1})",
              "unknown field \"roll\""},
             {R"("path": "a.png", "camera": {"eye": [0, 0, 1], "target": [0, 0, 0],)"
              R"( "projection": "isometric"})",
              "perspective or orthographic"},
             {R"("path": "a.png", "show": "levels")", "an array of any of wireframe"},
             {R"("path": "a.png", "show": ["level"])", "show[0] must be wireframe"},
             // A picture is of the object alone.
             {R"("path": "a.png", "show": ["ui"])", "show[0] must be wireframe"}}) {
        const auto result = parse_command(R"({"cmd": "screenshot", )" + bad.fields + "}");
        const auto* error = std::get_if<CommandError>(&result);
        ASSERT_TRUE(error) << bad.fields;
        EXPECT_EQ(error->command, "screenshot");
        EXPECT_NE(error->what.find(bad.said), std::string::npos)
            << bad.fields << "\nsays: " << error->what;
    }
}

}  // namespace
}  // namespace pectin
