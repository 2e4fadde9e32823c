#include "render/renderer.h"

#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>

#include "render/shader_sources.h"

namespace pectin {
namespace {

constexpr float kEdgeWidth = 1.1f;        // pixels
constexpr float kHiddenStrength = 0.28f;  // opacity of overlays behind the object
// Overlays are drawn nearer than they are. So the near plane is nearer by this factor, or in an
// orthographic picture by this many pixels.
constexpr double kNearMargin = 0.5, kNearPixels = 32.0;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

Renderer::Renderer(const Gl& gl)
    : gl_(&gl),
      background_(gl, {shaders::background_vert, shaders::background_frag}),
      surface_(gl, {shaders::mesh_vert, shaders::mesh_frag}),
      faces_(gl, {shaders::mesh_vert, shaders::faces_geom, shaders::mesh_frag}, {"FACES"}),
      line_(gl, {shaders::line_vert, shaders::line_geom, shaders::line_frag}),
      point_(gl, {shaders::point_vert, shaders::point_frag}),
      no_attributes_(gl),
      overlay_array_(gl),
      overlay_buffer_(gl),
      falloff_texture_(gl) {
    constexpr GLsizei kStride = sizeof(OverlayVertex);
    gl.BindVertexArray(overlay_array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, overlay_buffer_.name());
    for (GLuint attribute = 0; attribute < 4; ++attribute) gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                           offset(offsetof(OverlayVertex, position)));
    gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                           offset(offsetof(OverlayVertex, colour)));
    gl.VertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride,
                           offset(offsetof(OverlayVertex, size)));
    gl.VertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, kStride,
                           offset(offsetof(OverlayVertex, shape)));
    gl.BindVertexArray(0);
}

void Renderer::draw(const GpuMesh& mesh, const Scene& scene, const Canvas& canvas) {
    const View the_view = view(mesh, scene, canvas);
    canvas.bind();
    gl_->Enable(GL_MULTISAMPLE);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_BLEND);
    draw_background(scene.background);
    draw_object(mesh, scene, the_view);
    if (!scene.overlay.is_empty()) {
        upload_overlay(scene.overlay, mesh.centre(), scene.pixel_scale);
        draw_overlay(scene.overlay, the_view, canvas);
    }
    gl_->Disable(GL_DEPTH_TEST);
    gl_->UseProgram(0);
}

Renderer::View Renderer::view(const GpuMesh& mesh, const Scene& scene, const Canvas& canvas) {
    Box shown = mesh.bounds();
    shown.include(scene.overlay.bounds());
    DepthRange depths = depth_range(scene.camera, shown);
    const Camera& camera = scene.camera;
    const double pixel = camera.pixel_length(camera.target, canvas.size()) /
                         (camera.is_orthographic() ? 1.0 : camera.distance());
    if (camera.is_orthographic()) {
        depths.near -= kNearPixels * scene.pixel_scale * pixel;
    } else {
        depths.near *= kNearMargin;
    }
    const double aspect = static_cast<double>(canvas.size().x) / canvas.size().y;
    return {.to_camera = glm::translate(camera.view(), mesh.centre()),
            .projection = camera.projection_matrix(aspect, depths),
            .depths = depths,
            .is_orthographic = camera.is_orthographic(),
            .pixel = static_cast<float>(pixel)};
}

