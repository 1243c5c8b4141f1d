// A picture of any size, drawn in tiles, one at a time.
#pragma once

#include "platform/image_file.h"
#include "scene/renderer.h"

#include <memory>

namespace isoscope {

/// What a picture shows.
struct Shot {
  Camera camera;
  ViewSettings view; ///< in ViewMode::section the section is drawn
  Renderer::SectionView section;
  int width = 0, height = 0;
  float pixel_scale = 1;
  bool alpha = false;
  int stills = 1; ///< frames that are averaged in each tile
  Pick selection;
  std::optional<Vec3> mark;
};

class TiledPicture {
 public:
  explicit TiledPicture(Shot shot);
  /// Draws some frames of the next tile of what the renderer holds; true when the picture is complete. Fails
  /// with device.
  Result<bool> advance(Renderer& renderer);
  double part() const { return (next_ + static_cast<double>(still_) / shot_.stills) / (columns_ * rows_); }
  Image take() { return std::move(image_); }

 private:
  Shot shot_;
  Image image_;
  int columns_ = 1, rows_ = 1, next_ = 0;
  int still_ = 0; ///< the next frame of the tile
};

} // namespace isoscope
