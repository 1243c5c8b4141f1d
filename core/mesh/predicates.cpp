// Static filters first, then CGAL: exact signs on doubles.
#include "mesh/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

Kernel::Point_3 cgal_point(Vec3 v) {
  return {v.x, v.y, v.z};
}

constexpr int sign_of(double x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

/// Six products of three differences each: at most 48 roundings of at most the largest product, doubled for
/// safety.
constexpr double det_error = 1.1e-14;
/// Below this the products may underflow and the bound no longer holds.
constexpr double det_underflow = 1e-280;

struct Det {
  double value, bound;
  bool certain() const { return std::abs(value) > bound; }
};

/// det(u, v, w) with a bound of its error that allows each component to be a rounded difference.
Det filtered_det(Vec3 u, Vec3 v, Vec3 w) {
  const double mx = std::max({std::abs(u.x), std::abs(v.x), std::abs(w.x)});
  const double my = std::max({std::abs(u.y), std::abs(v.y), std::abs(w.y)});
  const double mz = std::max({std::abs(u.z), std::abs(v.z), std::abs(w.z)});
  return {dot(cross(u, v), w), det_error * mx * my * mz + det_underflow};
}

int exact_det_sign(Vec3 a, Vec3 b, Vec3 c, Vec3 direction) {
  const auto diff = [](double p, double q) -> Exact { return Exact(p) - Exact(q); };
  return static_cast<int>(CGAL::sign(
      CGAL::determinant(diff(b.x, a.x), diff(b.y, a.y), diff(b.z, a.z), diff(c.x, a.x), diff(c.y, a.y),
                        diff(c.z, a.z), Exact(direction.x), Exact(direction.y), Exact(direction.z))));
}

/// Shift s + t·e0 + t²·e1 + t³·e2 for all small t > 0: linearly independent, so one of them leaves any plane.
constexpr std::array<Vec3, 3> shift{Vec3{0.6180339887498949, 0.3819660113183213, 0.6871214994603411},
                                    Vec3{-0.2679491924311227, 0.9063077870366499, 0.3249196962329063},
                                    Vec3{0.5773502691896257, -0.4142135623730951, 0.7071067811865476}};

} // namespace

int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Det det = filtered_det(b - a, c - a, d - a);
  if (det.certain()) return sign_of(det.value);
  return static_cast<int>(CGAL::orientation(cgal_point(a), cgal_point(b), cgal_point(c), cgal_point(d)));
}

int side_of_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e) {
  return static_cast<int>(CGAL::side_of_oriented_sphere(cgal_point(a), cgal_point(b), cgal_point(c),
                                                        cgal_point(d), cgal_point(e)));
}

int orientation_perturbed(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const int plain = orientation(a, b, c, d);
  if (plain != 0) return plain;
  for (const Vec3 e : shift) {
    const Det det = filtered_det(b - a, c - a, e);
    const int side = det.certain() ? sign_of(det.value) : exact_det_sign(a, b, c, e);
    if (side != 0) return side;
  }
  return 0;
}

bool holds_perturbed(const std::array<Vec3, 4>& t, Vec3 x) {
  return orientation_perturbed(t[1], t[3], t[2], x) > 0 && orientation_perturbed(t[0], t[2], t[3], x) > 0 &&
         orientation_perturbed(t[0], t[3], t[1], x) > 0 && orientation_perturbed(t[0], t[1], t[2], x) > 0;
}

} // namespace isoscope
