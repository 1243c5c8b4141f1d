// Counts the octree's cells along the boundary.
#include "tolerance/sample_estimate.h"

#include "tolerance/regions.h"

#include <cmath>
#include <limits>

namespace isoscope {
namespace {

/// Cells are ambiguous whose centres are at most half a diagonal away from ∂Ω': the layer of this thickness,
/// in units of their side, holds one for each side³.
constexpr double layer = 1.7320508;
/// Measured on smooth and on sharp models; bytes of points with the floods of small cells that pockets ask
/// for.
constexpr double samples_by_density = 1.5, bytes_of_others = 150, bytes_of_points = 250;

} // namespace

double SampleEstimate::smallest_sigma(double bytes) const {
  if (bytes <= bytes_before) return std::numeric_limits<double>::infinity();
  return std::sqrt(samples_by_density * boundary_area * bytes_by_sample / (bytes - bytes_before));
}

SampleEstimate estimate_samples(const ToleranceVolume& volume) {
  const Regions& octree = volume.octree();
  std::size_t ambiguous = 0;
  for (std::size_t i = 0; i < octree.main_size(); ++i) {
    const Regions::Cell c = octree.cell(static_cast<Regions::CellIndex>(i));
    if (c.kind == Regions::Kind::ambiguous && c.level == octree.main_level()) ++ambiguous;
  }
  const double side = octree.side(octree.main_level());
  SampleEstimate estimate;
  estimate.boundary_area = static_cast<double>(ambiguous) * side * side / layer;
  estimate.bytes_before = static_cast<double>(volume.memory_bytes() + volume.field().memory_bytes());
  estimate.bytes_by_sample = volume.field().kind() == FieldKind::points ? bytes_of_points : bytes_of_others;
  estimate.samples_by_density = samples_by_density;
  return estimate;
}

} // namespace isoscope
