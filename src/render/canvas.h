// The picture being drawn: the program's own framebuffer, the same on every host.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/camera.h"
#include "render/gl_object.h"

namespace pectin {

// RGBA, 8 bits each, rows from the top.
struct Image {
    IVec2 size{0};
    std::vector<std::uint8_t> rgba;  // 4 * size.x * size.y
};

// Colour and depth with several samples a pixel, and the texture they are resolved to.
class Canvas {
  public:
    // samples: wanted a pixel; clamped to what the context can do and, for pictures so large that
    // they would take gigabytes, to fewer. Throws ContextError where the size is beyond the
    // context's limits or its memory. Precondition: both sizes are above 0.
    Canvas(const Gl& gl, const IVec2& size, int samples = kSamples);
    static constexpr int kSamples = 8;

    const IVec2& size() const { return size_; }
    int samples() const { return samples_; }

    // Draws go here from now on, over all of the canvas.
    void bind() const;
    // Averages the samples into the texture. After drawing, before texture() or read().
    void resolve() const;
    // RGBA8, to be drawn or sampled.
    GLuint texture() const { return texture_.name(); }
    // Copies the resolved picture to the framebuffer that `draw_framebuffer` names (0: the
    // window's), pixel by pixel.
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
