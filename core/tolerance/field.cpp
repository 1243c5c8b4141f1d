// Steps along the gradient of any field.
#include "tolerance/field.h"

namespace isoscope {
namespace {

constexpr int most_steps = 12;
/// How far from r a projected point may be, relative to r.
constexpr double projection_error = 1e-11;
/// A flatter gradient leads nowhere.
constexpr double least_slope = 1e-6;
/// What a sum of two distances may be off by, relatively.
constexpr double rounding = 1e-9;

} // namespace

std::optional<Vec3> ToleranceField::project(Vec3 p, const ClosestPoint& at, double r) const {
  Vec3 q = p;
  ClosestPoint here = at;
  for (int step = 0; step < most_steps; ++step) {
    const double gap = r - here.distance();
    if (std::abs(gap) <= projection_error * r) return q;
    const Vec3 slope = gradient(q, here);
    const double squared = squared_length(slope);
    if (!(squared > least_slope * least_slope)) return std::nullopt;
    q = q + (gap / squared) * slope;
    here = closest_near(q, here.triangle);
  }
  return std::nullopt;
}

std::optional<Vec3> ToleranceField::at_level(Vec3 p, const ClosestPoint& at, double r) const {
  if (!is_distance()) return project(p, at, r);
  const double d = at.distance();
  if (!(d > 0)) return std::nullopt;
  return at.point + (r / d) * (p - at.point);
}

bool ToleranceField::rises(Vec3 p, const ClosestPoint& at_p, Vec3 q, const ClosestPoint& at_q) const {
  // As φ is 1-Lipschitz, it grows along all of the way where its ends differ by their distance.
  return at_q.distance() >= (at_p.distance() + isoscope::distance(p, q)) * (1 - rounding);
}

} // namespace isoscope
