// The one window with its OpenGL 4.1 core context: events, clipboard, dropped files, content scale.
#pragma once

#include "base/status.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace isoscope {

/// Width and height in pixels.
struct PixelSize {
  int width = 0, height = 0;
  friend bool operator==(PixelSize, PixelSize) = default;
};

/// A key going down or repeating; `key` is GLFW's code.
/// The left Alt key is told when it is let go, and only if nothing else was pressed meanwhile.
struct KeyPress {
  int key = 0;
  bool control = false, shift = false, alt = false;
};

/// Owns GLFW and the window. One instance a process; all methods on the main thread except wake().
class Window {
 public:
  /// Opens a window of `size` screen units with a current context. Fails with device where there is no
  /// display or no OpenGL 4.1.
  static Result<std::unique_ptr<Window>> open(const std::string& title, PixelSize size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool should_close() const;
  void request_close();
  /// Handles what has arrived, or waits for it up to `seconds`.
  void poll();
  void wait(double seconds);
  /// Ends a wait() from any thread.
  static void wake();
  void swap();

  PixelSize size() const;             ///< in screen units, as mouse positions are
  PixelSize framebuffer_size() const; ///< in pixels
  float content_scale() const;        ///< of the monitor: 1, 1.5, 2 ...
  bool minimised() const;

  /// Whether anything arrived that asks for a new frame, since the last call.
  bool take_activity();
  /// Keys pressed since the last call; none is lost between two slow frames.
  std::vector<KeyPress> take_keys();
  /// Paths dropped on the window since the last call.
  std::vector<std::string> take_dropped();
  std::string clipboard() const;
  void set_clipboard(const std::string& text);
  void set_title(const std::string& title);
  /// The back buffer as RGBA, rows top to bottom, alpha 255.
  std::vector<std::uint8_t> read_pixels() const;
  GLFWwindow* handle() const { return window_; }

 private:
  explicit Window(GLFWwindow* window);
  void install_callbacks();
  GLFWwindow* window_;
  bool activity_ = true;
  std::vector<std::string> dropped_;
  std::vector<KeyPress> keys_;
  bool alt_alone_ = false; ///< the left Alt key is held, and nothing else was pressed
};

} // namespace isoscope
