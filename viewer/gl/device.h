// What the current OpenGL context is, and whether it serves us.
#pragma once

#include "base/status.h"

#include <string>

namespace isoscope::gl {

/// The driver behind the current context.
struct Device {
  std::string renderer, version;
  int max_samples = 0;   ///< of multisampled framebuffers, at most 4 are asked for
  bool software = false; ///< a software rasteriser: frames must be made cheaper while moving
};

/// Describes the current context. Fails with device when there is none, when its functions were not loaded,
/// or when it is older than OpenGL 4.1.
Result<Device> current_device();

} // namespace isoscope::gl
