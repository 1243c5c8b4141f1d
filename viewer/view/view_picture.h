// The picture of a view: drawn again only when something that it depends on has changed, at full quality once
// it rests, smoother with every frame that it rests longer.
#pragma once

#include "scene/renderer.h"
#include "ui/ui.h"

#include <functional>
#include <optional>

namespace isoscope {

/// A rectangle of the interface.
struct ViewArea {
  ImVec2 low, size;
};

class ViewPicture {
 public:
  /// Everything a picture depends on; addresses tell immutable things apart.
  struct Key {
    CameraPose pose;
    ViewSettings view;
    double u = 0, v = 0, height = 0; ///< of a section
    const void *state = nullptr, *other = nullptr, *grid = nullptr, *detail = nullptr, *scene = nullptr;
    int width = 0, pixel_height = 0; ///< filled in by draw(), as is the scale
    const void *xray = nullptr, *study = nullptr, *annotation = nullptr, *preview = nullptr,
               *zero_map = nullptr;
    Pick selection, hover;
    std::optional<Vec3> mark;
    float scale = 1;
    friend bool operator==(const Key&, const Key&) = default;
  };
  using Render = std::function<Renderer::Frame(const FrameRequest&)>;

  /// Draws it into the present window.
  void draw(const Ui& ui, ViewArea area, Key key, const Render& render);
  /// Another frame is due although nothing asks for one.
  bool unfinished() const { return unfinished_; }
  /// How many frames of the picture at rest are averaged in it.
  int stills() const { return stills_; }
  /// It is not shown: nothing is due.
  void rest() { unfinished_ = false; }
  const Renderer::Frame& frame() const { return frame_; }
  int width() const { return key_.width; }
  int height() const { return key_.pixel_height; }
  float pixel_scale() const { return pixel_scale_; }

 private:
  /// Adds to the average for as long as the window may wait, or all that is left.
  void smoothen(FrameRequest request, int wanted, bool all, const Render& render);
  Key key_;
  Renderer::Frame frame_;
  double changed_at_ = -1;
  float pixel_scale_ = 1;
  bool coarse_ = false; ///< not at full quality
  bool unfinished_ = false;
  int stills_ = 0;           ///< frames that are averaged in the picture
  int strip_ = 0;            ///< of the next of them
  int strips_ = 1;           ///< that it is made of
  double spent_ = 0;         ///< on its strips until now, seconds
  double still_seconds_ = 0; ///< what a frame at rest takes
};

} // namespace isoscope
