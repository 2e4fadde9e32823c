#include "render/canvas.h"

#include <algorithm>
#include <string>

namespace pectin {
namespace {

constexpr std::int64_t kMaxSamples = std::int64_t{64}
                                     << 20;  // per picture; they take half a gigabyte

int clamped_samples(const Gl& gl, const IVec2& size, int wanted) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &most);
    const std::int64_t affordable = kMaxSamples / (std::int64_t{size.x} * size.y);
    return static_cast<int>(std::clamp<std::int64_t>(affordable, 1, std::min(most, wanted)));
}

void check_complete(const Gl& gl) {
    check_errors(gl, "the picture");
    const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    throw ContextError("the graphics driver cannot draw into a picture of its own (status " +
                       std::to_string(status) + "); install a newer one");
}

}  // namespace

Canvas::Canvas(const Gl& gl, const IVec2& size, int samples)
    : gl_(&gl),
      size_(size),
      samples_(clamped_samples(gl, size, samples)),
      colour_(gl),
      depth_(gl),
      sampled_(gl),
      texture_(gl),
      resolved_(gl) {
    check_size();
    make_sampled();
    make_resolved();
}

void Canvas::check_size() const {
    GLint largest = 0;
    gl_->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (std::max(size_.x, size_.y) <= largest) return;
    throw ContextError("a picture of " + std::to_string(size_.x) + " by " +
                       std::to_string(size_.y) + " pixels is too large; this driver draws up to " +
                       std::to_string(largest) + " each way");
}

void Canvas::make_sampled() {
    // One sample is requested as 0, because some drivers take 1 for more.
    const GLsizei samples = samples_ > 1 ? samples_ : 0;
    gl_->BindRenderbuffer(GL_RENDERBUFFER, colour_.name());
    gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size_.x, size_.y);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, size_.x,
                                        size_.y);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 colour_.name());
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                 depth_.name());
    check_complete(*gl_);
}

void Canvas::make_resolved() {
    gl_->BindTexture(GL_TEXTURE_2D, texture_.name());
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_.x, size_.y, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(),
                              0);
    check_complete(*gl_);
}

void Canvas::bind() const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
    gl_->Viewport(0, 0, size_.x, size_.y);
}

void Canvas::resolve() const {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
    gl_->BlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

void Canvas::blit_to(GLuint draw_framebuffer) const {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, draw_framebuffer);
    gl_->BlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

Image Canvas::read() const {
    const std::size_t stride = 4 * static_cast<std::size_t>(size_.x);
    Image image{.size = size_, .rgba = {}};
    image.rgba.resize(stride * static_cast<std::size_t>(size_.y));
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_->ReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    check_errors(*gl_, "reading the picture back");
    // OpenGL's first row is the bottom row.
    auto top = image.rgba.begin();
    auto bottom = image.rgba.end() - static_cast<std::ptrdiff_t>(stride);
    for (; top < bottom; top += static_cast<std::ptrdiff_t>(stride),
                         bottom -= static_cast<std::ptrdiff_t>(stride)) {
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(stride), bottom);
    }
    return image;
}

}  // namespace pectin
