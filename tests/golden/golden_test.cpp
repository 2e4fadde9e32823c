// Compares pictures of objects with inspected references.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "app/picture.h"
#include "command/script.h"
#include "ffd/drag_solver.h"
#include "golden/expect_golden.h"
#include "support/offscreen.h"
#include "support/paths.h"

namespace pectin {
namespace {

constexpr int kWidth = 320, kHeight = 240;

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
    std::ifstream text(test::source_path("assets/") + script);
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
