// Uploads during a drag.
#include "app/object_view.h"

#include <gtest/gtest.h>

#include "app/editor.h"
#include "app/editor_scene.h"
#include "support/editor_tools.h"
#include "support/offscreen.h"

namespace pectin {
namespace {

class ObjectViewTest : public OffscreenTest {};

// The object has 1.3 million faces, and the brush reaches a few hundred of them.
TEST_F(ObjectViewTest, FramesOfADragUploadOnlyWhatTheyChange) {
    Editor editor;
    editor.handle(event::Resize{{1280, 800}});
    editor.document().new_shape(command::Shape::Kind::sphere, 8);
    editor.set_radius(0.02);
    ObjectView view(gl());
    Session& session = editor.workspace().session();
    const std::size_t whole = view.update(session).bytes;
    ASSERT_GT(whole, 30'000'000u);
    EXPECT_EQ(view.update(session).bytes, 0u) << "nothing has changed since";

    editor.handle(event::MouseMove{{640, 400}});
    editor.handle(event::Press{MouseButton::left, {640, 400}});
    ASSERT_TRUE(test::sculptor(editor).is_dragging());
    for (int i = 1; i <= 6; ++i) {
        editor.handle(event::MouseMove{{640 + i, 400 - i}});
        editor.advance();
        const std::size_t bytes = view.update(session).bytes;
        EXPECT_GT(bytes, 0u);
        EXPECT_LT(bytes, whole / 100) << "frame " << i;
    }
    editor.handle(event::Release{MouseButton::left, {646, 394}});
    const std::size_t commit = view.update(session).bytes;
    EXPECT_GT(commit, 0u);
    EXPECT_LT(commit, whole / 100);
}

TEST_F(ObjectViewTest, ADragAndUndoRestoreThePicture) {
    Editor editor;
    editor.handle(event::Resize{{320, 240}});
    editor.document().new_shape(command::Shape::Kind::sphere, 3);
    ObjectView view(gl());
    Session& session = editor.workspace().session();
    view.update(session);
    const auto picture = [&] {
        return draw(gl(), view.mesh(), editor_scene(editor, 1.0f), {320, 240}).rgba;
    };
    const auto before = picture();
    editor.handle(event::Press{MouseButton::left, {160, 120}});
    editor.handle(event::MouseMove{{190, 90}});
    editor.advance();
    view.update(session);
    EXPECT_NE(picture(), before);
    editor.handle(event::Release{MouseButton::left, {190, 90}});
    view.update(session);
    editor.perform(Action::undo);
    view.update(session);
    EXPECT_EQ(picture(), before);
}

}  // namespace
}  // namespace pectin
