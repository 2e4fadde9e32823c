// Drags with the mouse in which memory runs out. The displayed positions are those of the object,
// and a window whose drag could not be ended has none. In a long run every allocation fails in
// turn, otherwise a sample of them (see FailurePoints) and each of the last ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>
#include <vector>

#include "app/editor.h"
#include "app/tools/sculptor.h"
#include "memory/failing_new.h"
#include "session/session.h"
#include "support/editor_tools.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using test::FailingNew;
using test::FailurePoints;

// The positions of all wedges as a window would display them.
class Picture {
  public:
    void update(Session& session) {
        const DirtyElements dirty = session.take_dirty();
        const TriMesh& mesh = session.mesh();
        shown_.resize(mesh.wedge_slots());
        const auto learn = [&](HalfEdgeId h) {
            shown_[index(mesh.wedge(h))] = mesh.position(mesh.origin(h));
        };
        const std::vector<FaceId> faces = test::live_faces(mesh);
        if (dirty.everything) {
            for (FaceId f : faces) {
                for (int c = 0; c < 3; ++c) learn(TriMesh::half_edge(f, c));
            }
            return;
        }
        for (FaceId f : faces) {
            const bool is_dirty = std::binary_search(dirty.faces.begin(), dirty.faces.end(), f);
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                if (is_dirty ||
                    std::binary_search(dirty.wedges.begin(), dirty.wedges.end(), mesh.wedge(h))) {
                    learn(h);
                }
            }
        }
    }
    bool shows(const TriMesh& mesh) const {
        for (FaceId f : test::live_faces(mesh)) {
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                const std::size_t w = index(mesh.wedge(h));
                if (w >= shown_.size() || shown_[w] != mesh.position(mesh.origin(h))) return false;
            }
        }
        return true;
    }

  private:
    std::vector<Vec3> shown_;
};

void prepare(Session& session) {
    test::expect_done(session, command::Shape{command::Shape::Kind::sphere, 3});
    test::expect_done(session, command::Brush{.radius = 0.9});
    // The limit is enough for two steps, so that the tested step drops the oldest one.
    test::expect_done(session, command::Drag{.moves = {{Vec3(0, 0, 1), Vec3(0.2, 0, 1.8)}}});
    test::expect_done(session, command::Drag{.moves = {{Vec3(0, 1, 0), Vec3(0, 1.5, 0.1)}}});
    const auto bytes = static_cast<double>(session.history().memory_bytes());
    test::expect_done(session, command::History{Setting::of(1e-6 * bytes + 1e-3)});
}

// The drag is so long that its steps are planned again while it goes on, since it is fold-free.
void drag_with_mouse(Session& session, Sculptor& hand, Picture& picture) {
    const Camera camera;
    const Ray ray{Vec3(0.3, -0.6, 3), Vec3(0, 0, -1)};
    const auto pick = session.pick(ray);
    ASSERT_TRUE(pick.has_value());
    ASSERT_TRUE(hand.grab(session, *pick, ray, {}, {.connected = true, .fold_free = true}));
    for (int i = 1; i <= 4; ++i) {
        const Ray towards{Vec3(0.3 + 0.1 * i, -0.6 - 0.25 * i, 3), Vec3(0, 0, -1)};
        ASSERT_TRUE(hand.drag(session, camera, towards, DragPath::view_plane));
        picture.update(session);
    }
    session.end_drag();
    hand.end();
}

// Drags while only so many allocations succeed. Returns whether the drag was not interrupted.
bool drag_until_memory_ends(std::size_t served, FailingNew::How how) {
    Session session;
    Sculptor hand;
    Picture picture;
    prepare(session);
    picture.update(session);
    const std::size_t steps = session.history().step_number();
    bool has_ended = false;
    {
        const FailingNew failing(served, how);
        try {
            drag_with_mouse(session, hand, picture);
            has_ended = true;
        } catch (const std::bad_alloc&) {
        }
        if (!failing.has_failed()) return true;
    }
    // A step that was done is never reported as failed.
    EXPECT_EQ(session.history().step_number(), steps + (has_ended ? 1 : 0));
    if (session.is_dragging()) session.cancel_drag();
    hand.end();
    picture.update(session);
    EXPECT_TRUE(picture.shows(session.mesh()));
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    return false;
}

// Releases the mouse while only so many allocations succeed. Returns whether none failed.
bool release_until_memory_ends(std::size_t served, FailingNew::How how) {
    const Vec2 from{640, 400}, to{700, 300};
    Editor editor;
    editor.handle(event::Resize{{1280, 800}});
    editor.document().new_shape(command::Shape::Kind::sphere, 3);
    const TriMesh before = editor.session().mesh();
    editor.handle(event::MouseMove{from, {}});
    editor.handle(event::Press{MouseButton::left, from, {}});
    editor.handle(event::MouseMove{to, {}});
    editor.advance();
    EXPECT_TRUE(test::sculptor(editor).is_dragging());
    {
        const FailingNew failing(served, how);
        try {
            editor.handle(event::Release{MouseButton::left, to, {}});
            editor.advance();
        } catch (const std::bad_alloc&) {
            editor.handle_out_of_memory("frame");
        }
        if (!failing.has_failed()) return true;
    }
    EXPECT_FALSE(test::sculptor(editor).is_dragging());
    EXPECT_FALSE(editor.session().is_dragging());
    EXPECT_EQ(editor.session().mesh() == before, editor.session().undo_count() == 0);
    EXPECT_EQ(editor.session().mesh().validate(), std::vector<std::string>{});
    return false;
}

TEST(EditorMemory, NoDragIsLeftWhoseEndHasFailed) {
    int failures = 0;
    for (const auto how : {FailingNew::How::once, FailingNew::How::from_there_on}) {
        for (FailurePoints points(24); !release_until_memory_ends(points.served(), how);
             points.advance()) {
            ++failures;
            ASSERT_FALSE(HasFailure()) << "served " << points.served();
        }
    }
    EXPECT_GT(failures, 20);
}

TEST(SculptorMemory, ThePictureAgreesWithTheSession) {
    int failures = 0;
    for (const auto how : {FailingNew::How::once, FailingNew::How::from_there_on}) {
        // Then each of the last allocations, when the drag ends.
        std::size_t last_interrupted = 0;
        for (FailurePoints points(24); !drag_until_memory_ends(points.served(), how);
             points.advance()) {
            ++failures;
            last_interrupted = points.served();
            ASSERT_FALSE(HasFailure()) << "served " << points.served();
        }
        for (std::size_t served = last_interrupted; !drag_until_memory_ends(served, how);
             ++served) {
            ++failures;
            ASSERT_FALSE(HasFailure()) << "served " << served;
        }
    }
    EXPECT_GT(failures, 20);
    std::printf("memory ended at %d allocations\n", failures);
}

}  // namespace
}  // namespace pectin
