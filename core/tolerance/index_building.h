// Building the index of a large input, with a way to stop it.
#pragma once

#include "base/run_control.h"
#include "input/triangle_soup.h"
#include "tolerance/closest_point.h"

#include <memory>

namespace isoscope {

/// The index of a soup; an empty one once the control is cancelled.
std::shared_ptr<const ClosestPointIndex> build_index(const TriangleSoup& soup, const RunControl& control);

} // namespace isoscope
