// Draws the object and the overlays.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/camera.h"
#include "render/canvas.h"
#include "render/gpu_mesh.h"
#include "render/overlay.h"
#include "render/shader_program.h"

namespace pectin {

// The colours at the lower and the upper border of a picture, from 0 to 1 as on screen.
struct Background {
    Vec3f bottom{0.170f, 0.178f, 0.192f}, top{0.335f, 0.352f, 0.378f};
};

// Colours the surface by the weights that a drag of a point would have.
struct FalloffTint {
    Vec3 centre{0.0};             // the point, in world space
    std::optional<Vec3> image{};  // its mirror image
    double radius = 1.0;          // of the brush
    // As fractions of 255, at the points of a grid with as many per axis as the cube root, x
    // fastest, from the centre to a radius beyond along +x, +y and +z. The other octants are mirror
    // images. The array must last until the picture is drawn.
    std::span<const std::uint8_t> samples{};
};

// What a picture shows besides the mesh.
struct Scene {
    Camera camera{};
    Background background{};
    bool wireframe = false;
    bool levels = false;  // colours by refinement level
    std::optional<FalloffTint> tint{};
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
    void draw_background(const Background& background) const;
    void draw_object(const GpuMesh& mesh, const Scene& scene, const View& view) const;
    void set_tint(const ShaderProgram& program, const GpuMesh& mesh, const Scene& scene,
                  const View& view) const;
    void upload_overlay(const Overlay& overlay, const Vec3& centre, float pixel_scale);
    void draw_overlay(const Overlay& overlay, const View& view, const Canvas& canvas) const;
    void draw_overlay_part(const ShaderProgram& program, GLenum mode, GLint first, GLsizei count,
                           const View& view, const Canvas& canvas) const;

    const Gl* gl_;
    ShaderProgram background_, surface_, faces_, line_, point_;
    GlVertexArray no_attributes_, overlay_array_;
    GlBuffer overlay_buffer_;
    GlTexture falloff_texture_;
    std::vector<OverlayVertex> overlay_vertices_;  // temporary: ends of lines, then points
};

}  // namespace pectin
