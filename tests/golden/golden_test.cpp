// Compares pictures with inspected references: NAME.png in this folder.
//
// Processors and drivers round differently, so a few pixels may differ. For a driver that differs
// in more there is another reference. If a picture is close to none of them, the test writes it to
// the folder pictures/ of the build and prints its path. After an intended change, `scripts/golden`
// draws the references again; look at every one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/picture.h"
#include "command/script.h"
#include "ffd/drag_solver.h"
#include "io/png.h"
#include "support/offscreen.h"

namespace pectin {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr double kMaxMeanDifference = 0.75;  // of 255, over all channels
constexpr int kSmallDifference =
    16;  // of 255; allows for antialiased borders of lines that moved slightly
constexpr double kMaxDifferent = 0.005;  // fraction of pixels that may differ by more
const std::string kReferences = PECTIN_SOURCE_DIR "/tests/golden/";

class Golden : public OffscreenTest {
  protected:
    // Draws like the screenshot command, with a further overlay.
    Image picture(const Session& session, const command::Screenshot::Show& show,
                  std::optional<Camera> camera = {}, const Overlay& overlay = {}) {
        Scene scene = make_scene({.size = {kWidth, kHeight}, .camera = camera, .show = show},
                                 session.mesh(), session.lattice_in_use());
        scene.overlay.lines.insert(scene.overlay.lines.end(), overlay.lines.begin(),
                                   overlay.lines.end());
        scene.overlay.points.insert(scene.overlay.points.end(), overlay.points.begin(),
                                    overlay.points.end());
        return draw(gl(), session.mesh(), scene, {kWidth, kHeight});
    }
};

struct Difference {
    double mean = 0.0;  // of 255, over all channels
    int pixels = 0;     // number of visibly different pixels

    bool is_small() const {
        return mean <= kMaxMeanDifference && pixels <= kMaxDifferent * kWidth * kHeight;
    }
};

Difference difference(const Image& image, const PngPixels& reference) {
    Difference found;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int d = std::abs(image.rgba[i + channel] - reference.rgba[i + channel]);
            found.mean += d / (3.0 * kWidth * kHeight);
            most = std::max(most, d);
        }
        found.pixels += most > kSmallDifference;
    }
    return found;
}

