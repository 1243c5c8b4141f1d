// A linked OpenGL program and its uniforms.
#include "gl/program.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <utility>

namespace isoscope::gl {
namespace {

/// Compiles one stage; on failure `log` says why and the result is 0.
GLuint compile(GLenum stage, std::string_view source, std::string& log) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.data();
  const GLint length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  GLint size = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
  log.resize(static_cast<std::size_t>(size > 0 ? size : 1));
  glGetShaderInfoLog(shader, size, nullptr, log.data());
  glDeleteShader(shader);
  return 0;
}

Error failure(std::string_view name, const std::string& what, const std::string& log) {
  return {ErrorCode::device, "The shader program " + std::string(name) + " could not be " + what + ": " + log,
          "Please report this with the name of your graphics driver."};
}

} // namespace

Result<Program> Program::build(std::string_view name, std::string_view vertex, std::string_view fragment) {
  std::string log;
  const GLuint vertex_shader = compile(GL_VERTEX_SHADER, vertex, log);
  if (vertex_shader == 0) return failure(name, "compiled (vertex stage)", log);
  const GLuint fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, log);
  if (fragment_shader == 0) {
    glDeleteShader(vertex_shader);
    return failure(name, "compiled (fragment stage)", log);
  }
  Program program;
  program.id_ = glCreateProgram();
  glAttachShader(program.id_, vertex_shader);
  glAttachShader(program.id_, fragment_shader);
  glLinkProgram(program.id_);
  glDeleteShader(vertex_shader);
  glDeleteShader(fragment_shader);
  GLint ok = GL_FALSE;
  glGetProgramiv(program.id_, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return program;
  GLint size = 0;
  glGetProgramiv(program.id_, GL_INFO_LOG_LENGTH, &size);
  log.resize(static_cast<std::size_t>(size > 0 ? size : 1));
  glGetProgramInfoLog(program.id_, size, nullptr, log.data());
  return failure(name, "linked", log);
}

Program::Program(Program&& other) noexcept
    : id_(std::exchange(other.id_, 0)), locations_(std::move(other.locations_)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(locations_, other.locations_);
  return *this;
}

Program::~Program() {
  if (id_ != 0) glDeleteProgram(id_);
}

void Program::use() const {
  glUseProgram(id_);
}

int Program::location(const char* uniform) {
  const auto known = locations_.find(std::string_view(uniform));
  if (known != locations_.end()) return known->second;
  const int found = glGetUniformLocation(id_, uniform);
  locations_.emplace(uniform, found);
  return found;
}

void Program::set(const char* uniform, int value) {
  glUniform1i(location(uniform), value);
}
void Program::set(const char* uniform, float value) {
  glUniform1f(location(uniform), value);
}
void Program::set(const char* uniform, glm::vec2 value) {
  glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec3 value) {
  glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec4 value) {
  glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace isoscope::gl
