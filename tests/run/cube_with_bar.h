// A cube with a bar of any thickness, as one closed surface.
#pragma once

#include "tolerance/shapes.h"

#include <array>
#include <cstdint>

namespace isoscope::test {

/// One closed surface: the unit cube, from whose face x = 1 a bar grows out of [y] × [z].
inline TriangleSoup cube_with_bar(double y0, double y1, double z0, double z1, double length) {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  const auto on_face = [&](const auto& t) {
    return soup.points[t[0]].x == 1 && soup.points[t[1]].x == 1 && soup.points[t[2]].x == 1;
  };
  std::erase_if(soup.triangles, on_face);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const auto corner = [&](double x, double y, double z) { soup.points.push_back({x, y, z}); };
  for (const double x : {1.0, 1 + length})
    corner(x, y0, z0), corner(x, y1, z0), corner(x, y1, z1), corner(x, y0, z1);
  std::array<std::uint32_t, 4> outer{};
  for (std::uint32_t i = 0; i < first; ++i) {
    const Vec3 p = soup.points[i];
    if (p.x == 1) outer[p.z == 0 ? (p.y == 0 ? 0 : 1) : (p.y == 0 ? 3 : 2)] = i;
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4, a = first + i, b = first + j;
    soup.triangles.push_back({outer[i], outer[j], b}); // the frame around the bar's foot
    soup.triangles.push_back({outer[i], b, a});
    soup.triangles.push_back({a, b, b + 4}); // its sides
    soup.triangles.push_back({a, b + 4, a + 4});
  }
  soup.triangles.push_back({first + 4, first + 5, first + 6});
  soup.triangles.push_back({first + 4, first + 6, first + 7});
  return soup;
}

} // namespace isoscope::test
