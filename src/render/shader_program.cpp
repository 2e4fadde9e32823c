#include "render/shader_program.h"

#include <array>
#include <cassert>
#include <string_view>
#include <utility>

namespace pectin {
namespace {

GLenum stage(std::string_view name) {
    if (name.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (name.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    assert(name.ends_with(".frag"));
    return GL_FRAGMENT_SHADER;
}

std::string without_line_ends(std::string log) {
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
    for (char& c : log) {
        if (c == '\n') c = ' ';
    }
    return log.empty() ? "no reason given" : log;
}

std::string shader_log(const Gl& gl, GLuint shader) {
    GLint length = 0;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetShaderInfoLog(shader, length, nullptr, log.data());
    return without_line_ends(std::move(log));
}

std::string program_log(const Gl& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetProgramInfoLog(program, length, nullptr, log.data());
    return without_line_ends(std::move(log));
}

// Owns a compiled stage until its program is linked.
class Shader {
  public:
    Shader(const Gl& gl, const ShaderSource& source, const std::string& preamble)
        : gl_(gl), name_(gl.CreateShader(stage(source.name))) {
        const std::array<const char*, 2> texts{preamble.c_str(), source.text};
        gl.ShaderSource(name_, 2, texts.data(), nullptr);
        gl.CompileShader(name_);
        GLint compiled = GL_FALSE;
        gl.GetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string log = shader_log(gl, name_);
        gl.DeleteShader(name_);
        throw ShaderError(source.name, log);
    }
    ~Shader() { gl_.DeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint name() const { return name_; }

  private:
    const Gl& gl_;
    GLuint name_;
};

}  // namespace

ShaderProgram::ShaderProgram(const Gl& gl, std::initializer_list<ShaderSource> sources,
                             std::initializer_list<const char*> defines)
    : gl_(&gl) {
    std::string preamble = "#version 330 core\n", names;
    for (const char* define : defines) preamble += std::string("#define ") + define + "\n";
    preamble += "#line 1\n";
    name_ = gl.CreateProgram();
    try {
        for (const ShaderSource& source : sources) {
            const Shader shader(gl, source, preamble);
            gl.AttachShader(name_, shader.name());
            names += (names.empty() ? "" : " + ") + std::string(source.name);
        }
        gl.LinkProgram(name_);
        GLint linked = GL_FALSE;
        gl.GetProgramiv(name_, GL_LINK_STATUS, &linked);
        if (linked != GL_TRUE) throw ShaderError(names, program_log(gl, name_));
    } catch (const ShaderError&) {
        gl.DeleteProgram(name_);  // a constructor that throws runs no destructor
        throw;
    }
}

ShaderProgram::~ShaderProgram() {
    if (name_ != 0) gl_->DeleteProgram(name_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
}

void ShaderProgram::use() const { gl_->UseProgram(name_); }

GLint ShaderProgram::location(const char* uniform) const {
    return gl_->GetUniformLocation(name_, uniform);
}

void ShaderProgram::set(const char* uniform, float value) const {
    gl_->Uniform1f(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, int value) const {
    gl_->Uniform1i(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, const glm::vec2& value) const {
    gl_->Uniform2fv(location(uniform), 1, &value[0]);
}
void ShaderProgram::set(const char* uniform, const Vec3f& value) const {
    gl_->Uniform3fv(location(uniform), 1, &value[0]);
}
void ShaderProgram::set(const char* uniform, const glm::mat3& value) const {
    gl_->UniformMatrix3fv(location(uniform), 1, GL_FALSE, &value[0][0]);
}
void ShaderProgram::set(const char* uniform, const glm::mat4& value) const {
    gl_->UniformMatrix4fv(location(uniform), 1, GL_FALSE, &value[0][0]);
}

}  // namespace pectin