// Paths of NAME.png and of NAME.VARIANT.png for drivers that draw borders of lines differently.
std::vector<std::string> references(const std::string& name) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kReferences)) {
        const std::string file = entry.path().filename().string();
        if (file.starts_with(name + ".") && file.ends_with(".png")) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

// Whether the picture is close to a reference. Adds the differences from all others to `report`.
bool matches(const std::string& name, const Image& image, std::string& report) {
    for (const std::string& path : references(name)) {
        const PngPixels reference = read_png(path);
        if (reference.rgba.size() != image.rgba.size()) continue;
        const Difference found = difference(image, reference);
        if (found.is_small()) return true;
        report += "\n  " + path + ": by " + std::to_string(found.mean) +
                  " of 255 on average, and visibly in " + std::to_string(found.pixels) + " pixels";
    }
    return false;
}

// With PECTIN_REMAKE_GOLDEN=1 the picture replaces NAME.png. With another value it becomes
// NAME.VALUE.png if no reference is close.
void expect_golden(const std::string& name, const Image& image) {
    const char* const variant = std::getenv("PECTIN_REMAKE_GOLDEN");
    std::string report;
    if (variant && variant == std::string("1")) {
        write_png(kReferences + name + ".png", kWidth, kHeight, image.rgba);
    } else if (matches(name, image, report)) {
        return;
    } else if (variant) {
        write_png(kReferences + name + "." + variant + ".png", kWidth, kHeight, image.rgba);
    } else {
        std::filesystem::create_directories(PECTIN_PICTURES);
        const std::string path = std::string(PECTIN_PICTURES) + "/" + name + ".png";
        write_png(path, kWidth, kHeight, image.rgba);
        ADD_FAILURE() << path << " differs from every reference:" << report;
    }
}

std::string sphere(int resolution) {
    return R"({"cmd": "shape", "kind": "sphere", "resolution": )" + std::to_string(resolution) +
           "}";
}
std::string brush(double radius) {
    return R"({"cmd": "brush", "radius": )" + std::to_string(radius) + "}";
}
std::string drag(const std::string& from, const std::string& to) {
    return R"({"cmd": "drag", "moves": [{"from": [)" + from + R"(], "to": [)" + to + "]}]}";
}

// Executes a script in assets/ except for its screenshots.
void sculpt(Session& session, const std::string& script) {
    std::ifstream text(std::string(PECTIN_SOURCE_DIR "/assets/") + script);
    ScriptReader reader(text);
    int done = 0;
    while (const auto line = reader.next()) {
        ASSERT_TRUE(std::holds_alternative<Command>(line->command)) << script << line->number;
        const Command& command = std::get<Command>(line->command);
        if (std::holds_alternative<command::Screenshot>(command)) continue;
        const Done executed = session.execute(command);
        ASSERT_TRUE(executed) << script << ':' << line->number << ": " << executed.refusal().reason;
        ++done;
    }
    ASSERT_GT(done, 10) << script;
}

TEST_F(Golden, MatchesForASphere) {
    Session session;
    execute(session, {sphere(5)});
    expect_golden("sphere", picture(session, {}));
}

TEST_F(Golden, MatchesForACoarseSphereWithWireframe) {
    Session session;
    execute(session, {sphere(3)});
    expect_golden("wireframe", picture(session, {.wireframe = true}));
}

TEST_F(Golden, MatchesForTheElephant) {
    Session session;
    sculpt(session, "elephant.jsonl");
    const Camera camera{.eye = Vec3(4.6, 1.3, 3.3), .target = Vec3(0.05, -0.16, 0.5), .fov = 31.0};
    expect_golden("elephant", picture(session, {}, camera));
    expect_golden("elephant_wireframe", picture(session, {.wireframe = true}, camera));
    expect_golden("elephant_levels", picture(session, {.levels = true}, camera));
}

TEST_F(Golden, MatchesForACubeWithItsCreases) {
    Session session;
    execute(session,
            {R"({"cmd": "shape", "kind": "cube", "resolution": 6})",
             R"({"cmd": "adapt", "theta_max": 12})", brush(1.6),
             drag("0.4, 1, 0.4", "0.5, 1.55, 0.5"), drag("1, -0.2, 0.2", "0.7, -0.2, 0.2")});
    expect_golden("cube", picture(session, {}));
    expect_golden("cube_wireframe", picture(session, {.wireframe = true}));
}

TEST_F(Golden, MatchesForTheInsideOfAnOpenSurface) {
    Session session;
    execute(session,
            {R"({"cmd": "shape", "kind": "plane", "resolution": 12})",
             R"({"cmd": "adapt", "theta_max": 10})", brush(1.4), drag("0, 0, 0", "0, 0.8, 0")});
    const Camera below{.eye = Vec3(1.2, -2.6, 2.2), .target = Vec3(0, 0.1, 0)};
    expect_golden("inside", picture(session, {}, below));
}

TEST_F(Golden, MatchesForADragInProgressWithItsLattice) {
    Session session;
    execute(session, {sphere(4), R"({"cmd": "adapt", "theta_max": 12})", brush(0.85)});
    const std::vector<Vec3> points{Vec3(0, 0, 1)}, pins{glm::normalize(Vec3(0.9, -0.2, 1))},
        targets{Vec3(-0.1, 0.25, 1.45)};
    ASSERT_TRUE(session.begin_drag(points, pins));
    ASSERT_TRUE(session.drag_to(targets));
    ASSERT_TRUE(session.lattice_in_use());
    const Lattice lattice = *session.lattice_in_use();
    const auto solved = DragSolver::create(lattice, points, pins);
    ASSERT_TRUE(std::holds_alternative<DragSolver>(solved));
    Overlay overlay;
    add_lattice(
        overlay, lattice,
        std::get<DragSolver>(solved).control_displacements(std::vector{targets[0] - points[0]}));
    add_drag(overlay, points[0], targets[0]);
    add_pin(overlay, pins[0]);
    const Camera camera{.eye = Vec3(2.6, 1.5, 4.0), .target = Vec3(0.1, 0.1, 0.5), .fov = 36.0};
    expect_golden("drag", picture(session, {}, camera, overlay));
    session.cancel_drag();
}

TEST_F(Golden, MatchesForAScreenshotWithALattice) {
    Session session;
    execute(session, {sphere(4), brush(0.85), drag("0, 0, 1", "0.1, 0.2, 1.2")});
    expect_golden("lattice", picture(session, {.lattice = true}));
}

}  // namespace
}  // namespace pectin
