// Owners of OpenGL objects: movable, not copyable; the destructor deletes the object.
#pragma once

#include <utility>

#include "render/gl.h"

namespace pectin {

template <PFNGLGENBUFFERSPROC Gl::*Generate, PFNGLDELETEBUFFERSPROC Gl::*Delete>
class GlObject {
  public:
    explicit GlObject(const Gl& gl) : gl_(&gl) { (gl.*Generate)(1, &name_); }
    ~GlObject() {
        if (name_ != 0) (gl_->*Delete)(1, &name_);
    }
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }

    GLuint name() const { return name_; }

  private:
    const Gl* gl_;
    GLuint name_ = 0;
};

using GlBuffer = GlObject<&Gl::GenBuffers, &Gl::DeleteBuffers>;
using GlVertexArray = GlObject<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>;
using GlTexture = GlObject<&Gl::GenTextures, &Gl::DeleteTextures>;
using GlRenderbuffer = GlObject<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>;
using GlFramebuffer = GlObject<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>;

}  // namespace pectin
