// A hidden window with an OpenGL 4.1 core context for as long as it lives; needs a display.
#pragma once

#include <GLFW/glfw3.h>
#include <glad/gl.h>

namespace isoscope::testing {

class GlContext {
 public:
  GlContext() {
    if (!glfwInit()) return;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(64, 64, "test", nullptr, nullptr);
    if (!window_) return;
    glfwMakeContextCurrent(window_);
    ready_ = gladLoadGL(glfwGetProcAddress) != 0;
  }
  ~GlContext() { glfwTerminate(); }
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  bool ready() const { return ready_; }

 private:
  GLFWwindow* window_ = nullptr;
  bool ready_ = false;
};

} // namespace isoscope::testing
