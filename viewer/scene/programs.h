// All shader programs of the scene.
#pragma once

#include "base/status.h"
#include "gl/program.h"
#include "gl/shader_source.h"

#include <array>
#include <span>

namespace isoscope {

/// A program and the names of its shaders.
struct ProgramEntry {
  gl::Program& program;
  const char *name, *vertex, *fragment;
};
/// Compiles them all; fails with device and the driver's log.
Status build_programs(const gl::ShaderSource& source, std::span<const ProgramEntry> entries);

struct Programs {
  gl::Program background, mesh_opaque, mesh_translucent, mesh_flat, line, marker, sample, point, composite,
      section, copy;
  /// Ω: resting without and with a haze, with a part in finer voxels, and moving; of each the one whose
  /// values are signed, and the other.
  std::array<gl::Program, 2> volume, volume_haze, volume_moving, volume_detail, volume_haze_detail;
  gl::Program section_detail;

  /// Fails as build_programs().
  static Result<Programs> build(const gl::ShaderSource& source);
};

} // namespace isoscope
