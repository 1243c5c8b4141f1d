// The axes of a cutting plane.
#include "scene/renderer.h"

#include <cmath>

namespace isoscope {

PlaneAxes plane_axes(Vec3 normal) {
  const Vec3 n = normalized(normal);
  const Vec3 up = std::abs(n.y) > 0.9999 ? Vec3{0, 0, n.y > 0 ? -1.0 : 1.0} : Vec3{0, 1, 0};
  const Vec3 v = normalized(up - dot(up, n) * n);
  return {cross(v, n), v, n};
}

} // namespace isoscope
