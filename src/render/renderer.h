// Draws the object and the overlays.
#pragma once

#include "geometry/camera.h"
#include "render/canvas.h"
#include "render/gpu_mesh.h"
#include "render/overlay.h"
#include "render/shader_program.h"

namespace pectin {

// What a picture shows besides the mesh.
struct Scene {
    Camera camera{};
    bool wireframe = false;
    bool levels = false;       // colours by refinement level
    Overlay overlay{};         // world space
    float pixel_scale = 1.0f;  // factor of widths in pixels; above 1 on high-resolution screens
};

class Renderer {
  public:
    // Compiles the shaders. Throws ShaderError.
    explicit Renderer(const Gl& gl);

    // Draws the background, the object and the overlay. The canvas stays bound and unresolved, so
    // that a host can draw its panels on it. Leaves depth test and blending off. Precondition: the
    // camera is valid.
    void draw(const GpuMesh& mesh, const Scene& scene, const Canvas& canvas);

  private:
    // The scene's matrices for positions relative to the mesh's centre.
    struct View {
        Mat4 to_camera, projection;
        DepthRange depths;
        bool is_orthographic;
        float pixel;  // height of a pixel: at distance 1, or everywhere if it is orthographic
    };
    // The layout that line.vert and point.vert read.
    struct OverlayVertex {
        Vec3f position;
        Colour colour;
        float size;
        float shape;
    };
    static_assert(sizeof(OverlayVertex) == 24);

    static View view(const GpuMesh& mesh, const Scene& scene, const Canvas& canvas);
    void draw_background() const;
    void draw_object(const GpuMesh& mesh, const Scene& scene, const View& view) const;
    void upload_overlay(const Overlay& overlay, const Vec3& centre, float pixel_scale);
    void draw_overlay(const Overlay& overlay, const View& view, const Canvas& canvas) const;
    void draw_overlay_part(const ShaderProgram& program, GLenum mode, GLint first, GLsizei count,
                           const View& view, const Canvas& canvas) const;

    const Gl* gl_;
    ShaderProgram background_, surface_, faces_, line_, point_;
    GlVertexArray no_attributes_, overlay_array_;
    GlBuffer overlay_buffer_;
    std::vector<OverlayVertex> overlay_vertices_;  // temporary: ends of lines, then points
};

}  // namespace pectin
