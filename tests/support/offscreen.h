// An offscreen context for tests that draw. They are skipped if no context is available.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/host/offscreen_host.h"
#include "command/json.h"
#include "render/renderer.h"
#include "session/session.h"

namespace pectin {

class OffscreenTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            host_ = make_offscreen_host();
        } catch (const ContextError& error) {
            GTEST_SKIP() << "nothing can be drawn: " << error.what();
        }
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
        const auto refusal = session.execute(std::get<Command>(parsed));
        ASSERT_FALSE(refusal) << line << ": " << *refusal;
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
