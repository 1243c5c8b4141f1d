// The quadric relative to the edge's middle and length; its minimum over half-spaces is a closest point in
// coordinates that make it round, found by a dual active-set method.
#include "criteria/collapse_cost.h"

#include "criteria/closest_in_half_spaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isoscope {

namespace {

/// Of the quadric's trace: how strongly the optimum is drawn to the middle.
constexpr double regularisation = 1e-6;

} // namespace

CollapseCost::CollapseCost(const EdgeStar& star) {
  const Vec3 a = star.vertices[0].position, b = star.vertices[1].position;
  middle_ = 0.5 * (a + b);
  const double edge = distance(a, b);
  if (edge > 0) size_ = edge;
  for (const Triangle3& t : star.cost_facets) {
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    if (n == Vec3{}) continue;
    const double d = -dot(n, t[0] - middle_) / size_;
    const std::array<double, 6> products{n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z};
    for (std::size_t i = 0; i < 6; ++i) a_[i] += products[i];
    b_ += d * n;
    c_ += d * d;
  }
  for (const Segment3& line : star.cost_borders) {
    const Vec3 t = normalized(line[1] - line[0]);
    if (t == Vec3{}) continue;
    // Two planes through the line, at right angles: I - ttᵀ.
    const Vec3 p = (line[0] - middle_) / size_, off = p - dot(p, t) * t;
    const std::array<double, 6> squares{1 - t.x * t.x, -t.x * t.y, -t.x * t.z,
                                        1 - t.y * t.y, -t.y * t.z, 1 - t.z * t.z};
    for (std::size_t i = 0; i < 6; ++i) a_[i] += squares[i];
    b_ += -off;
    c_ += squared_length(off);
  }
  const double trace = a_[0] + a_[3] + a_[5], r = trace > 0 ? regularisation * trace : 1;
  // Every pivot is at least the regularisation, but for rounding.
  const auto root = [r](double pivot) { return std::sqrt(std::max(pivot, 0.5 * r)); };
  l_[0] = root(a_[0] + r);
  l_[1] = a_[1] / l_[0];
  l_[2] = root(a_[3] + r - l_[1] * l_[1]);
  l_[3] = a_[2] / l_[0];
  l_[4] = (a_[4] - l_[3] * l_[1]) / l_[2];
  l_[5] = root(a_[5] + r - l_[3] * l_[3] - l_[4] * l_[4]);
}

Vec3 CollapseCost::forward(Vec3 r) const {
  const double x = r.x / l_[0], y = (r.y - l_[1] * x) / l_[2];
  return {x, y, (r.z - l_[3] * x - l_[4] * y) / l_[5]};
}

Vec3 CollapseCost::backward(Vec3 r) const {
  const double z = r.z / l_[5], y = (r.y - l_[4] * z) / l_[2];
  return {(r.x - l_[1] * y - l_[3] * z) / l_[0], y, z};
}

double CollapseCost::operator()(Vec3 x) const {
  const Vec3 u = (x - middle_) / size_;
  const double q = u.x * (a_[0] * u.x + 2 * (a_[1] * u.y + a_[2] * u.z)) +
                   u.y * (a_[3] * u.y + 2 * a_[4] * u.z) + a_[5] * u.z * u.z + 2 * dot(b_, u) + c_;
  return std::max(q, 0.0) * size_ * size_;
}

Vec3 CollapseCost::gradient(Vec3 x) const {
  const Vec3 u = (x - middle_) / size_;
  const Vec3 au{a_[0] * u.x + a_[1] * u.y + a_[2] * u.z, a_[1] * u.x + a_[3] * u.y + a_[4] * u.z,
                a_[2] * u.x + a_[4] * u.y + a_[5] * u.z};
  return 2 * size_ * (au + b_);
}

Vec3 CollapseCost::optimum() const {
  return middle_ + size_ * backward(forward(-b_));
}

std::optional<Vec3> CollapseCost::minimum(std::span<const HalfSpace> half_spaces) const {
  std::vector<HalfSpace> round;
  round.reserve(half_spaces.size());
  for (const HalfSpace& h : half_spaces) {
    const Vec3 n = forward(h.normal);
    const double l = length(n);
    if (!(l > 0)) return std::nullopt;
    round.push_back({n / l, -h.slack(middle_) / (size_ * l)});
  }
  const auto y = closest_in_half_spaces(round, forward(-b_));
  if (!y) return std::nullopt;
  return middle_ + size_ * backward(*y);
}

} // namespace isoscope
