// Passes input events to Dear ImGui. Its own backend for GLFW cannot be used for this: it reads the
// position of the mouse when a frame begins, which is too late for the clicks of a slow frame.
#pragma once

#include "app/input_event.h"

namespace pectin {

// To be called once after the context of Dear ImGui has been created.
void set_up_imgui_input();

// Takes effect in the next frame of Dear ImGui. Precondition: in each frame, a key or button
// changes at most once, because a press and a release within one frame would not be noticed.
void feed_imgui(const InputEvent& input);

}  // namespace pectin
