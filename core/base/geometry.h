// Plain points, boxes and triangles in double precision; no predicates that decide validity live here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isoscope {

/// A point or vector of R³, in the units of the input.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr double& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
  constexpr double operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(Vec3 a) {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec3 operator*(Vec3 a, double s) {
  return s * a;
}
constexpr Vec3 operator/(Vec3 a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
constexpr Vec3& operator+=(Vec3& a, Vec3 b) {
  return a = a + b;
}
constexpr double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_length(Vec3 a) {
  return dot(a, a);
}
inline double length(Vec3 a) {
  return std::sqrt(squared_length(a));
}
inline double distance(Vec3 a, Vec3 b) {
  return length(a - b);
}
/// a / |a|, or the zero vector when a is zero.
inline Vec3 normalized(Vec3 a) {
  const double l = length(a);
  return l > 0 ? a / l : Vec3{};
}
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

using Triangle3 = std::array<Vec3, 3>;

inline Vec3 centroid(const Triangle3& t) {
  return (t[0] + t[1] + t[2]) / 3.0;
}
/// The normal, as long as the area.
inline Vec3 area_vector(const Triangle3& t) {
  return 0.5 * cross(t[1] - t[0], t[2] - t[0]);
}
inline double area(const Triangle3& t) {
  return 0.5 * length(cross(t[1] - t[0], t[2] - t[0]));
}

/// An axis-aligned box; empty (lo > hi) when default-constructed.
struct Box3 {
  static constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 lo{inf, inf, inf}, hi{-inf, -inf, -inf};

  constexpr bool empty() const { return lo.x > hi.x; }
  constexpr void add(Vec3 p) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], p[i]);
      hi[i] = std::max(hi[i], p[i]);
    }
  }
  constexpr void add(const Box3& b) {
    if (b.empty()) return;
    add(b.lo);
    add(b.hi);
  }
  constexpr Vec3 center() const { return 0.5 * (lo + hi); }
  constexpr Vec3 extent() const { return hi - lo; }
  constexpr double longest_edge() const {
    const Vec3 e = extent();
    return empty() ? 0.0 : std::max({e.x, e.y, e.z});
  }
  constexpr Box3 grown(double margin) const {
    const Vec3 m{margin, margin, margin};
    return {lo - m, hi + m};
  }
  /// Whether they have a point in common; of boxes that are not empty.
  constexpr bool meets(const Box3& b) const {
    for (int i = 0; i < 3; ++i)
      if (lo[i] > b.hi[i] || b.lo[i] > hi[i]) return false;
    return true;
  }
};

constexpr Box3 box_of(const Triangle3& t) {
  Box3 box;
  for (const Vec3 p : t) box.add(p);
  return box;
}

} // namespace isoscope
