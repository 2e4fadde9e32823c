// Tests what pictures show, and the errors if none can be drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/offscreen_viewport.h"
#include "ffd/brush_profile.h"
#include "io/png.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "support/offscreen.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

constexpr IVec2 kSize{160, 120};

using RenderTest = OffscreenTest;

struct Pixel {
    int red, green, blue;
    int luminance() const { return (2 * red + 5 * green + blue) / 8; }
};
Pixel pixel(const Image& image, int x, int y) {
    const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                         static_cast<std::size_t>(x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

TriMesh sphere(int resolution) {
    return build_mesh(make_shape(ShapeKind::sphere, resolution)).mesh;
}

// ---- Refusals

TEST(RenderErrors, SayWhatToInstallIfThereIsNoOpenGl) {
    try {
        load_gl([](const char*) -> GLADapiproc { return nullptr; });
        FAIL() << "was loaded";
    } catch (const ContextError& error) {
        EXPECT_NE(std::string(error.what()).find("needs OpenGL 3.3; install"), std::string::npos);
    }
}

TEST(RenderErrors, SayWhichVersionIsTooOld) {
    // The function from which load_gl() gets the version.
    static constexpr auto kGetString = [](GLenum name) -> const GLubyte* {
        return reinterpret_cast<const GLubyte*>(name == GL_VERSION ? "2.1 Mesa" : "a toaster");
    };
    try {
        load_gl([](const char* name) -> GLADapiproc {
            const GLubyte* (*const get_string)(GLenum) = kGetString;
            return std::string(name) == "glGetString" ? reinterpret_cast<GLADapiproc>(get_string)
                                                      : nullptr;
        });
        FAIL() << "was loaded";
    } catch (const ContextError& error) {
        EXPECT_NE(std::string(error.what()).find("OpenGL 2.1 Mesa by a toaster is too old"),
                  std::string::npos)
            << error.what();
    }
}

// The message of make_offscreen_host() if it throws; empty if it creates a host.
std::string error_of_host(std::string_view choice, const OffscreenLibraries& libraries = {}) {
    try {
        make_offscreen_host(choice, libraries);
        return {};
    } catch (const ContextError& error) {
        return error.what();
    }
}

TEST(OffscreenHost, UsesEglIfOsmesaIsMissing) {
    if (!error_of_host("egl").empty()) GTEST_SKIP() << error_of_host("egl");
    EXPECT_EQ(error_of_host("", {.osmesa = "libNoSuchMesa.so.8"}), "");
    EXPECT_NE(error_of_host("osmesa", {.osmesa = "libNoSuchMesa.so.8"}), "");
}

TEST(OffscreenHost, NamesThePackagesOfBothHostsIfNeitherIsUsable) {
    for (const char* library : {"libNoSuchLibrary.so.8", "libm.so.6"}) {
        const std::string error = error_of_host("", {.osmesa = library, .egl = library});
        for (const char* expected : {"libosmesa6", "libegl1", "libgl1-mesa-dri", library}) {
            EXPECT_NE(error.find(expected), std::string::npos) << error;
        }
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
}

TEST(OffscreenHost, NamesOnlyThePackageOfTheChosenHost) {
    const OffscreenLibraries none{.osmesa = "libNoSuchMesa.so.8", .egl = "libNoSuchEgl.so.1"};
    EXPECT_EQ(error_of_host("osmesa", none).find("libegl1"), std::string::npos);
    EXPECT_EQ(error_of_host("egl", none).find("libosmesa6"), std::string::npos);
}

TEST(OffscreenHost, RefusesAnUnknownHostAndListsTheKnownOnes) {
    const std::string error = error_of_host("glx");
    EXPECT_NE(error.find("PECTIN_OFFSCREEN"), std::string::npos) << error;
    EXPECT_NE(error.find("osmesa or egl"), std::string::npos) << error;
    EXPECT_NE(error.find("\"glx\""), std::string::npos) << error;
}

// Both hosts in one process: each can draw after make_current(), even if the other has drawn.
TEST(OffscreenHost, DrawsInTurnWithASecondHost) {
    std::unique_ptr<OffscreenHost> first, second;
    try {
        first = make_offscreen_host();
        second = make_offscreen_host();
    } catch (const ContextError& error) {
        GTEST_SKIP() << error.what();
    }
    const TriMesh sphere = build_mesh(make_shape(ShapeKind::sphere, 2)).mesh;
    std::vector<Image> images;
    for (OffscreenHost* host : {first.get(), second.get(), first.get()}) {
        host->make_current();
        images.push_back(draw(host->gl(), sphere, Scene{}, {64, 48}));
    }
    EXPECT_EQ(images[0].rgba, images[1].rgba);
    EXPECT_EQ(images[0].rgba, images[2].rgba);
    // Each host's objects are destroyed in its own context.
    second->make_current();
    second.reset();
    first->make_current();
}

TEST_F(RenderTest, ReportsTheFailingShaderWithTheDriversLog) {
    const ShaderSource good{"good.vert", "void main() { gl_Position = vec4(0.0); }"};
    const ShaderSource bad{"bad.frag", "void main() { this is no shader }"};
    try {
        const ShaderProgram program(gl(), {good, bad});
        FAIL() << "was compiled";
    } catch (const ShaderError& error) {
        EXPECT_EQ(error.shader(), "bad.frag");
        EXPECT_FALSE(error.log().empty());
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("bad.frag"), std::string::npos);
    }
}

TEST_F(RenderTest, ReportsShadersThatDoNotLink) {
    const ShaderSource vert{"a.vert", "out vec3 v; void main() { v = gl_Position = vec4(0.0); }"};
    const ShaderSource frag{"b.frag", "in vec3 w; out vec4 c; void main() { c = vec4(w, 1.0); }"};
    EXPECT_THROW(ShaderProgram(gl(), {vert, frag}), ShaderError);
}

TEST_F(RenderTest, RefusesAPictureBeyondTheDriversLimits) {
    try {
        const Canvas canvas(gl(), {1 << 20, 16});
        FAIL() << "was made";
    } catch (const ContextError& error) {
        EXPECT_NE(std::string(error.what()).find("too large"), std::string::npos);
    }
}

// ---- Pictures

TEST_F(RenderTest, ReducesTheSamplesOfHugePictures) {
    EXPECT_GE(Canvas(gl(), {64, 64}).samples(), 4);
    EXPECT_EQ(Canvas(gl(), {64, 64}, 1).samples(), 1);
    EXPECT_EQ(Canvas(gl(), {8192, 8192}).samples(), 1);
}

TEST_F(RenderTest, ReadsRowsFromTheTop) {
    const TriMesh mesh = sphere(3);
    const Scene scene{.camera = {.eye = Vec3(0, -1, 5), .target = Vec3(0, -1, 0)}};
    const Image image = draw(gl(), mesh, scene, kSize), empty = draw(gl(), TriMesh{}, scene, kSize);
    EXPECT_NE(pixel(image, 80, 40).red, pixel(empty, 80, 40).red);
    EXPECT_EQ(pixel(image, 80, 110).red, pixel(empty, 80, 110).red);
}

TEST_F(RenderTest, ShowsTheInsideInAnotherColour) {
    const TriMesh mesh = sphere(3);
    const Pixel outside =
        pixel(draw(gl(), mesh, {.camera = {.eye = Vec3(0, 0, 3)}}, kSize), 80, 60);
    const Pixel inside = pixel(
        draw(gl(), mesh, {.camera = {.eye = Vec3(0, 0, 0.5), .target = Vec3(0)}}, kSize), 80, 60);
    EXPECT_GT(outside.red, outside.blue + 20);
    EXPECT_GT(inside.blue, inside.red + 20);
    EXPECT_GT(inside.luminance(), 40);
}

TEST_F(RenderTest, ShadesUndefinedNormalsByTheirFaces) {
    TriMesh mesh = sphere(4);
    const Scene scene{.camera = {.eye = Vec3(0.4, 0.6, 3)}};
    const Image smooth = draw(gl(), mesh, scene, kSize);
    for (std::uint32_t i = 0; i < mesh.wedge_slots(); ++i) mesh.set_normal(WedgeId{i}, Vec3f{0.0f});
    const Image faceted = draw(gl(), mesh, scene, kSize);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            EXPECT_NEAR(pixel(faceted, x, y).luminance(), pixel(smooth, x, y).luminance(), 24);
}

TEST_F(RenderTest, DrawsTheSamePictureFarFromTheOrigin) {
    const Vec3 far{1e6, -2e6, 3e6};
    TriMesh mesh = sphere(3);
    const Image here = draw(gl(), mesh, {.camera = {.eye = Vec3(1, 2, 3)}}, kSize);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
        mesh.set_position(VertexId{i}, mesh.position(VertexId{i}) + far);
    const Image there =
        draw(gl(), mesh, {.camera = {.eye = Vec3(1, 2, 3) + far, .target = far}}, kSize);
    int different = 0;
    for (std::size_t i = 0; i < here.rgba.size(); ++i)
        different += std::abs(here.rgba[i] - there.rgba[i]) > 2;
    EXPECT_LT(different, 10);
}

TEST_F(RenderTest, ShowsOverlaysBehindTheObjectFaintly) {
    const TriMesh mesh = sphere(3);
    const auto green_at_the_middle = [&](double z) {
        Scene scene{.camera = {.eye = Vec3(0, 0, 3)}};
        scene.overlay.points.push_back(
            {.position = Vec3(0, 0, z), .colour = {0, 255, 0, 255}, .diameter = 20.0f});
        const Pixel middle = pixel(draw(gl(), mesh, scene, kSize), 80, 60);
        return middle.green - middle.red;
    };
    const int before = green_at_the_middle(1.0), behind = green_at_the_middle(-1.0);
    EXPECT_GT(before, 240);
    EXPECT_GT(behind, 10);
    EXPECT_LT(behind, 120);
}

TEST_F(RenderTest, DrawsLinesThatPassBesideTheEye) {
    Scene scene{.camera = {.eye = Vec3(0, 0, 3)}};
    scene.overlay.lines.push_back(
        {.from = Vec3(0, -0.2, 9), .to = Vec3(0, 0, 0), .colour = {0, 255, 0, 255}, .width = 3.0f});
    const Image image = draw(gl(), TriMesh{}, scene, kSize);
    const Pixel below = pixel(image, 80, 62);
    EXPECT_GT(below.green, below.red + 50);
    EXPECT_LT(pixel(image, 80, 20).green, pixel(image, 80, 20).red + 50);
}

// Lines and points are drawn nearer than they are, so that those on the surface do not flicker.
TEST_F(RenderTest, DrawsLinesAndPointsOnTheSurfaceFullyInBothProjections) {
    const TriMesh cube = build_mesh(make_shape(ShapeKind::cube, 4)).mesh;
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const double distance : {3.0, 300.0}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(projection) << ' ' << distance);
            Scene scene{.camera = {.eye = Vec3(0, 0, 1.0 + distance),
                                   .target = Vec3(0, 0, 1),
                                   .fov = glm::degrees(2.0 * std::atan(1.0 / distance)),
                                   .projection = projection}};
            const Colour green{0, 255, 0, 255};
            scene.overlay.lines.push_back(
                {.from = Vec3(-0.9, 0.2, 1), .to = Vec3(0.9, 0.2, 1), .colour = green});
            scene.overlay.lines.back().width = 3.0f;
            scene.overlay.points.push_back({Vec3(0, -0.2, 1), green, 9.0f});
            const Image image = draw(gl(), cube, scene, kSize);
            for (const int x : {40, 80, 120}) EXPECT_GT(pixel(image, x, 48).green, 250) << x;
            EXPECT_GT(pixel(image, 80, 72).green, 250);
            EXPECT_LT(pixel(image, 80, 72).red, 10);
        }
    }
}

