// The loose box around S, its corners and their distance-scaled values.
#include "refine/loose_box.h"

namespace isoscope {
namespace {

constexpr double looseness = 0.25; ///< of the longest edge, on every side
constexpr int grid_bits = 20;      ///< corners lie on a grid of 2^-20 of the longest edge

double grid_unit(double length) {
  return std::ldexp(1.0, static_cast<int>(std::floor(std::log2(length))) - grid_bits);
}

double corner_value(double distance_to_boundary) {
  const double doublings = std::floor(std::log2(1 + std::max(0.0, distance_to_boundary)));
  return std::max(1.0, std::ldexp(1.0, static_cast<int>(doublings)) - 1);
}

} // namespace

std::vector<Vertex> loose_box_corners(const ToleranceVolume& volume, const BoundarySamples& samples) {
  Box3 box;
  for (const Vec3& p : samples.positions) box.add(p);
  if (box.empty()) box = volume.field().bounds().grown(volume.thresholds().boundary);
  const double longest = box.longest_edge();
  const Box3 loose = box.grown(looseness * longest);
  const double unit = grid_unit(longest);
  const double boundary = volume.thresholds().boundary;
  std::vector<Vertex> corners;
  for (unsigned k = 0; k < 8; ++k) {
    Vertex vertex;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = (k >> axis) & 1u ? loose.hi[axis] : loose.lo[axis];
      vertex.position[axis] = std::round(x / unit) * unit;
    }
    const double depth = (volume.field().distance(vertex.position) - boundary) / boundary;
    vertex.value = volume.regions().front().label * corner_value(depth);
    vertex.kind = VertexKind::box;
    corners.push_back(vertex);
  }
  return corners;
}

} // namespace isoscope
