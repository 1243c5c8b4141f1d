// A linked OpenGL program and its uniforms.
#pragma once

#include "base/status.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace isoscope::gl {

/// Owns one program object; movable. Setting a uniform that the linker dropped does nothing.
class Program {
 public:
  Program() = default;
  /// Compiles and links; fails with device and the driver's log, naming the program.
  static Result<Program> build(std::string_view name, std::string_view vertex, std::string_view fragment);
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  void use() const;
  void set(const char* uniform, int value);
  void set(const char* uniform, float value);
  void set(const char* uniform, glm::vec2 value);
  void set(const char* uniform, glm::vec3 value);
  void set(const char* uniform, glm::vec4 value);
  void set(const char* uniform, const glm::mat4& value);

 private:
  int location(const char* uniform);
  std::uint32_t id_ = 0;
  std::map<std::string, int, std::less<>> locations_;
};

} // namespace isoscope::gl
