// GLFW behind Window.
#include "platform/window.h"

#include "platform/endings.h"

#include <glad/gl.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace isoscope {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

std::string display_remedy() {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    return "Neither DISPLAY nor WAYLAND_DISPLAY is set: start it in a desktop session, forward X11 (ssh -X), "
           "or use "
           "isoscope-run, which needs no display.";
  return "Check the display server, or use isoscope-run, which needs no display.";
}

} // namespace

Window::Window(GLFWwindow* window) : window_(window) {
  install_callbacks();
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<std::unique_ptr<Window>> Window::open(const std::string& title, PixelSize size) {
  if (glfwInit() != GLFW_TRUE)
    return Error{ErrorCode::device, "The display cannot be opened (" + last_error() + ").", display_remedy()};
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "isoscope");
  GLFWwindow* handle = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (handle == nullptr) {
    const std::string reason = last_error();
    glfwTerminate();
    return Error{ErrorCode::device, "No window with OpenGL 4.1 can be opened (" + reason + ").",
                 "Update the graphics driver, or install Mesa's software renderer (libgl1-mesa-dri) and set "
                 "LIBGL_ALWAYS_SOFTWARE=1."};
  }
  glfwMakeContextCurrent(handle);
  std::unique_ptr<Window> window(new Window(handle));
  if (gladLoadGL(glfwGetProcAddress) == 0)
    return Error{ErrorCode::device, "The functions of OpenGL 4.1 cannot be loaded.",
                 "Update the graphics driver."};
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(handle, 800, 500, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

void Window::install_callbacks() {
  glfwSetWindowUserPointer(window_, this);
  // The user interface's library chains to these: each only notes that a frame is due.
  static const auto note = [](GLFWwindow* w) {
    static_cast<Window*>(glfwGetWindowUserPointer(w))->activity_ = true;
  };
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { note(w); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { note(w); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) {
    note(w);
    static_cast<Window*>(glfwGetWindowUserPointer(w))->alt_alone_ = false;
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { note(w); });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
    note(w);
    auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(w));
    if (key == GLFW_KEY_LEFT_ALT) {
      if (action == GLFW_RELEASE && std::exchange(self.alt_alone_, false)) self.keys_.push_back({key});
      if (action == GLFW_PRESS) self.alt_alone_ = true;
      return;
    }
    self.alt_alone_ = false;
    if (action == GLFW_RELEASE || key == GLFW_KEY_UNKNOWN) return;
    self.keys_.push_back(
        {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { note(w); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) {
    note(w);
    static_cast<Window*>(glfwGetWindowUserPointer(w))->alt_alone_ = false;
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { note(w); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { note(w); });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { note(w); });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(w));
    self.dropped_.insert(self.dropped_.end(), paths, paths + count);
    self.activity_ = true;
  });
}

bool Window::should_close() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}
void Window::request_close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Window::poll() {
  glfwPollEvents();
}
void Window::wait(double seconds) {
  glfwWaitEventsTimeout(seconds);
}
void Window::wake() {
  if (!display_lost()) glfwPostEmptyEvent();
}
void Window::swap() {
  glfwSwapBuffers(window_);
}

PixelSize Window::size() const {
  PixelSize s;
  glfwGetWindowSize(window_, &s.width, &s.height);
  return s;
}

PixelSize Window::framebuffer_size() const {
  PixelSize s;
  glfwGetFramebufferSize(window_, &s.width, &s.height);
  return s;
}

float Window::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x : 1.0f;
}

bool Window::minimised() const {
  return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Window::take_activity() {
  return std::exchange(activity_, false);
}
std::vector<KeyPress> Window::take_keys() {
  return std::exchange(keys_, {});
}
std::vector<std::string> Window::take_dropped() {
  return std::exchange(dropped_, {});
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(window_);
  return text ? text : "";
}
void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}
void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

std::vector<std::uint8_t> Window::read_pixels() const {
  const PixelSize s = framebuffer_size();
  const std::size_t row = static_cast<std::size_t>(s.width) * 4, rows = static_cast<std::size_t>(s.height);
  std::vector<std::uint8_t> pixels(row * rows);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const auto at = [&](std::size_t y) { return pixels.begin() + static_cast<std::ptrdiff_t>(y * row); };
  for (std::size_t y = 0; y < rows / 2; ++y) std::swap_ranges(at(y), at(y + 1), at(rows - 1 - y));
  for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
  return pixels;
}

} // namespace isoscope
