// An offscreen context for tests that draw. They are skipped if no context is available.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "app/host/offscreen_host.h"
#include "command/json.h"
#include "render/renderer.h"
#include "session/session.h"

namespace pectin {

// Whether the library is loaded and its function says that one of its contexts is current.
inline bool has_current_context(const char* library, const char* function) {
    void* const loaded = ::dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (!loaded) return false;
    auto* const current = reinterpret_cast<void* (*)()>(::dlsym(loaded, function));
    const bool has_context = current && current();
    ::dlclose(loaded);
    return has_context;
}

// Asks the libraries which of them has the current context, and returns the name of its host as in
// PECTIN_OFFSCREEN. Returns an empty name if neither has one.
inline std::string current_offscreen_host() {
    if (has_current_context("libOSMesa.so.8", "OSMesaGetCurrentContext")) return "osmesa";
    if (has_current_context("libEGL.so.1", "eglGetCurrentContext")) return "egl";
    return {};
}

class OffscreenTest : public testing::Test {
  protected:
    // Fails if the host is not the one that PECTIN_OFFSCREEN chooses.
    void SetUp() override {
        try {
            host_ = make_offscreen_host();
        } catch (const ContextError& error) {
            GTEST_SKIP() << "nothing can be drawn: " << error.what();
        }
        const char* const choice = std::getenv("PECTIN_OFFSCREEN");
        const std::string host = current_offscreen_host();
        ASSERT_NE(host, "");
        if (choice) {
            ASSERT_EQ(host, choice);
        }
        RecordProperty("host", host);
    }
    const Gl& gl() const { return host_->gl(); }

  private:
    std::unique_ptr<OffscreenHost> host_;
};

// Executes the lines of a script. A refused command fails the test.
inline void execute(Session& session, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        const auto parsed = parse_command(line);
        if (const auto* error = std::get_if<CommandError>(&parsed)) {
            FAIL() << line << ": " << error->what;
        }
        const Done done = session.execute(std::get<Command>(parsed));
        ASSERT_TRUE(done) << line << ": " << done.refusal().reason;
    }
}

inline Image draw(const Gl& gl, const GpuMesh& mesh, const Scene& scene, const IVec2& size) {
    Renderer renderer(gl);
    const Canvas canvas(gl, size);
    renderer.draw(mesh, scene, canvas);
    canvas.resolve();
    return canvas.read();
}

inline Image draw(const Gl& gl, const TriMesh& mesh, const Scene& scene, const IVec2& size) {
    GpuMesh gpu_mesh(gl);
    gpu_mesh.upload(mesh);
    return draw(gl, gpu_mesh, scene, size);
}

}  // namespace pectin
