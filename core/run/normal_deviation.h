// How the normals of a mesh deviate from those of the input behind it (Figure 26).
#pragma once

#include "input/triangle_soup.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace isoscope {

/// The distribution over the mesh's area of the angle between its normal and that of the closest input
/// triangle.
struct NormalDeviation {
  static constexpr double bin_degrees = 5;
  static constexpr std::size_t bin_count = 36;
  /// Angles in [0°, 180°] when the input is consistently oriented; else its normals have no sign, and angles
  /// are in [0°, 90°].
  bool oriented = false;
  std::array<double, bin_count> histogram{}; ///< shares of the area, from 0° up; they add up to 1
  double mean = 0, percentile_90 = 0, percentile_99 = 0; ///< degrees
  double above_30 = 0, above_90 = 0;                     ///< shares of the area
  std::size_t points = 0; ///< at which it was measured; 0: there was nothing to measure, or it was stopped
};

/// Measured, not proven: at points spread evenly over the facets, the same on any number of threads. Each
/// component of Ω takes the input with the orientation that most of the mesh in it agrees with, as cavities
/// may be given either way. Points next to degenerate input triangles are left out. A control out of grace
/// ends it with nothing measured.
NormalDeviation measure_normal_deviation(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                         const RunControl& control = {});

/// What that is made of, for those who measure a mesh part by part: a place, the angle between the normals
/// there, the area it stands for, and the component of Ω it lies in.
struct NormalMeasurement {
  double degrees = 0, area = 0;
  std::uint32_t component = 0;
};
struct NormalQuestion {
  const ClosestPointIndex& index;                             ///< the input, or what of it is near
  double area = 0;                                            ///< of all facets of the mesh
  std::function<bool(Vec3)> counts;                           ///< places that are measured; empty: all
  std::function<std::uint32_t(TriangleId)> component_of = {}; ///< empty: there is one
};
/// Nothing where it was stopped.
std::vector<NormalMeasurement> measure_normals(std::span<const Triangle3> facets,
                                               const NormalQuestion& question, const RunControl& control);
/// `components`: as many as are named.
NormalDeviation deviation_of(std::vector<NormalMeasurement> measurements, bool oriented,
                             std::size_t components);

} // namespace isoscope
