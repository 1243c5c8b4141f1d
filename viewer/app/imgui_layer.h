// Dear ImGui with its GLFW and OpenGL backends, style and fonts at the present scale.
#pragma once

#include "model/window_state.h"
#include "platform/window.h"
#include "ui/theme.h"

#include <deque>
#include <memory>

namespace isoscope {

/// Owns the library's context; needs the window's OpenGL context during its whole life.
class ImguiLayer {
 public:
  static Result<std::unique_ptr<ImguiLayer>> create(Window& window);
  ~ImguiLayer();
  ImguiLayer(const ImguiLayer&) = delete;
  ImguiLayer& operator=(const ImguiLayer&) = delete;

  /// Loads fonts and style anew when scale or theme changed. Between frames only.
  Status prepare(float scale, ThemeKind theme);
  /// `mouse`: a scripted mouse that replaces the real one for this frame; `step` seconds of time, negative:
  /// the clock's. `keys_in_pane`: arrows and Enter go through a pane.
  void begin_frame(const MouseStep* mouse, double step, bool keys_in_pane);
  void end_frame();
  /// Hands a press of arrows, Enter and their like to the pane that has the keys, in a frame of its own: Dear
  /// ImGui asks what is held down, and misses what is pressed and let go between two frames.
  void press(int key);
  bool has_presses() const { return !presses_.empty() || pressed_; }
  const Fonts& fonts() const { return fonts_; }
  float scale() const { return scale_; }

 private:
  ImguiLayer() = default;
  void hold_keys();
  Fonts fonts_;
  std::deque<int> presses_;
  bool pressed_ = false; ///< in this frame: it is let go in the next
  float scale_ = 0;
  ThemeKind theme_ = ThemeKind::dark;
};

/// A texture of the interface made of RGBA rows; returns its name.
std::uint32_t make_texture(int width, int height, const std::uint8_t* rgba);

} // namespace isoscope
