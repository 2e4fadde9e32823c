// OpenGL 3.3 core through a struct of function pointers, one for each context.
//
// A host makes a context, makes it current and loads its functions; everything in this room takes
// them as `const Gl&`, keeps the address, and must go before them, with the context current.
#pragma once

#include <glad/gl.h>

#include <stdexcept>

namespace pectin {

using Gl = GladGLContext;
// The host's own look-up: eglGetProcAddress, glfwGetProcAddress, OSMesaGetProcAddress.
using GetProc = GLADloadfunc;

// No context, or one that cannot draw what is asked for; what() says what to install or change.
class ContextError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Precondition: the context is current. Throws ContextError below OpenGL 3.3, naming what is there.
Gl load_gl(GetProc get_proc);

// Throws ContextError, naming `doing`, where OpenGL has run out of memory; asserts that no other
// error is pending.
void check_errors(const Gl& gl, const char* doing);

}  // namespace pectin
