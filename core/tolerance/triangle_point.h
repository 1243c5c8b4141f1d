// The closest point on a triangle, inlined: where it is asked most often the call takes as long as a part of
// it.
#pragma once

#include "base/geometry.h"

namespace isoscope {

/// The closest of the points on three segments: for triangles whose corners nearly lie on a line.
Vec3 closest_point_on_edges(Vec3 p, const Triangle3& t);

/// As closest_point_on_triangle, to the last bit.
[[gnu::always_inline]] inline Vec3 closest_point_inlined(Vec3 p, const Triangle3& t) {
  const Vec3 a = t[0], ab = t[1] - a, ac = t[2] - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - t[1];
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const Vec3 cp = p - t[2];
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc; // = |ab x ac|²
  // On a needle the barycentric numerators cancel; its edges are then the answer to the last digits.
  const double scale = squared_length(ab) * squared_length(ac);
  if (!(sum > 1e-12 * scale)) [[unlikely]]
    return closest_point_on_edges(p, t);
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return t[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t[2] - t[1]);
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

} // namespace isoscope
