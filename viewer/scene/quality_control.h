// Chooses how finely frames are drawn while something moves, from how long the last ones took.
#pragma once

#include "scene/renderer.h"

#include <cstddef>

namespace isoscope {

/// What one frame may cost.
struct FrameQuality {
  double scale = 1;        ///< of the picture's sides
  double volume_scale = 1; ///< of Ω's picture, relative to the picture
  float coarseness = 1;    ///< of the steps through Ω
  int samples = 4;         ///< of multisampling
  std::size_t sprites = 1000000;
};

/// How many frames a resting picture is averaged from, where one of them takes so long: four times as many as
/// asked for where that is quick, fewer where all of them would take too long.
int resting_frames(int asked, double seconds);

/// Levels from fine to coarse; a slow moving frame makes the next one coarser, a quick one finer.
class QualityControl {
 public:
  explicit QualityControl(bool software) : software_(software), level_(software ? 2 : 0) {}
  FrameQuality choose(Quality quality) const;
  /// Tells how long a frame of that quality took.
  void took(Quality quality, double seconds);

 private:
  bool software_;
  int level_;
};

} // namespace isoscope