// ---- Screenshots

class ScreenshotTest : public OffscreenTest {
  protected:
    ScreenshotTest() { session_.set_viewport(&viewport_); }

    PngPixels shoot(const command::Screenshot& screenshot) {
        command::Screenshot to_file = screenshot;
        to_file.path = path_;
        const Done done = session_.execute(to_file);
        EXPECT_TRUE(done) << done.refusal().reason;
        return read_png(path_);
    }

    OffscreenViewport viewport_;
    Session session_;
    ScratchFolder folder_;
    const std::string path_ = folder_.path("a.png");
};

// A sphere of radius 1 seen from distance d fills a cone of half angle asin(1 / d), which
// intersects the plane at distance 1 in a circle of radius tan(asin(1 / d)) = 1 / sqrt(d² - 1).
TEST_F(ScreenshotTest, ShowsTheUnitSphereWithTheRadiusThatFollowsFromTheCamera) {
    execute(session_, {R"({"cmd": "shape", "kind": "sphere", "resolution": 6})"});
    for (const double distance : {1.5, 3.0, 8.0}) {
        for (const double fov : {30.0, 60.0, 100.0}) {
            command::Screenshot screenshot{.size = {500, 400}};
            screenshot.camera = Camera{.eye = distance * glm::normalize(Vec3(1, 2, 3)), .fov = fov};
            const PngPixels shown = shoot(screenshot);
            screenshot.camera->target = 2.0 * screenshot.camera->eye;  // looks away from the sphere
            const PngPixels background = shoot(screenshot);
            const double radius =
                200.0 / std::tan(glm::radians(fov) / 2.0) / std::sqrt(distance * distance - 1.0);
            if (radius > 200.0) continue;
            double area = 0.0;
            int across = 0;
            for (std::size_t i = 0; i < shown.rgba.size(); i += 4) {
                const bool covered = shown.rgba[i] != background.rgba[i] ||
                                     shown.rgba[i + 1] != background.rgba[i + 1] ||
                                     shown.rgba[i + 2] != background.rgba[i + 2];
                area += covered;
                across += covered && i / 4 / 500 == 200;
            }
            // Partly covered pixels are counted as whole ones, half a pixel too much on average.
            EXPECT_NEAR(std::sqrt(area / std::numbers::pi), radius + 0.5, 0.5)
                << "from " << distance << " at " << fov << " degrees";
            EXPECT_NEAR(0.5 * across, radius, 1.0);
        }
    }
}

