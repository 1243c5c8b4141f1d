// Small pictures of the bundled models, shaded on a worker by a rasteriser of our own: no context, the same
// bits everywhere.
#pragma once

#include "input/triangle_soup.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace isoscope {

/// A picture as RGBA rows from top to bottom; transparent where there is no model.
struct Thumbnail {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Draws the soup from above right, two-sided, with an even light. `opened`: the quarter towards the viewer
/// is left out, so that what is inside is seen.
Thumbnail draw_thumbnail(const TriangleSoup& soup, int width, int height, bool opened = false);

/// All gallery models, one after the other on a worker.
class Thumbnails {
 public:
  ~Thumbnails();
  /// Begins the work once; `notify` is called after each picture.
  void begin(int width, int height, std::function<void()> notify);
  /// The picture of gallery()[i], null while it is not ready.
  std::shared_ptr<const Thumbnail> picture(std::size_t i) const;
  bool finished() const;

  /// The texture of a picture, kept for the user by the program: 0 when there is none yet.
  std::vector<std::uint32_t> textures;

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<const Thumbnail>> pictures_;
  bool quit_ = false, finished_ = false;
  std::thread worker_;
};

} // namespace isoscope
