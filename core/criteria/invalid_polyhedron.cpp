// Ψ and the kernel are both convex: their half-spaces together bound what is shown.
#include "criteria/invalid_region.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace isoscope {

namespace {

constexpr std::size_t ball_planes = 96;

/// Evenly spread directions: a spiral from pole to pole.
Vec3 direction(std::size_t i) {
  const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(ball_planes);
  const double turn = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0)),
               r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

} // namespace

KernelPolyhedron invalid_polyhedron(const InvalidRegion& region, const Kernel& kernel) {
  if (kernel.empty || region.empty()) return {};
  std::vector<HalfSpace> bounds = kernel.half_spaces;
  bounds.insert(bounds.end(), region.half_spaces.begin(), region.half_spaces.end());
  if (region.ball) {
    for (std::size_t i = 0; i < ball_planes; ++i) {
      const Vec3 n = -direction(i);
      bounds.push_back({n, dot(n, region.ball->center) - region.ball->radius});
    }
  }
  Box3 box;
  for (const Triangle3& f : kernel.facets) {
    for (const Vec3 p : f) box.add(p);
  }
  return half_space_polyhedron(bounds, kernel.center, box.longest_edge());
}

} // namespace isoscope
