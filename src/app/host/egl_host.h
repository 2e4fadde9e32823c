// EGL without a surface (EGL_MESA_platform_surfaceless): draws on the graphics card, or on the
// processor where there is none, without any display system.
#pragma once

#include <memory>

#include "app/host/offscreen_host.h"

namespace pectin {

// Throws ContextError, saying what is missing.
std::unique_ptr<OffscreenHost> make_egl_host(const char* library);

}  // namespace pectin
