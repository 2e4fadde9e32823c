#include "render/gl.h"

#include <cassert>
#include <string>

namespace pectin {
namespace {

constexpr const char* kWhatHelps =
    "pectin needs OpenGL 3.3; install a newer graphics driver, or libgl1-mesa-dri, which draws "
    "without a graphics card";

std::string text(const Gl& gl, GLenum name) {
    const GLubyte* found = gl.GetString ? gl.GetString(name) : nullptr;
    return found ? reinterpret_cast<const char*>(found) : "unknown";
}

}  // namespace

Gl load_gl(GetProc get_proc) {
    Gl gl{};
    const int version = gladLoadGLContext(&gl, get_proc);
    if (version == 0) {
        throw ContextError(std::string("no OpenGL functions were found; ") + kWhatHelps);
    }
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        throw ContextError("OpenGL " + text(gl, GL_VERSION) + " by " + text(gl, GL_RENDERER) +
                           " is too old; " + kWhatHelps);
    }
    return gl;
}

std::string description_of(const Gl& gl) {
    return text(gl, GL_RENDERER) + ", OpenGL " + text(gl, GL_VERSION);
}

void check_errors(const Gl& gl, const char* doing) {
    const GLenum error = gl.GetError();
    if (error == GL_OUT_OF_MEMORY) {
        throw ContextError(std::string("there is not enough graphics memory for ") + doing +
                           "; use a smaller picture or model");
    }
    assert(error == GL_NO_ERROR);
}

}  // namespace pectin
