#include "app/host/egl_host.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <string>

#include "app/host/shared_library.h"

namespace pectin {
namespace {

class EglHost : public OffscreenHost {
  public:
    explicit EglHost(const char* library);
    ~EglHost() override { release(); }

    const Gl& gl() const override { return gl_; }
    void make_current() override;

  private:
    template <class Function>
    Function* find(const char* name) const {
        return library_.find<Function>(name);
    }
    void open_display();
    void create_context();
    void release();
    [[noreturn]] void fail(const char* what) const;

    SharedLibrary library_;
    decltype(&eglGetError) get_error_ = find<decltype(eglGetError)>("eglGetError");
    decltype(&eglMakeCurrent) make_current_ = find<decltype(eglMakeCurrent)>("eglMakeCurrent");
    decltype(&eglDestroyContext) destroy_context_ =
        find<decltype(eglDestroyContext)>("eglDestroyContext");
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    Gl gl_{};
};

EglHost::EglHost(const char* library) : library_(library) {
    try {
        open_display();
        create_context();
        make_current();
        gl_ = load_gl(find<decltype(eglGetProcAddress)>("eglGetProcAddress"));
    } catch (...) {
        release();  // the destructor does not run after a constructor that throws
        throw;
    }
}

void EglHost::open_display() {
    auto* const get_display = find<decltype(eglGetPlatformDisplay)>("eglGetPlatformDisplay");
    auto* const initialize = find<decltype(eglInitialize)>("eglInitialize");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY) fail("EGL knows no display without a surface");
    if (!initialize(display_, nullptr, nullptr)) fail("EGL cannot be initialised");
}

// The program draws into its own framebuffer. The configuration therefore needs no surface, and its
// colour and depth formats do not matter.
void EglHost::create_context() {
    auto* const bind_api = find<decltype(eglBindAPI)>("eglBindAPI");
    auto* const choose_config = find<decltype(eglChooseConfig)>("eglChooseConfig");
    auto* const create = find<decltype(eglCreateContext)>("eglCreateContext");
    constexpr std::array<EGLint, 5> kConfig{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array<EGLint, 7> kContext{EGL_CONTEXT_MAJOR_VERSION,
                                             3,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             3,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
    if (!bind_api(EGL_OPENGL_API)) fail("EGL cannot be used with OpenGL");
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!choose_config(display_, kConfig.data(), &config, 1, &count) || count == 0) {
        fail("EGL has no configuration for OpenGL");
    }
    context_ = create(display_, config, EGL_NO_CONTEXT, kContext.data());
    if (context_ == EGL_NO_CONTEXT) fail("EGL cannot draw with OpenGL 3.3");
}

void EglHost::make_current() {
    if (!make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
        fail("EGL cannot make its context current");
    }
}

// The display is shared by all hosts of the process and so stays initialised.
void EglHost::release() {
    if (context_ == EGL_NO_CONTEXT) return;
    make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    destroy_context_(display_, context_);
}

void EglHost::fail(const char* what) const {
    std::array<char, 32> error{};
    std::snprintf(error.data(), error.size(), " (EGL error 0x%x)",
                  static_cast<unsigned>(get_error_()));
    throw ContextError(what + std::string(error.data()));
}

}  // namespace

std::unique_ptr<OffscreenHost> make_egl_host(const char* library) {
    return std::make_unique<EglHost>(library);
}

}  // namespace pectin
