// Cameras of pictures that are not the window's: another aspect, a turned view.
#pragma once

#include "scene/camera.h"

namespace isoscope {

/// A pose that shows, at aspect `to` (width to height), at least what `pose` shows at aspect `from`: a
/// narrower picture sees more above and below.
CameraPose fitted(CameraPose pose, double from, double to);
/// The same view from another side: turned by `angle` (radians) about the up axis through the target.
CameraPose turned(CameraPose pose, double angle);

} // namespace isoscope
