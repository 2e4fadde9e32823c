// Off-screen OpenGL through EGL without a surface (EGL_MESA_platform_surfaceless). It uses the
// graphics card, or the processor if there is none, and needs no display system.
#pragma once

#include <memory>

#include "app/host/offscreen_host.h"

namespace pectin {

// Throws ContextError, which says what is missing.
std::unique_ptr<OffscreenHost> make_egl_host(const char* library);

}  // namespace pectin