// Also from within the object: without perspective everything is drawn, and all of it can be
// picked.
TEST_F(ScreenshotTest, PicksWhatItDraws) {
    execute(session_, {R"({"cmd": "shape", "kind": "torus", "resolution": 12})"});
    constexpr IVec2 kPicture{96, 72};
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const double distance : {0.05, 0.4, 3.0}) {
            const Vec3 target{0.9, 0.1, 0.0};  // within the tube
            const Camera camera{.eye = target + distance * Vec3(-0.3, 0.8, 0.5),
                                .target = target,
                                .fov = 60.0,
                                .projection = projection};
            command::Screenshot screenshot{.size = kPicture, .camera = camera};
            const PngPixels shown = shoot(screenshot);
            screenshot.camera->eye += Vec3(1e3, 0, 0);
            screenshot.camera->target += Vec3(1e3, 0, 0);
            const PngPixels background = shoot(screenshot);
            int hits = 0, disagreements = 0;
            for (int y = 0; y < kPicture.y; ++y) {
                for (int x = 0; x < kPicture.x; ++x) {
                    const auto at = static_cast<std::size_t>(4 * (y * kPicture.x + x));
                    const bool is_drawn = shown.rgba[at] != background.rgba[at] ||
                                          shown.rgba[at + 2] != background.rgba[at + 2];
                    const bool is_hit =
                        session_.pick(camera.ray_through({x + 0.5, y + 0.5}, kPicture)).has_value();
                    hits += is_hit;
                    disagreements += is_drawn != is_hit;
                }
            }
            // Pixels on outlines are covered in part.
            EXPECT_GT(hits, 200) << distance;
            EXPECT_LT(disagreements, 0.05 * kPicture.x * kPicture.y) << distance;
        }
    }
}

