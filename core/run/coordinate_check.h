// Says before a run which digits the input's coordinates have lost: far from the origin, or at a size far
// from 1.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

#include <optional>
#include <string>

namespace isoscope {

/// How fine coordinates are where the model lies: a double has 53 bits wherever it is.
struct CoordinateDigits {
  double step = 0;           ///< between neighbouring numbers at the largest coordinate
  int left = 0;              ///< decimal digits that are left at the size of the model, of about 16
  double distance_ratio = 0; ///< the largest coordinate over the longest edge of the box
};
CoordinateDigits coordinate_digits(const TriangleSoup& soup);

/// Fails with bad_input where neighbouring coordinates are more than 1e-5 δ apart: nothing can be proven at δ
/// then. `delta` absolute.
Status check_coordinates(const TriangleSoup& soup, double delta);

/// What the user should know of coordinates that pass, if there is anything: that few digits are left for δ,
/// or that the size is so far from 1 that products of many lengths leave the range of a double.
std::optional<std::string> coordinate_note(const TriangleSoup& soup, double delta);

} // namespace isoscope
