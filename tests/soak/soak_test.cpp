// Tests one long session with many objects and random commands. The mesh stays valid, impossible
// commands are refused, and undo and redo restore every step to the byte. PECTIN_TEST_SEED chooses
// the object to begin with.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <variant>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/random_commands.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

struct Input {
    IndexedFaceSet set;
    std::string description;
};

// A prism. The side walls are quads. Each end is one polygon, which is concave and often has sharp
// spikes.
Input star_prism(Random& random) {
    IndexedFaceSet set;
    const auto corners = static_cast<std::uint32_t>(random.integer(3, 40));
    for (int end = 0; end < 2; ++end) {
        Random radii(corners);
        for (std::uint32_t i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const double radius = radii.uniform(0.3, 1.0);
            set.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                       end - 0.5);
        }
    }
    set.parts.emplace_back();
    const auto add = [&](const std::vector<std::uint32_t>& polygon) {
        for (std::uint32_t v : polygon) set.corners.push_back({.position = v});
        set.polygon_end.push_back(static_cast<std::uint32_t>(set.corners.size()));
        set.polygon_part.push_back(0);
    };
    std::vector<std::uint32_t> bottom, top;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t next = (i + 1) % corners;
        add({i, next, corners + next, corners + i});
        bottom.push_back(corners - 1 - i);
        top.push_back(corners + i);
    }
    add(bottom);
    add(top);
    return {std::move(set), "prism of a star with " + std::to_string(corners) + " corners"};
}

