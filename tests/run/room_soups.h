// Rooms that share walls, as soups.
#pragma once

#include "input/gallery_shapes.h"
#include "input/triangle_soup.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace isoscope::test {

inline void add_square(TriangleSoup& soup, Vec3 corner, Vec3 u, Vec3 v) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3 p : {corner, corner + u, corner + u + v, corner + v}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  soup.triangles.push_back({first, first + 2, first + 3});
}

/// The sides of a box, without one if asked.
inline void add_walls(TriangleSoup& soup, Vec3 lo, Vec3 hi, bool bottom = true) {
  const Vec3 e = hi - lo;
  const std::array<Vec3, 3> axis{Vec3{e.x, 0, 0}, {0, e.y, 0}, {0, 0, e.z}};
  for (std::size_t k = 0; k < 3; ++k)
    for (const bool far : {false, true})
      if (far || k != 2 || bottom)
        add_square(soup, far ? lo + axis[k] : lo, axis[(k + 1) % 3], axis[(k + 2) % 3]);
}

/// Every triangle as four.
inline TriangleSoup in_four(const TriangleSoup& soup) {
  TriangleSoup fine;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto [a, b, c] = soup.triangle(i);
    const auto first = static_cast<std::uint32_t>(fine.points.size());
    for (const Vec3 p : {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) fine.points.push_back(p);
    const std::array<std::array<std::uint32_t, 3>, 4> parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
    for (const auto& t : parts) fine.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return fine;
}

/// So many unit cubes along each axis; each wall once.
inline TriangleSoup cubes(int nx, int ny, int nz) {
  TriangleSoup soup;
  const std::array<int, 3> n{nx, ny, nz};
  const std::array<Vec3, 3> axis{Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    for (int a = 0; a <= n[k]; ++a)
      for (int b = 0; b < n[u]; ++b)
        for (int c = 0; c < n[v]; ++c) {
          const Vec3 corner = static_cast<double>(a) * axis[k] + static_cast<double>(b) * axis[u] +
                              static_cast<double>(c) * axis[v];
          add_square(soup, corner, axis[u], axis[v]);
        }
  }
  return soup;
}

/// Two cubes side by side and a box over both: walls meet in a T.
inline TriangleSoup three_in_t() {
  TriangleSoup soup = cubes(2, 1, 1);
  add_walls(soup, {0, 0, 1}, {2, 1, 2}, false);
  return soup;
}

/// The unit sphere and a polygon of 64 corners across its middle.
inline TriangleSoup sphere_with_disc() {
  TriangleSoup soup = make_sphere(3);
  const auto center = static_cast<std::uint32_t>(soup.points.size());
  constexpr std::uint32_t n = 64;
  soup.points.push_back({});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({center, center + 1 + i, center + 1 + (i + 1) % n});
  }
  return soup;
}

} // namespace isoscope::test
