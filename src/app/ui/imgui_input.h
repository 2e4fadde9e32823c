// Translates input events to Dear ImGui, whose own backend for GLFW cannot be used for this: it
// reads where the mouse is when a frame begins, which is too late for the clicks of a slow frame.
#pragma once

#include "app/input_event.h"

namespace pectin {

// To be called once after the context of Dear ImGui has been created.
void set_up_imgui_input();

// Takes effect in the next frame of Dear ImGui. Of a key or a button, give it at most one change
// for each frame: a press and a release within one frame are not seen.
void feed_imgui(const InputEvent& input);

}  // namespace pectin
