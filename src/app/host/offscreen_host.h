// OpenGL contexts without a window or a display, for screenshots in scripts and for tests.
#pragma once

#include <memory>
#include <string_view>

#include "render/gl.h"

namespace pectin {

class OffscreenHost {
  public:
    virtual ~OffscreenHost() = default;
    OffscreenHost(const OffscreenHost&) = delete;
    OffscreenHost& operator=(const OffscreenHost&) = delete;

    // The reference stays valid as long as the host exists.
    virtual const Gl& gl() const = 0;
    // To be called before drawing if another host's context may have become current.
    virtual void make_current() = 0;

  protected:
    OffscreenHost() = default;
};

// The libraries that draw, by the names under which the system's loader finds them.
struct OffscreenLibraries {
    const char* osmesa = "libOSMesa.so.8";
    const char* egl = "libEGL.so.1";
};

// Creates a host with an OpenGL 3.3 core context and makes that context current.
// choice: "osmesa" or "egl"; if empty, OSMesa, or EGL where OSMesa cannot be used.
// Throws ContextError, naming the Debian packages to install, if no context can be created, and
// also if the choice is neither of these.
std::unique_ptr<OffscreenHost> make_offscreen_host(std::string_view choice,
                                                   const OffscreenLibraries& libraries = {});

// The same with the choice that the environment variable PECTIN_OFFSCREEN holds.
std::unique_ptr<OffscreenHost> make_offscreen_host();

}  // namespace pectin
