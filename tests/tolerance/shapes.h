// Small closed surfaces and a fixed random sequence for the tests of the tolerance volume.
#pragma once

#include "input/triangle_soup.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace isoscope::testing {

/// A 64-bit linear congruential sequence: the same numbers with every library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2862933555777941757u + 3037000493u) {}
  double unit() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double between(double a, double b) { return a + (b - a) * unit(); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(unit() * static_cast<double>(n)); }
  Vec3 in_box(const Box3& b) {
    return {between(b.lo.x, b.hi.x), between(b.lo.y, b.hi.y), between(b.lo.z, b.hi.z)};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      const double l2 = squared_length(v);
      if (l2 <= 1 && l2 > 0.01) return normalized(v);
    }
  }

 private:
  std::uint64_t state_;
};

/// Adds a grid of (rows + 1) x columns points, closed in the column direction, at point(row, column).
template <class Point>
void add_tube(TriangleSoup& soup, unsigned rows, unsigned columns, bool closed_rows, Point&& point) {
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  const unsigned point_rows = closed_rows ? rows : rows + 1;
  for (unsigned i = 0; i < point_rows; ++i)
    for (unsigned j = 0; j < columns; ++j) soup.points.push_back(point(i, j));
  const auto id = [&](unsigned i, unsigned j) {
    return base + static_cast<std::uint32_t>((i % point_rows) * columns + j % columns);
  };
  for (unsigned i = 0; i < rows; ++i)
    for (unsigned j = 0; j < columns; ++j) {
      soup.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
}

inline void add_sphere(TriangleSoup& soup, Vec3 center, double radius, unsigned n) {
  const double pi = std::numbers::pi;
  const auto at = [&](double latitude, double longitude) {
    return center + radius * Vec3{std::cos(latitude) * std::cos(longitude),
                                  std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
  };
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  const unsigned columns = 2 * n;
  add_tube(soup, n - 2, columns, false,
           [&](unsigned i, unsigned j) { return at(-pi / 2 + pi * (i + 1) / n, 2 * pi * j / columns); });
  const auto south = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(center - Vec3{0, 0, radius});
  soup.points.push_back(center + Vec3{0, 0, radius});
  for (std::uint32_t j = 0; j < columns; ++j) {
    const std::uint32_t next = (j + 1) % columns, last = base + (n - 2) * columns;
    soup.triangles.push_back({south, base + next, base + j});
    soup.triangles.push_back({south + 1, last + j, last + next});
  }
}

inline void add_torus(TriangleSoup& soup, Vec3 center, double major, double minor, unsigned n) {
  const double turn = 2 * std::numbers::pi;
  add_tube(soup, 2 * n, n, true, [&](unsigned i, unsigned j) {
    const double u = turn * i / (2 * n), v = turn * j / n, r = major + minor * std::cos(v);
    return center + Vec3{r * std::cos(u), r * std::sin(u), minor * std::sin(v)};
  });
}

inline void add_box(TriangleSoup& soup, Vec3 lo, Vec3 hi) {
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  for (unsigned k = 0; k < 8; ++k)
    soup.points.push_back({k & 1u ? hi.x : lo.x, k & 2u ? hi.y : lo.y, k & 4u ? hi.z : lo.z});
  const std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    soup.triangles.push_back({base + q[0], base + q[1], base + q[2]});
    soup.triangles.push_back({base + q[0], base + q[2], base + q[3]});
  }
}

/// The same triangles, each with points of its own, shrunk about its centroid.
inline TriangleSoup exploded(const TriangleSoup& soup, double factor) {
  TriangleSoup result;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    const Vec3 c = (t[0] + t[1] + t[2]) / 3.0;
    const auto base = static_cast<std::uint32_t>(result.points.size());
    for (const Vec3 p : t) result.points.push_back(c + factor * (p - c));
    result.triangles.push_back({base, base + 1, base + 2});
  }
  return result;
}

} // namespace isoscope::testing
