// Draws the panels of Dear ImGui on every host.
//
// Dear ImGui's own OpenGL backend loads functions from libGL and so fails in contexts that do not
// come from libGL.
#pragma once

#include "render/canvas.h"
#include "render/shader_program.h"

struct ImDrawCmd;
struct ImDrawData;
struct ImFontAtlas;

namespace pectin {

class ImGuiRenderer {
  public:
    // Uploads the font texture and compiles the shaders. Throws ShaderError.
    ImGuiRenderer(const Gl& gl, ImFontAtlas& fonts);

    // Uploads the font texture again, after the fonts have changed.
    void upload_font(ImFontAtlas& fonts);

    // Draws over the contents of the canvas. Leaves blending, scissor test and program off.
    // Precondition: the canvas has the display size of the data in framebuffer pixels.
    void draw(const ImDrawData& data, const Canvas& canvas);

  private:
    void begin(const ImDrawData& data) const;
    void draw_command(const ImDrawCmd& command, const ImDrawData& data, int height) const;

    const Gl* gl_;
    ShaderProgram program_;
    GlTexture font_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
};

}  // namespace pectin
