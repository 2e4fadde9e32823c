// Draws what Dear ImGui has made of the panels, the same on every host.
//
// Its own OpenGL backend asks libGL for functions and so fails in contexts that are not libGL's.
#pragma once

#include "render/canvas.h"
#include "render/shader_program.h"

struct ImDrawCmd;
struct ImDrawData;
struct ImFontAtlas;

namespace pectin {

class ImGuiRenderer {
  public:
    // Takes over the fonts' texture; compiles the shaders. Throws ShaderError.
    ImGuiRenderer(const Gl& gl, ImFontAtlas& fonts);

    // Over what the canvas has. Blending, scissors and the program are left off.
    // Precondition: the canvas is as large as the data's display in its framebuffer's pixels.
    void draw(const ImDrawData& data, const Canvas& canvas);

  private:
    void upload_font(ImFontAtlas& fonts);
    void begin(const ImDrawData& data) const;
    void draw_command(const ImDrawCmd& command, const ImDrawData& data, int height) const;

    const Gl* gl_;
    ShaderProgram program_;
    GlTexture font_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
};

}  // namespace pectin
