// A window without input does nothing. Only the time that the program itself has run counts, so
// that a busy machine does not matter.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "window/window_fixture.h"

namespace pectin {
namespace {

using std::chrono::milliseconds;

class IdleWindowTest : public WindowTest {
  protected:
    // Waits until the program has done all that there is to do.
    bool comes_to_rest() {
        return eventually([this] {
            const milliseconds before = program().cpu_time();
            std::this_thread::sleep_for(milliseconds(500));
            return program().cpu_time() == before;
        });
    }
    void expect_idle(const char* when) {
        SCOPED_TRACE(when);
        ASSERT_TRUE(comes_to_rest()) << "it goes on for " << kPatience.count() << " ms";
        const milliseconds before = program().cpu_time();
        std::this_thread::sleep_for(std::chrono::seconds(4));
        // Two ticks of the clock that counts it: the window looks for input ten times a second.
        EXPECT_LE((program().cpu_time() - before).count(), 20);
    }
};

TEST_F(IdleWindowTest, UsesNoProcessorTime) {
    open_window();
    expect_idle("after the start, with the cursor on the surface");
    desktop().drag(kMiddleX - 130, kMiddleY, kMiddleX - 70, kMiddleY - 60);
    ASSERT_TRUE(records("\"drag\"")) << record();
    expect_idle("after a drag");
    desktop().key("c");
    ASSERT_TRUE(records("\"cage\"")) << record();
    desktop().key("F1");
    expect_idle("with a cage and the list of inputs");
}

}  // namespace
}  // namespace pectin
