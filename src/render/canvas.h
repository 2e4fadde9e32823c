// The framebuffer that pictures are drawn to. It is the same on every host.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/camera.h"
#include "render/gl_object.h"

namespace pectin {

// A picture with 8-bit RGBA pixels, rows from the top.
struct Image {
    IVec2 size{0};
    std::vector<std::uint8_t> rgba;  // 4 * size.x * size.y
};

// Colour and depth buffers with several samples per pixel, and the texture they are resolved to.
class Canvas {
  public:
    // samples: the wanted number per pixel. It is reduced to the limit of the context, and for
    // pictures so large that they would take gigabytes. Throws ContextError if the size is beyond
    // the limits or the memory of the context. Precondition: both sizes are above 0.
    Canvas(const Gl& gl, const IVec2& size, int samples = kSamples);
    static constexpr int kSamples = 8;

    const IVec2& size() const { return size_; }
    int samples() const { return samples_; }

    // Directs all further drawing to the whole canvas.
    void bind() const;
    // Averages the samples into the texture. Call it after drawing and before texture() or read().
    void resolve() const;
    // The resolved picture, RGBA8.
    GLuint texture() const { return texture_.name(); }
    // Copies the resolved picture without scaling. draw_framebuffer: the target; 0 is the window.
    void blit_to(GLuint draw_framebuffer) const;
    Image read() const;

  private:
    void check_size() const;
    void make_sampled();
    void make_resolved();

    const Gl* gl_;
    IVec2 size_;
    int samples_;
    GlRenderbuffer colour_, depth_;
    GlFramebuffer sampled_;
    GlTexture texture_;
    GlFramebuffer resolved_;
};

}  // namespace pectin
