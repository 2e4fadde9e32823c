// Loads the functions of OpenGL 3.3 core into a struct, one for each context.
//
// A host creates a context, makes it current and loads its functions. The classes of this module
// take them as `const Gl&` and keep the address. They must be destroyed before it, with the context
// current.
#pragma once

#include <glad/gl.h>

#include <stdexcept>
#include <string>

namespace pectin {

using Gl = GladGLContext;
// Finds a function: eglGetProcAddress, glfwGetProcAddress or OSMesaGetProcAddress.
using GetProc = GLADloadfunc;

// Thrown if there is no context or it cannot draw what is asked. what() says what to install or
// change.
class ContextError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Precondition: the context is current. Throws ContextError, with the version, below OpenGL 3.3.
Gl load_gl(GetProc get_proc);

// What draws and its version, in the words of the driver.
std::string description_of(const Gl& gl);

// Throws ContextError if OpenGL has run out of memory. Asserts that no other error is pending.
// doing: what was attempted, for the message.
void check_errors(const Gl& gl, const char* doing);

}  // namespace pectin
