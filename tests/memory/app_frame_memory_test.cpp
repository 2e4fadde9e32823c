// Frames of a drag in which memory runs out. Once there is memory again, the object is shown
// completely. In a long run every allocation fails in turn, otherwise a sample of them (see
// FailurePoints). None fails while the driver draws, because drivers do not survive that.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <new>
#include <string>
#include <tuple>
#include <vector>

#include "app/object_view.h"
#include "memory/failing_new.h"
#include "support/offscreen.h"

namespace pectin {
namespace {

using test::FailingNew;
using test::FailurePoints;

constexpr IVec2 kSize{96, 96};

class FrameMemory : public OffscreenTest {
  protected:
    // A drag in progress whose last frame is on the screen.
    void prepare(Session& session, ObjectView& view) const {
        execute(session, {R"({"cmd": "shape", "kind": "sphere", "resolution": 3})",
                          R"({"cmd": "brush", "radius": 0.9})"});
        const std::vector<Vec3> points{Vec3(0, 0, 1)};
        ASSERT_TRUE(session.begin_drag(points, {}, {.connected = true, .fold_free = true}));
        show_frame(session, view, 1.3);
    }
    // A drag that has run out of memory must be cancelled. A drag whose frame could not be shown
    // may continue.
    static void show_frame(Session& session, ObjectView& view, double z) {
        const std::vector<Vec3> targets{Vec3(0.1, 0, z)};
        try {
            std::ignore = session.drag_to(targets);
        } catch (const std::bad_alloc&) {
            session.cancel_drag();
            throw;
        }
        view.update(session);
    }
    std::vector<std::uint8_t> picture(Renderer& renderer, const Canvas& canvas,
                                      const GpuMesh& mesh) const {
        const Scene scene{
            .camera = fit(Box{Vec3(-2), Vec3(2)}, 1.0), .wireframe = true, .levels = true};
        renderer.draw(mesh, scene, canvas);
        canvas.resolve();
        return canvas.read().rgba;
    }
};

TEST_F(FrameMemory, TheObjectIsShownCompletelyOnceThereIsMemoryAgain) {
    Renderer renderer(gl());
    const Canvas canvas(gl(), kSize);
    int failures = 0;
    for (const auto how : {FailingNew::How::once, FailingNew::How::from_there_on}) {
        bool is_enough = false;
        for (FailurePoints points(16); !is_enough; points.advance()) {
            SCOPED_TRACE("served " + std::to_string(points.served()));
            Session session;
            ObjectView view(gl());
            prepare(session, view);
            gl().Finish();
            bool is_done = false;
            {
                const FailingNew failing(points.served(), how);
                try {
                    show_frame(session, view, 1.8);
                    is_done = true;
                } catch (const std::bad_alloc&) {
                }
                is_enough = !failing.has_failed();
            }
            ASSERT_TRUE(is_done || !is_enough);
            failures += is_done ? 0 : 1;
            view.update(session);
            GpuMesh whole(gl());
            whole.upload(session.mesh(), view.mesh().centre());
            ASSERT_EQ(picture(renderer, canvas, view.mesh()), picture(renderer, canvas, whole));
            if (session.is_dragging()) session.cancel_drag();
        }
    }
    EXPECT_GE(failures, 20);
    std::printf("memory ended at %d allocations\n", failures);
}

}  // namespace
}  // namespace pectin
