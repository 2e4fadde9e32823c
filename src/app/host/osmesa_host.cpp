#include "app/offscreen_host.h"

#include <dlfcn.h>

#include <array>
#include <string>

namespace pectin {
namespace {

constexpr const char* kWhatHelps =
    "pictures without a window are drawn by libOSMesa.so.8; install the package libosmesa6";

// From GL/osmesa.h, which libosmesa6 comes without.
constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37, kRgba = 0x1908;

// The library is opened and never linked: it defines the same functions as libGL. It stays in
// memory once opened, so that a leak checker can still name what it leaks.
class Library {
  public:
    explicit Library(const char* name)
        : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
        if (!handle_) throw ContextError(std::string(dlerror()) + "; " + kWhatHelps);
    }
    ~Library() { dlclose(handle_); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    template <class Function>
    Function* find(const char* name) const {
        void* const found = dlsym(handle_, name);
        if (!found) throw ContextError(std::string(name) + " is missing; " + kWhatHelps);
        return reinterpret_cast<Function*>(found);
    }

  private:
    void* handle_;
};

}  // namespace

struct OffscreenHost::Context {
    explicit Context(const char* library_name);
    ~Context() { destroy(context); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    void make_current();

    static constexpr int kSide = 16;  // pixels; the program draws into a framebuffer of its own
    Library library;
    void (*destroy)(void*) = library.find<void(void*)>("OSMesaDestroyContext");
    unsigned char (*make)(void*, void*, GLenum, GLsizei, GLsizei) =
        library.find<unsigned char(void*, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
    std::array<unsigned char, 4 * kSide * kSide> pixels{};  // may not be absent
    void* context = nullptr;
    Gl gl{};
};

OffscreenHost::Context::Context(const char* library_name) : library(library_name) {
    auto* const create = library.find<void*(const int*, void*)>("OSMesaCreateContextAttribs");
    auto* const get_proc = library.find<GLADapiproc(const char*)>("OSMesaGetProcAddress");
    const std::array attributes{kFormat,       kRgba, kDepthBits,    24, kProfile, kCoreProfile,
                                kMajorVersion, 3,     kMinorVersion, 3,  0};
    context = create(attributes.data(), nullptr);
    if (!context) {
        throw ContextError(std::string("OSMesa cannot draw with OpenGL 3.3; ") + kWhatHelps);
    }
    try {
        make_current();
        gl = load_gl(get_proc);
    } catch (...) {
        destroy(context);  // the destructor of what was never made does not run
        throw;
    }
}

void OffscreenHost::Context::make_current() {
    if (!make(context, pixels.data(), GL_UNSIGNED_BYTE, kSide, kSide)) {
        throw ContextError(std::string("OSMesa cannot use its picture; ") + kWhatHelps);
    }
}

OffscreenHost::OffscreenHost(const char* library) : context_(std::make_unique<Context>(library)) {}
OffscreenHost::~OffscreenHost() = default;

const Gl& OffscreenHost::gl() const { return context_->gl; }

void OffscreenHost::make_current() { context_->make_current(); }

}  // namespace pectin
