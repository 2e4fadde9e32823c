// Tests a session in which memory runs out during a command. The object is then unchanged, and the
// same command succeeds once there is memory again. In a long run every allocation fails in turn,
// otherwise a sample of them (see FailurePoints).
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include "memory/failing_new.h"
#include "session/session.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using test::FailingNew;
using test::FailurePoints;

const command::Shape kSphere{command::Shape::Kind::sphere, 3};

command::Drag drag(const Vec3& from, const Vec3& to) {
    return {.moves = {{.from = from, .to = to}}, .connected = true, .fold_free = true};
}

void execute(Session& session, const Command& command) {
    const Done done = session.execute(command);
    ASSERT_TRUE(done) << name(command) << ": " << done.refusal().reason;
}

// A refined object with steps to undo and to redo.
void prepare(Session& session) {
    execute(session, kSphere);
    execute(session, command::Brush{.radius = 0.9});
    execute(session, drag(Vec3(0, 0, 1), Vec3(0.2, 0, 1.8)));
    execute(session, drag(Vec3(0, 1, 0), Vec3(0, 1.5, 0.1)));
    execute(session, drag(Vec3(1, 0, 0), Vec3(1.4, 0, 0)));
    execute(session, command::Undo{});
}

class SessionMemory : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }

    // Runs `work` on prepared sessions until no allocation fails, each time with a later failure.
    // If the work fails, the mesh must be unchanged. A second try must succeed and give the same
    // mesh as without a failure.
    void expect_all_or_nothing(const std::function<void(Session&)>& work,
                               int least_failures = 5) const {
        Session undisturbed;
        prepare(undisturbed);
        const TriMesh before = undisturbed.mesh();
        work(undisturbed);
        const TriMesh after = undisturbed.mesh();
        int failures = 0;
        for (const auto how : {FailingNew::How::once, FailingNew::How::from_there_on}) {
            bool is_enough = false;
            for (FailurePoints points(32); !is_enough; points.advance()) {
                SCOPED_TRACE("served " + std::to_string(points.served()));
                Session session;
                prepare(session);
                bool is_done = false;
                {
                    const FailingNew failing(points.served(), how);
                    try {
                        work(session);
                        is_done = true;
                    } catch (const std::bad_alloc&) {
                        if (session.is_dragging()) session.cancel_drag();
                    }
                    is_enough = !failing.has_failed();
                }
                ASSERT_TRUE(is_done || !is_enough);
                EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
                if (!is_done) {
                    ++failures;
                    ASSERT_TRUE(session.mesh() == before);
                    work(session);
                }
                ASSERT_TRUE(session.mesh() == after);
            }
        }
        EXPECT_GE(failures, least_failures);
        std::printf("memory ended at %d allocations\n", failures);
    }
    void expect_all_or_nothing(const Command& command, int least_failures = 5) const {
        expect_all_or_nothing(
            [&command](Session& session) {
                const Done done = session.execute(command);
                if (!done) FAIL() << done.refusal().reason;
            },
            least_failures);
    }

    ScratchFolder folder_;
};

TEST_F(SessionMemory, ADragIsDoneOrChangesNothing) {
    expect_all_or_nothing(drag(Vec3(0, -1, 0), Vec3(0, -1.7, 0.2)));
}

// All memory that they need was allocated by the drag.
TEST_F(SessionMemory, UndoAndRedoOfADragNeedNoMemory) {
    expect_all_or_nothing(command::Undo{}, 0);
    expect_all_or_nothing(command::Redo{}, 0);
}

TEST_F(SessionMemory, ReadaptingIsDoneOrChangesNothing) {
    expect_all_or_nothing([](Session& session) {
        const Done done = session.execute(command::Adapt{.theta_max = Setting::of(9.0)});
        if (!done) FAIL() << done.refusal().reason;
        if (!session.execute(command::Readapt{})) FAIL();
    });
}

TEST_F(SessionMemory, BakingIsDoneOrChangesNothing) { expect_all_or_nothing(command::Bake{}); }

TEST_F(SessionMemory, ADragWithTheMouseIsDoneOrChangesNothing) {
    expect_all_or_nothing([](Session& session) {
        const std::vector<Vec3> points{Vec3(0, -1, 0)};
        ASSERT_TRUE(session.begin_drag(points, {}, {.connected = true, .fold_free = true}));
        for (int i = 1; i <= 4; ++i) {
            const std::vector<Vec3> targets{Vec3(0.1 * i, -1 - 0.2 * i, 0)};
            ASSERT_TRUE(session.drag_to(targets));
        }
        session.end_drag();
    });
}

TEST_F(SessionMemory, CancellingADragNeverFails) {
    Session session;
    prepare(session);
    const TriMesh before = session.mesh();
    const std::vector<Vec3> points{Vec3(0, -1, 0)}, targets{Vec3(0.4, -1.8, 0)};
    ASSERT_TRUE(session.begin_drag(points, {}, {.connected = true, .fold_free = true}));
    ASSERT_TRUE(session.drag_to(targets));
    ASSERT_FALSE(session.mesh() == before);
    {
        const FailingNew failing(0, FailingNew::How::from_there_on);
        session.cancel_drag();
    }
    EXPECT_TRUE(session.mesh() == before);
    EXPECT_TRUE(session.take_dirty().everything)
        << "there was no memory for a list of what to draw again";
}

TEST_F(SessionMemory, ASaveWritesTheWholeFileOrNone) {
    int failures = 0;
    Session session;
    prepare(session);
    execute(session, command::Save{path("model.obj")});
    const std::string whole = folder_.read("model.obj");
    fs::remove(path("model.obj"));
    bool is_enough = false;
    for (FailurePoints points(32); !is_enough; points.advance()) {
        SCOPED_TRACE("served " + std::to_string(points.served()));
        bool is_done = false;
        {
            const command::Save save{path("model.obj")};
            const FailingNew failing(points.served(), FailingNew::How::once);
            try {
                is_done = bool{session.execute(save)};
            } catch (const std::bad_alloc&) {
            }
            is_enough = !failing.has_failed();
        }
        failures += is_done ? 0 : 1;
        // The file may also exist if only the report of the save failed.
        const bool is_there = folder_.holds("model.obj");
        EXPECT_TRUE(is_there || !is_done);
        if (is_there) {
            EXPECT_EQ(folder_.read("model.obj"), whole);
        }
        fs::remove(path("model.obj"));
        EXPECT_TRUE(folder_.files().empty()) << "a temporary file is left";
    }
    EXPECT_GT(failures, 5);
}

TEST_F(SessionMemory, AFailedOpenKeepsTheOldModel) {
    Session first;
    prepare(first);
    execute(first, command::Save{path("model.obj")});
    expect_all_or_nothing(command::Open{.path = path("model.obj")});
}

}  // namespace
}  // namespace pectin