// A random object as OBJ text: a prism with large polygons, a random mesh, or a real model if the
// folder of models is present. Some vertices of a model may be duplicated, so that seams arise.
std::string random_object(Random& random, std::string& description) {
    if (random.chance(0.25)) {
        const Input prism = star_prism(random);
        description = prism.description;
        return format_obj(build_mesh(prism.set).mesh);
    }
    const auto models = test::real_models();
    if (!models.empty() && random.chance(0.1)) {
        const auto& path = models[static_cast<std::size_t>(
            random.integer(0, static_cast<int>(models.size()) - 1))];
        IndexedFaceSet set = read_obj(path);
        description = path;
        if (set.polygon_count() < 6'000 && random.chance(0.5)) {
            test::unshare_vertices(set, random, random.uniform(0.1, 1.0));
            description += ", vertices not shared";
        }
        if (set.polygon_count() < 6'000) return format_obj(build_mesh(set).mesh);
    }
    const test::RandomMesh generated = test::random_mesh(random);
    description = generated.description;
    return format_obj(generated.mesh);
}

// A command with extreme or invalid values. It must be refused, or executed without making the mesh
// invalid.
Command hostile_command(const TriMesh& mesh, Random& random) {
    constexpr double kValues[] = {0.0,
                                  -1.0,
                                  1e-300,
                                  1e300,
                                  -1e300,
                                  1e-9,
                                  1e9,
                                  1e154,
                                  1e-40,
                                  std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
    const auto value = [&] { return kValues[random.integer(0, 10)]; };
    const auto point = [&] {
        const double x = value(), y = value(), z = value();
        return Vec3{x, y, z};
    };
    const Vec3 centre = mesh.bounding_box().centre();
    switch (random.integer(0, 7)) {
        case 0:
            return command::Drag{.moves = {{centre, point()}}};
        case 1: {
            const Vec3 from = point();
            return command::Drag{.moves = {{from, point()}}, .pins = {centre}};
        }
        case 2:
            return command::Undo{.count = random.integer(-3, 3)};
        case 3: {
            const IVec3 index{random.integer(-300, 300), random.integer(-2, 2), 0};
            return command::Control{.points = {{index, point()}}};
        }
        case 4:
            return command::Brush{.radius = value(),
                                  .span = random.integer(-1, 20),
                                  .falloff = static_cast<Falloff>(random.integer(0, 1))};
        case 5: {
            const Vec3 origin = point(), cell = point();
            const int count = random.integer(-1, 4);
            return command::Cage{.origin = origin, .cell = cell, .deformable = IVec3{count}};
        }
        case 6:
            return command::Open{.path = "/nowhere/at all.obj"};
        default:
            return command::Symmetry{.plane = command::Symmetry::Plane::y, .through = point()};
    }
}

std::size_t digest(const TriMesh& mesh) { return std::hash<std::string>{}(format_obj(mesh)); }

struct Totals {
    int commands = 0, done = 0, objects = 0;
    std::size_t steps_undone = 0;
};

class Soak : public testing::Test {
  protected:
    void open(const std::string& obj) {
        folder_.write("a.obj", obj);
        const Done done = session_.execute(command::Open{.path = folder_.path("a.obj")});
        ASSERT_TRUE(done) << done.refusal().reason;
        const double size = 0.3 * session_.mesh().bounding_box().diagonal();
        size_ = size > 0.0 ? size : 1.0;
        // Larger objects need a larger budget. It is limited, so that every session ends.
        budget_ = std::max<std::uint64_t>(5'000, 2 * session_.mesh().face_count());
        // Every setting is given, because those used for the previous object remain in force.
        ASSERT_TRUE(session_.execute(command::Adapt{.enabled = true,
                                                    .theta_max = Setting::of(20.0),
                                                    .theta_min = Setting::automatic(),
                                                    .l_max = Setting::automatic(),
                                                    .flatness = Setting::automatic(),
                                                    .floor = Setting::of(0.05 * size_),
                                                    .budget = budget_,
                                                    .propagation = 1.0}));
        ASSERT_TRUE(session_.execute(command::Symmetry{}));
        ASSERT_TRUE(session_.execute(command::Brush{.radius = 0.5 * size_, .span = 1}));
    }

    Command next_command(Random& random) {
        if (random.chance(0.03)) return hostile_command(session_.mesh(), random);
        return test::random_command(session_.mesh(), random, size_, budget_);
    }

    bool execute(const Command& command, Random& random) {
        try {
            return test::execute(session_, command, random);
        } catch (const FileError&) {
            return false;
        }
    }

    // Executes commands on the open object, and then undoes and redoes all steps.
    void sculpt(int commands, Random& random) {
        std::map<std::size_t, std::size_t> seen{{0, digest(session_.mesh())}};
        for (int i = 0; i < commands; ++i) {
            const Command command = next_command(random);
            SCOPED_TRACE("command " + std::to_string(i) + ": " + name(command));
            const std::size_t step = session_.history().step_number();
            const bool done = execute(command, random);
            ++totals_.commands;
            totals_.done += done ? 1 : 0;
            const std::size_t now = session_.history().step_number();
            const bool moves_along_steps = std::holds_alternative<command::Undo>(command) ||
                                           std::holds_alternative<command::Redo>(command);
            if (now > step && !moves_along_steps) {
                seen[now] = digest(session_.mesh());
            } else {
                ASSERT_EQ(digest(session_.mesh()), seen.at(now));
            }
            ASSERT_EQ(session_.mesh().validate(), std::vector<std::string>{});
            if (HasFailure()) return;
        }
        expect_every_step(seen);
    }

    void expect_every_step(const std::map<std::size_t, std::size_t>& seen) {
        const History& history = session_.history();
        while (session_.execute(command::Undo{})) {
            ASSERT_EQ(digest(session_.mesh()), seen.at(history.step_number())) << "undone";
            ++totals_.steps_undone;
        }
        ASSERT_EQ(history.step_number(), history.lost_undo_count());
        while (session_.execute(command::Redo{})) {
            ASSERT_EQ(digest(session_.mesh()), seen.at(history.step_number())) << "redone";
        }
        ASSERT_EQ(session_.mesh().validate(), std::vector<std::string>{});
    }

    Session session_;
    Totals totals_;
    double size_ = 1.0;
    std::uint64_t budget_ = 5'000;

  private:
    ScratchFolder folder_;
};

TEST_F(Soak, RandomCommandsKeepEveryStep) {
    const bool is_long = test::is_long();
    const int wanted = is_long ? 100'000 : 1'000;
    const char* const first = std::getenv("PECTIN_TEST_SEED");
    std::uint64_t seed = first ? std::strtoull(first, nullptr, 10) : 90'000;
    for (; totals_.commands < wanted; ++seed) {
        Random random(seed);
        std::string description;
        const std::string obj = random_object(random, description);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        if (is_long) {  // a crash would not print the traces
            std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
            std::fflush(stdout);
        }
        open(obj);
        if (HasFailure()) return;
        ++totals_.objects;
        sculpt(std::min(100, wanted - totals_.commands), random);
        if (HasFailure()) return;
    }
    std::printf(
        "seeds 90000 to %d: %d commands, %d of them done, on %d objects, %zu steps undone\n",
        static_cast<int>(seed) - 1, totals_.commands, totals_.done, totals_.objects,
        totals_.steps_undone);
    EXPECT_GT(totals_.done, wanted / 3);
    EXPECT_GT(totals_.steps_undone, static_cast<std::size_t>(wanted / 50));
}

}  // namespace
}  // namespace pectin
