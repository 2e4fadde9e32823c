// An OpenGL context without a window or a display: OSMesa, found at run time.
#pragma once

#include <memory>

#include "render/gl.h"

namespace pectin {

class OffscreenHost {
  public:
    // Makes the context and makes it current. Throws ContextError where OSMesa is not installed.
    explicit OffscreenHost(const char* library = "libOSMesa.so.8");
    ~OffscreenHost();
    OffscreenHost(const OffscreenHost&) = delete;
    OffscreenHost& operator=(const OffscreenHost&) = delete;

    // Stays where it is as long as the host does.
    const Gl& gl() const;
    // To be called before drawing where another host's context may be current.
    void make_current();

  private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace pectin
