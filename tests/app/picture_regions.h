// How much two pictures of a window differ, region by region: a panel that vanished shows, however small it
// is.
#pragma once

#include "platform/image_file.h"

namespace isoscope::test {

struct PictureDifference {
  double mean = 1;  ///< over the whole picture, in [0, 1]
  double worst = 1; ///< of the region that differs most
  int x = 0, y = 0; ///< its corner, pixels
};

/// Channels are compared after averaging cells of 8 by 8 pixels, which is blind to how a font is rasterised
/// and awake to what is where; regions are 6 by 3 cells, as large as a word on a button. Pictures of
/// different sizes differ in everything.
PictureDifference compare_regions(const Image& a, const Image& b);

} // namespace isoscope::test
