#include "render/imgui_renderer.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>

#include "render/shader_sources.h"

namespace pectin {
namespace {

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class T>
void stream(const Gl& gl, GLenum target, const ImVector<T>& elements) {
    gl.BufferData(target, static_cast<GLsizeiptr>(elements.size_in_bytes()), elements.Data,
                  GL_STREAM_DRAW);
}

}  // namespace

ImGuiRenderer::ImGuiRenderer(const Gl& gl, ImFontAtlas& fonts)
    : gl_(&gl),
      program_(gl, {shaders::ui_vert, shaders::ui_frag}),
      font_(gl),
      vertex_array_(gl),
      vertices_(gl),
      indices_(gl) {
    constexpr GLsizei kStride = sizeof(ImDrawVert);
    gl.BindVertexArray(vertex_array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    for (GLuint attribute = 0; attribute < 3; ++attribute) gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, pos)));
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, uv)));
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                           offset(offsetof(ImDrawVert, col)));
    gl.BindVertexArray(0);
    upload_font(fonts);
}

void ImGuiRenderer::upload_font(ImFontAtlas& fonts) {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
    gl_->BindTexture(GL_TEXTURE_2D, font_.name());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    pixels);
    check_errors(*gl_, "the letters of the panels");
    fonts.ClearTexData();
}

void ImGuiRenderer::draw(const ImDrawData& data, const Canvas& canvas) {
    canvas.bind();
    begin(data);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        stream(*gl_, GL_ARRAY_BUFFER, list.VtxBuffer);
        stream(*gl_, GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            draw_command(command, data, canvas.size().y);
        }
    }
    gl_->BindVertexArray(0);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    gl_->UseProgram(0);
}

void ImGuiRenderer::begin(const ImDrawData& data) const {
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_DEPTH_TEST);
    gl_->Enable(GL_SCISSOR_TEST);
    gl_->Enable(GL_BLEND);
    gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const float left = data.DisplayPos.x, top = data.DisplayPos.y;
    program_.use();
    program_.set("to_clip",
                 glm::ortho(left, left + data.DisplaySize.x, top + data.DisplaySize.y, top));
    program_.set("font", 0);
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, font_.name());
    gl_->BindVertexArray(vertex_array_.name());
    gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
}

void ImGuiRenderer::draw_command(const ImDrawCmd& command, const ImDrawData& data,
                                 int height) const {
    if (command.UserCallback) return;  // the program sets none
    const auto pixel = [](float at, float origin, float scale) {
        return static_cast<GLint>((at - origin) * scale);
    };
    const ImVec4& clip = command.ClipRect;
    const GLint left = pixel(clip.x, data.DisplayPos.x, data.FramebufferScale.x);
    const GLint top = pixel(clip.y, data.DisplayPos.y, data.FramebufferScale.y);
    const GLint right = pixel(clip.z, data.DisplayPos.x, data.FramebufferScale.x);
    const GLint bottom = pixel(clip.w, data.DisplayPos.y, data.FramebufferScale.y);
    if (right <= left || bottom <= top) return;
    gl_->Scissor(left, height - bottom, right - left, bottom - top);
    gl_->DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                                offset(command.IdxOffset * sizeof(ImDrawIdx)),
                                static_cast<GLint>(command.VtxOffset));
}

}  // namespace pectin
