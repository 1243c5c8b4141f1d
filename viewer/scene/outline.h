// The points of an input that reach farthest: what has to be in sight when all of it is looked at.
#pragma once

#include "input/triangle_soup.h"

#include <vector>

namespace isoscope {

/// In each of some hundred directions the farthest point, and `margin` beyond it. Of large inputs an even
/// part is looked at, and the faces of the box besides. Empty where the input is.
std::vector<Vec3> outline(const TriangleSoup& input, double margin);

} // namespace isoscope
