// Compiles and links the shader programs in shaders/.
#pragma once

#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>

#include "geometry/camera.h"
#include "render/gl.h"

namespace pectin {

// A file of shaders/. Its extension (.vert, .geom, .frag) determines the stage. It has no #version
// line; ShaderProgram adds that line and the defines.
struct ShaderSource {
    const char* name;
    const char* text;
};

// what() contains the name of the shader and the log of the driver.
class ShaderError : public std::runtime_error {
  public:
    ShaderError(std::string shader, std::string log)
        : std::runtime_error("the shader " + shader +
                             " does not work with this graphics driver: " + log),
          shader_(std::move(shader)),
          log_(std::move(log)) {}

    const std::string& shader() const { return shader_; }
    const std::string& log() const { return log_; }

  private:
    std::string shader_, log_;
};

class ShaderProgram {
  public:
    // defines: names for #define. Throws ShaderError.
    ShaderProgram(const Gl& gl, std::initializer_list<ShaderSource> sources,
                  std::initializer_list<const char*> defines = {});
    ~ShaderProgram();
    ShaderProgram(ShaderProgram&& other) noexcept;
    ShaderProgram& operator=(ShaderProgram&& other) noexcept;

    void use() const;
    // Sets a uniform. Ignores names that the shaders do not use. Precondition: the program is in
    // use.
    void set(const char* uniform, float value) const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, const Vec3f& value) const;
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;

  private:
    GLint location(const char* uniform) const;

    const Gl* gl_;
    GLuint name_ = 0;
};

}  // namespace pectin
