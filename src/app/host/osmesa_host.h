// Mesa's off-screen interface: draws on the processor, into memory, without any display system.
// Mesa 25.1 and later do not ship it.
#pragma once

#include <memory>

#include "app/host/offscreen_host.h"

namespace pectin {

// Throws ContextError, saying what is missing.
std::unique_ptr<OffscreenHost> make_osmesa_host(const char* library);

}  // namespace pectin
