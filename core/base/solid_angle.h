// Solid angles of triangles, and sums of many.
#pragma once

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace isoscope {

/// A sum of the signed solid angles of triangles, each in (−2π, 2π) (van Oosterom and Strackee 1983). Half of
/// each is the argument of a complex number; their product has that of the sum, so that one arc tangent does
/// for all.
class SolidAngleSum {
 public:
  /// As seen from p; `turn`: -1 where the triangle counts the other way round.
  void add(Vec3 p, const Triangle3& t, double turn = 1) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    add(la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb, turn * dot(a, cross(b, c)));
  }
  double value() const { return 2 * (std::atan2(im_, re_) + 2 * std::numbers::pi * turns_); }
  /// The same as how often the triangles wind around p: a whole number where they close.
  double winding() const { return value() / (4 * std::numbers::pi); }

 private:
  void add(double re, double im) {
    const double next_re = re_ * re - im_ * im, next_im = re_ * im + im_ * re;
    const double size = std::max(std::abs(next_re), std::abs(next_im));
    if (!(size > 0)) return; // p is a corner
    // Two angles of one sign whose sum comes out with the other have gone past π.
    if (im_ >= 0 && im >= 0 && next_im < 0) ++turns_;
    if (im_ < 0 && im < 0 && next_im >= 0) --turns_;
    re_ = next_re / size;
    im_ = next_im / size;
  }

  double re_ = 1, im_ = 0;
  int turns_ = 0;
};

/// The whole number that a winding number is nearer to than `within`, in (0, 0.5]; nothing where gaps leave
/// that open.
inline std::optional<long> whole_winding(double winding, double within) {
  const double whole = std::round(winding);
  return std::abs(winding - whole) < within ? std::optional(static_cast<long>(whole)) : std::nullopt;
}

/// Of one triangle.
inline double solid_angle(Vec3 p, const Triangle3& t) {
  SolidAngleSum sum;
  sum.add(p, t);
  return sum.value();
}

} // namespace isoscope
