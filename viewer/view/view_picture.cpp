// When a picture is made, and at which quality.
#include "view/view_picture.h"

#include "scene/quality_control.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace isoscope {
namespace {

constexpr double settle_seconds = 0.15; ///< after the last change the picture is drawn at full quality
constexpr double patience = 0.04;       ///< seconds that the window waits for what only smoothens a picture
constexpr double most_strips = 32;

} // namespace

void ViewPicture::smoothen(FrameRequest request, int wanted, bool all, const Render& render) {
  const double begun = glfwGetTime();
  request.quality = Quality::rest;
  while (stills_ < wanted && (all || glfwGetTime() - begun < patience)) {
    if (strip_ == 0)
      strips_ = all ? 1 : static_cast<int>(std::clamp(still_seconds_ / patience + 1, 1.0, most_strips));
    request.still = stills_;
    request.strips = strips_;
    request.strip = strip_++;
    const double strip_begun = glfwGetTime();
    frame_ = render(request);
    spent_ += glfwGetTime() - strip_begun;
    if (strip_ < strips_) continue;
    // The first frame of all also waited for uploads and for the driver.
    still_seconds_ = std::min(still_seconds_, std::exchange(spent_, 0.0));
    strip_ = 0;
    ++stills_;
  }
}

void ViewPicture::draw(const Ui& ui, ViewArea area, Key key, const Render& render) {
  const WindowState& m = ui.window;
  const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
  key.width = static_cast<int>(area.size.x * density.x);
  key.pixel_height = static_cast<int>(area.size.y * density.y);
  key.scale = ui.scale;
  if (key.width <= 0 || key.pixel_height <= 0) return;

  FrameRequest request;
  request.width = key.width;
  request.height = key.pixel_height;
  request.pixel_scale = pixel_scale_ = ui.scale * density.x;
  request.selection = key.selection;
  request.mark = key.mark;
  request.hover = key.hover;
  const auto make = [&](Quality quality) {
    request.quality = quality;
    const double begun = glfwGetTime();
    frame_ = render(request);
    if (quality == Quality::rest) still_seconds_ = glfwGetTime() - begun;
    stills_ = quality == Quality::rest ? 1 : 0;
    strip_ = 0;
    spent_ = 0;
  };
  // A script looks only where it takes a picture.
  bool made = false;
  const bool looked_at = !m.scripted || !m.requests.screenshots.empty();
  if (key != key_) {
    const bool first = changed_at_ < 0;
    key_ = key;
    changed_at_ = m.clock;
    coarse_ = m.scripted ? !looked_at : !first;
    make(coarse_ ? Quality::moving : Quality::rest);
    made = true;
  } else if (coarse_ && looked_at && (m.scripted || m.clock - changed_at_ > settle_seconds)) {
    coarse_ = false;
    make(Quality::rest);
    made = true;
  }
  // While somebody moves the mouse or turns a wheel, frames must be quick.
  const ImGuiIO& io = ImGui::GetIO();
  const bool busy = !m.scripted && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 ||
                                    ImGui::IsAnyMouseDown());
  // Pictures that a script takes are the same on every machine.
  const int wanted = m.scripted ? m.stills : resting_frames(m.stills, still_seconds_);
  if (!made && !coarse_ && looked_at && !busy && (!m.scripted || m.is_current()))
    smoothen(request, wanted, m.scripted, render);
  unfinished_ = looked_at && (coarse_ || stills_ < wanted);
  if (frame_.texture == 0) return;
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(frame_.texture));
  ImGui::GetWindowDrawList()->AddImage(texture, area.low,
                                       {area.low.x + area.size.x, area.low.y + area.size.y}, {0, 1}, {1, 0});
}

} // namespace isoscope
