// A frame of a drag allocates nothing, from the mouse to the session, if it splits nothing and
// needs no new plan.
#include <gtest/gtest.h>

#include <array>
#include <chrono>

#include "app/editor.h"
#include "memory/failing_new.h"
#include "session/session.h"
#include "support/expect_done.h"

namespace pectin {
namespace {

using test::FailingNew;

constexpr Vec3 kFrom{0.0, 0.0, 1.0};

// Small movements about the same place: what they need was split in the first of them.
Vec3 target(int frame) {
    return kFrom + Vec3{0.001 * (frame % 2), 0.0, 0.05 + 0.0001 * (frame % 3)};
}

void expect_no_allocations(const DragOptions& options, const std::optional<MirrorPlane>& plane,
                           Falloff falloff = Falloff::sharp) {
    Session session;
    test::expect_done(session, command::Shape{command::Shape::Kind::sphere, 4});
    test::expect_done(session, command::Brush{.radius = 0.8, .falloff = falloff});
    if (plane) test::expect_done(session, command::Symmetry{command::Symmetry::Plane::x});
    const Vec3 from = plane ? glm::normalize(Vec3{0.4, 0.0, 1.0}) : kFrom;
    ASSERT_TRUE(session.begin_drag(std::array{from}, {}, options));
    DirtyElements dirty;
    for (int frame = 0; frame < 12; ++frame) {
        ASSERT_TRUE(session.drag_to(std::array{from + target(frame) - kFrom}));
        session.take_dirty(dirty);
    }
    for (int frame = 12; frame < 30; ++frame) {
        const std::array targets{from + target(frame) - kFrom};
        const FailingNew none(0, FailingNew::How::once);
        const Done done = session.drag_to(targets);
        session.take_dirty(dirty);
        ASSERT_TRUE(done);
        ASSERT_FALSE(none.has_failed()) << "frame " << frame;
    }
    EXPECT_EQ(session.last_frame().splits, 0u);
    EXPECT_FALSE(dirty.wedges.empty());
    session.cancel_drag();
}

TEST(SteadyFrame, OfASessionAllocatesNothing) {
    for (const bool is_fold_free : {false, true}) {
        for (const bool is_connected : {false, true}) {
            const DragOptions options{.connected = is_connected, .fold_free = is_fold_free};
            expect_no_allocations(options, std::nullopt);
            expect_no_allocations(options, MirrorPlane{});
            expect_no_allocations(options, std::nullopt, Falloff::plateau);
        }
    }
}

TEST(SteadyFrame, OfTheWindowAllocatesNothing) {
    constexpr Vec2 kMiddle{640.0, 400.0};
    Editor editor({}, std::chrono::hours(1));
    editor.handle(event::Resize{{1280, 800}});
    editor.document().new_shape(command::Shape::Kind::sphere, 4);
    const auto move_to = [&](int frame) {
        const Vec2 at = kMiddle + Vec2{20.0 + 0.5 * (frame % 2), 0.25 * (frame % 3)};
        editor.handle(event::MouseMove{at});
        editor.advance();
    };
    editor.handle(event::MouseMove{kMiddle});
    editor.advance();
    editor.handle(event::Press{MouseButton::left, kMiddle});
    ASSERT_TRUE(editor.is_dragging());
    DirtyElements dirty;
    for (int frame = 0; frame < 12; ++frame) {
        move_to(frame);
        editor.workspace().session().take_dirty(dirty);
    }
    for (int frame = 12; frame < 30; ++frame) {
        const FailingNew none(0, FailingNew::How::once);
        move_to(frame);
        editor.workspace().session().take_dirty(dirty);
        ASSERT_FALSE(none.has_failed())
            << "frame " << frame << ": " << editor.workspace().message();
    }
    EXPECT_FALSE(dirty.wedges.empty());
}

}  // namespace
}  // namespace pectin
