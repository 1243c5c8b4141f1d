// All shader programs of the scene.
#pragma once

#include "base/status.h"
#include "gl/program.h"
#include "gl/shader_source.h"

namespace isoscope {

struct Programs {
  gl::Program background, mesh_opaque, mesh_translucent, mesh_flat, line, marker, sample, point, volume,
      volume_sided, composite, section, copy;

  /// Compiles them all; fails with device and the driver's log.
  static Result<Programs> build(const gl::ShaderSource& source);
};

} // namespace isoscope
