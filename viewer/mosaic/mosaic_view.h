// The mosaic in the middle of the window: drag turns it, a click makes the tile below it once more.
#pragma once

#include "mosaic/mosaic.h"
#include "scene/mosaic_picture.h"
#include "view/camera_mouse.h"

#include <memory>

namespace isoscope {

class MosaicView {
 public:
  explicit MosaicView(Mosaic& mosaic) : mosaic_(mosaic) {}
  /// Fills the present window of the interface.
  void draw(Ui& ui);
  /// Another frame is due although nothing asks for one.
  bool unfinished() const { return mosaic_.shown() && picture_.unfinished(); }
  /// It is not shown: nothing is due.
  void rest() { picture_.rest(); }

 private:
  void frame(float aspect);
  void mouse(Ui& ui, ViewArea area);
  void words(Ui& ui, ViewArea area);

  Mosaic& mosaic_;
  std::unique_ptr<MosaicPicture> renderer_; ///< once it is shown
  bool failed_ = false;                     ///< it could not be made
  ViewPicture picture_;
  CameraMouse mouse_;
  Box3 framed_;
  float framed_aspect_ = 0;
};

} // namespace isoscope
