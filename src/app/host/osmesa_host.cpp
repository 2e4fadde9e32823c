#include "app/host/osmesa_host.h"

#include <array>
#include <string>

#include "app/host/shared_library.h"

namespace pectin {
namespace {

// From GL/osmesa.h, which the package libosmesa6 does not contain.
constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37, kRgba = 0x1908;

class OsmesaHost : public OffscreenHost {
  public:
    explicit OsmesaHost(const char* library);
    ~OsmesaHost() override { destroy_(context_); }

    const Gl& gl() const override { return gl_; }
    void make_current() override;

  private:
    // The library is opened and never linked: it defines the same functions as libGL.
    SharedLibrary library_;
    void (*destroy_)(void*) = library_.find<void(void*)>("OSMesaDestroyContext");
    unsigned char (*make_current_)(void*, void*, GLenum, GLsizei, GLsizei) =
        library_.find<unsigned char(void*, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
    // OSMesa requires an image, though the program draws into its own framebuffer.
    static constexpr int kSide = 16;  // pixels
    std::array<unsigned char, 4 * kSide * kSide> pixels_{};
    void* context_ = nullptr;
    Gl gl_{};
};

OsmesaHost::OsmesaHost(const char* library) : library_(library) {
    auto* const create = library_.find<void*(const int*, void*)>("OSMesaCreateContextAttribs");
    auto* const get_proc = library_.find<GLADapiproc(const char*)>("OSMesaGetProcAddress");
    const std::array attributes{kFormat,       kRgba, kDepthBits,    24, kProfile, kCoreProfile,
                                kMajorVersion, 3,     kMinorVersion, 3,  0};
    context_ = create(attributes.data(), nullptr);
    if (!context_) throw ContextError("OSMesa cannot draw with OpenGL 3.3");
    try {
        make_current();
        gl_ = load_gl(get_proc);
    } catch (...) {
        destroy_(context_);  // the destructor does not run after a constructor that throws
        throw;
    }
}

void OsmesaHost::make_current() {
    if (!make_current_(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide)) {
        throw ContextError("OSMesa cannot use its picture");
    }
}

}  // namespace

std::unique_ptr<OffscreenHost> make_osmesa_host(const char* library) {
    return std::make_unique<OsmesaHost>(library);
}

}  // namespace pectin
