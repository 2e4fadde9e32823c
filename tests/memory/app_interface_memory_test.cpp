// Memory runs out while the panels are laid out.
#include <gtest/gtest.h>

#include <new>

#include "app/ui/interface.h"
#include "memory/failing_new.h"

namespace pectin {
namespace {

TEST(InterfaceMemory, EventsAfterALackOfMemoryStillReachThePanels) {
    Editor editor;
    Interface interface(1.0f);
    interface.set_size({1280, 800}, {1280, 800});
    editor.handle(event::Resize{{1280, 800}});
    editor.begin("");
    // The change makes quitting ask. The test must not open a file browser, because the standard
    // library's directory_iterator does not survive a lack of memory.
    ASSERT_TRUE(editor.execute(command::Drag{.moves = {{Vec3(0, 0, 1), Vec3(0, 0, 1.2)}}}));
    interface.lay_out(editor, {});
    const auto press = [&](Key key, Modifiers modifiers = {}) {
        interface.handle(editor, event::KeyDown{key, modifiers});
        interface.handle(editor, event::KeyUp{key});
    };
    std::size_t failures = 0;
    for (bool has_failed = true; has_failed; failures += has_failed) {
        editor.workspace().set_message("A message so long that laying it out needs memory.");
        {
            const test::FailingNew failing(failures, test::FailingNew::How::once);
            try {
                press(Key{'Q'}, {.control = true});
                interface.lay_out(editor, {});
            } catch (const std::bad_alloc&) {
                editor.handle_out_of_memory("frame");
            }
            has_failed = failing.has_failed();
        }
        interface.lay_out(editor, {});
        press(Key::escape);
        ASSERT_FALSE(editor.document().question()) << failures;
        editor.workspace().dismiss();
        press(Key{'S'}, {.shift = true, .control = true});
        ASSERT_TRUE(editor.document().browser()) << failures;
        interface.handle(editor, event::KeyDown{Key{'X'}});
        interface.handle(editor, event::Character{'x'});
        interface.handle(editor, event::KeyUp{Key{'X'}});
        ASSERT_EQ(editor.document().browser()->name, "x") << failures;
        press(Key::escape);
        ASSERT_FALSE(editor.document().browser()) << failures;
        interface.lay_out(editor, {});
    }
    EXPECT_GT(failures, 3u);
    RecordProperty("failures", static_cast<int>(failures));
}

}  // namespace
}  // namespace pectin