void Renderer::draw_background(const Background& background) const {
    gl_->Disable(GL_DEPTH_TEST);
    gl_->DepthMask(GL_TRUE);
    gl_->Clear(GL_DEPTH_BUFFER_BIT);
    background_.use();
    background_.set("bottom", background.bottom);
    background_.set("top", background.top);
    gl_->BindVertexArray(no_attributes_.name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_object(const GpuMesh& mesh, const Scene& scene, const View& view) const {
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LEQUAL);
    const ShaderProgram& program = scene.wireframe || scene.levels ? faces_ : surface_;
    program.use();
    program.set("to_camera", glm::mat4(view.to_camera));
    program.set("to_clip", glm::mat4(view.projection * view.to_camera));
    program.set("orthographic", view.is_orthographic ? 1 : 0);
    program.set("show_levels", scene.levels ? 1 : 0);
    program.set("line_width", scene.wireframe ? kEdgeWidth * scene.pixel_scale : 0.0f);
    set_tint(program, mesh, scene, view);
    mesh.draw();
}

void Renderer::set_tint(const ShaderProgram& program, const GpuMesh& mesh, const Scene& scene,
                        const View& view) const {
    program.set("tint_radius", scene.tint ? static_cast<float>(scene.tint->radius) : 0.0f);
    if (!scene.tint) return;
    const FalloffTint& tint = *scene.tint;
    const auto size = static_cast<GLsizei>(std::lround(std::cbrt(tint.samples.size())));
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_3D, falloff_texture_.name());
    for (const GLenum filter : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}}) {
        gl_->TexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    }
    for (const GLenum wrap :
         {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}, GLenum{GL_TEXTURE_WRAP_R}}) {
        gl_->TexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    }
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_->TexImage3D(GL_TEXTURE_3D, 0, GL_R8, size, size, size, 0, GL_RED, GL_UNSIGNED_BYTE,
                    tint.samples.data());
    const auto in_camera = [&](const Vec3& point) {
        return Vec3f{Vec3{view.to_camera * glm::dvec4(point - mesh.centre(), 1.0)}};
    };
    program.set("falloff", 0);
    program.set("falloff_size", static_cast<float>(size));
    program.set("tint_axes", glm::mat3(glm::transpose(glm::dmat3(view.to_camera))));
    program.set("tint_centre", in_camera(tint.centre));
    program.set("tint_image", in_camera(tint.image.value_or(tint.centre)));
    program.set("has_tint_image", tint.image ? 1 : 0);
}

void Renderer::upload_overlay(const Overlay& overlay, const Vec3& centre, float pixel_scale) {
    overlay_vertices_.clear();
    for (const Overlay::Line& line : overlay.lines) {
        const float width = line.width * pixel_scale;
        overlay_vertices_.push_back({Vec3f(line.from - centre), line.colour, width, 0.0f});
        overlay_vertices_.push_back({Vec3f(line.to - centre), line.colour, width, 0.0f});
    }
    for (const Overlay::Point& point : overlay.points) {
        overlay_vertices_.push_back({Vec3f(point.position - centre), point.colour,
                                     point.diameter * pixel_scale,
                                     static_cast<float>(point.shape)});
    }
    gl_->BindBuffer(GL_ARRAY_BUFFER, overlay_buffer_.name());
    gl_->BufferData(GL_ARRAY_BUFFER,
                    static_cast<GLsizeiptr>(overlay_vertices_.size() * sizeof(OverlayVertex)),
                    overlay_vertices_.data(), GL_STREAM_DRAW);
}

void Renderer::draw_overlay(const Overlay& overlay, const View& view, const Canvas& canvas) const {
    const auto line_ends = static_cast<GLsizei>(2 * overlay.lines.size());
    const auto points = static_cast<GLsizei>(overlay.points.size());
    gl_->Enable(GL_PROGRAM_POINT_SIZE);
    gl_->Enable(GL_BLEND);
    gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_->DepthMask(GL_FALSE);
    gl_->BindVertexArray(overlay_array_.name());
    draw_overlay_part(line_, GL_LINES, 0, line_ends, view, canvas);
    draw_overlay_part(point_, GL_POINTS, line_ends, points, view, canvas);
    gl_->BindVertexArray(0);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_BLEND);
}

// Draws the parts behind the object faintly, then the visible parts.
void Renderer::draw_overlay_part(const ShaderProgram& program, GLenum mode, GLint first,
                                 GLsizei count, const View& view, const Canvas& canvas) const {
    program.use();
    program.set("to_camera", glm::mat4(view.to_camera));
    program.set("projection", glm::mat4(view.projection));
    program.set("picture_size", glm::vec2(canvas.size()));
    program.set("orthographic", view.is_orthographic ? 1 : 0);
    program.set("pixel", view.pixel);
    program.set("near", static_cast<float>(view.depths.near));
    program.set("strength", kHiddenStrength);
    gl_->DepthFunc(GL_GREATER);
    gl_->DrawArrays(mode, first, count);
    program.set("strength", 1.0f);
    gl_->DepthFunc(GL_LEQUAL);
    gl_->DrawArrays(mode, first, count);
}

}  // namespace pectin
