// The loose bounding box that T begins as: it is shown as long as nothing else of the mesh is there.
#pragma once

#include "questions/snapshot.h"

namespace isoscope {

/// Empty once there is a Z.
Box3 first_box(const StateSnapshot& state);

} // namespace isoscope
