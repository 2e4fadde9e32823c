// Off-screen OpenGL through OSMesa, which draws on the processor and needs no display system. Mesa
// 25.1 and later do not contain it.
#pragma once

#include <memory>

#include "app/host/offscreen_host.h"

namespace pectin {

// Throws ContextError, which says what is missing.
std::unique_ptr<OffscreenHost> make_osmesa_host(const char* library);

}  // namespace pectin
