// Points of noisy scans for tests, the same bits everywhere.
#pragma once

#include "input/triangle_soup.h"
#include "tolerance/shapes.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace isoscope::testing {

/// About normally distributed with variance 1.
inline double gauss(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

inline Vec3 noise(Random& random, double size) {
  return {size * gauss(random), size * gauss(random), size * gauss(random)};
}

/// Points of a sphere around the origin with noise of this size along each axis.
inline std::vector<Vec3> sphere_points(Random& random, std::size_t n, double radius, double noise_size) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(radius * random.direction() + noise(random, noise_size));
  return points;
}

/// Points evenly on the triangles of a soup, with noise.
inline std::vector<Vec3> surface_points(Random& random, const TriangleSoup& soup, std::size_t n,
                                        double noise_size) {
  std::vector<double> passed;
  double area = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    passed.push_back(area += isoscope::area(soup.triangle(i)));
  std::vector<Vec3> points;
  while (points.size() < n) {
    const auto at = std::lower_bound(passed.begin(), passed.end(), area * random.unit()) - passed.begin();
    const Triangle3 t = soup.triangle(static_cast<std::size_t>(at));
    const double r = std::sqrt(random.unit()), s = random.unit();
    points.push_back((1 - r) * t[0] + r * (1 - s) * t[1] + r * s * t[2] + noise(random, noise_size));
  }
  return points;
}

inline void add_outliers(Random& random, std::vector<Vec3>& points, std::size_t n, const Box3& box) {
  for (std::size_t i = 0; i < n; ++i) points.push_back(random.in_box(box));
}

} // namespace isoscope::testing