TEST_F(ScreenshotTest, LeavesUndoAndRedoUnchanged) {
    execute(session_, {R"({"cmd": "shape", "kind": "sphere", "resolution": 2})",
                       R"({"cmd": "drag", "moves": [{"from": [0,0,1], "to": [0,0,1.2]}]})",
                       R"({"cmd": "undo"})"});
    shoot({.size = {16, 16}});
    execute(session_, {R"({"cmd": "redo"})", R"({"cmd": "undo"})"});
}

TEST_F(ScreenshotTest, IsRefusedWithoutAnObject) {
    EXPECT_FALSE(session_.execute(command::Screenshot{.path = path_}));
    EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST(Screenshot, IsRefusedWithoutARenderer) {
    Session session;
    execute(session, {R"({"cmd": "shape", "kind": "cube", "resolution": 1})"});
    const Done done = session.execute(command::Screenshot{.path = "a.png"});
    ASSERT_FALSE(done);
    EXPECT_NE(done.refusal().reason.find("nothing here to draw with"), std::string::npos);
}

// ---- The tint of the falloff

TEST_F(RenderTest, TheTintColoursTheSurfaceByTheWeightAroundBothCentres) {
    const TriMesh mesh = sphere(5);
    const BrushProfile profile(3, Falloff::sharp);
    const Vec3 centre = glm::normalize(Vec3{0.45, 0.2, 0.9});
    FalloffTint tint{.centre = centre, .radius = 0.8, .samples = profile.samples()};
    Scene plain{.camera = {.eye = {0, 0, 4}}};
    const Image before = draw(gl(), mesh, plain, kSize);
    // How much redder than before the picture of this point of the sphere is, against blue.
    const auto redder = [&](const Scene& scene, const Vec3& point) {
        const Vec2 at = *scene.camera.project(point, kSize);
        const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
        const Pixel was = pixel(before, x, y), is = pixel(draw(gl(), mesh, scene, kSize), x, y);
        return (is.red - is.blue) - (was.red - was.blue);
    };
    for (const bool wireframe : {false, true}) {
        Scene scene = plain;
        scene.levels = wireframe;  // the other shader
        scene.tint = tint;
        Scene without = scene;
        without.tint.reset();
        const auto effect = [&](const Vec3& point) {
            return redder(scene, point) - redder(without, point);
        };
        const Vec3 half = glm::normalize(centre + 0.8 * profile.distance_at(0.5, Vec3{-1, 0, 0}) *
                                                      Vec3{-1, 0, 0});
        EXPECT_GT(effect(centre), 40) << wireframe;
        EXPECT_GT(effect(centre), effect(half) + 10);
        EXPECT_GT(effect(half), 10);
        EXPECT_EQ(effect(glm::normalize(Vec3{-0.45, -0.6, 0.7})), 0) << "outside";
        const Vec3 image{-centre.x, centre.y, centre.z};
        scene.tint->image = image;
        EXPECT_NEAR(effect(image), effect(centre), 30) << "under other light";
    }
}

}  // namespace
}  // namespace pectin
