// The four planes of a tetrahedron as a filter: most points are told inside or outside without exact
// predicates.
#pragma once

#include "base/geometry.h"
#include "mesh/complex.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace isoscope {

/// Four functions, positive inside, of points relative to a common origin.
struct TetPlanes {
  std::array<double, 4> nx{}, ny{}, nz{}, c{};

  TetPlanes(const std::array<Vec3, 4>& p, Vec3 origin) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& f = outward_facets[i];
      const Vec3 a = p[f[0]], n = cross(p[f[2]] - a, p[f[1]] - a);
      nx[i] = n.x;
      ny[i] = n.y;
      nz[i] = n.z;
      c[i] = -dot(n, a - origin);
    }
  }
  /// Smallest of the four values at x, and its plane.
  std::pair<double, std::size_t> lowest(Vec3 x) const {
    std::array<double, 4> h{};
    for (std::size_t i = 0; i < 4; ++i) h[i] = nx[i] * x.x + ny[i] * x.y + nz[i] * x.z + c[i];
    const std::size_t a = h[1] < h[0] ? 1 : 0, b = h[3] < h[2] ? 3 : 2, low = h[b] < h[a] ? b : a;
    return {h[low], low};
  }
  /// Whether a box lies outside one of the planes by more than `margin`.
  bool miss(Vec3 center, Vec3 half, double margin) const {
    bool missed = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const double most = nx[i] * center.x + ny[i] * center.y + nz[i] * center.z + c[i] +
                          std::abs(nx[i]) * half.x + std::abs(ny[i]) * half.y + std::abs(nz[i]) * half.z;
      missed |= most < -margin;
    }
    return missed;
  }
};

/// Bounds the rounding of the planes of tetrahedra in a box, at points of it relative to its centre.
inline double plane_margin(const Box3& box) {
  // At most 60 roundings of products bounded by the box's volume; see filtered_det in predicates.cpp for the
  // pattern.
  const Vec3 e = box.extent();
  return 2e-14 * e.x * e.y * e.z + 1e-280;
}

} // namespace isoscope
