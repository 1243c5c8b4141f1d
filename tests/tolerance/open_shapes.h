// Surfaces with a border, for tests: sheets cut out of a grid, strips, and what is left of closed shapes.
#pragma once

#include "input/gallery_shapes.h"
#include "input/triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace isoscope::test {

/// The cells of a grid of n × n over the unit square for which `has` holds, bent by `height`.
inline TriangleSoup grid_sheet(int n, const std::function<bool(double, double)>& has,
                               const std::function<double(double, double)>& height = {}) {
  TriangleSoup sheet;
  sheet.name = "sheet";
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      sheet.points.push_back({x, y, height ? height(x, y) : 0});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (!has((i + 0.5) / n, (j + 0.5) / n)) continue;
      sheet.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      sheet.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return sheet;
}

inline TriangleSoup square_with_hole() {
  return grid_sheet(20,
                    [](double x, double y) { return std::abs(x - 0.5) > 0.2 || std::abs(y - 0.5) > 0.2; });
}

/// Its slit, which doubles the points along it, is closed by any tolerance.
inline TriangleSoup slit_square() {
  TriangleSoup sheet = grid_sheet(16, [](double, double) { return true; });
  const std::size_t whole = sheet.points.size();
  std::vector<std::uint32_t> copy(whole);
  for (std::uint32_t v = 0; v < whole; ++v) {
    const Vec3 p = sheet.points[v];
    copy[v] = v;
    if (p.y != 0.5 || !(p.x > 0.25) || !(p.x < 0.75)) continue;
    copy[v] = static_cast<std::uint32_t>(sheet.points.size());
    sheet.points.push_back({p.x, p.y + 1e-4, p.z});
  }
  for (auto& t : sheet.triangles) {
    const Triangle3 c{sheet.points[t[0]], sheet.points[t[1]], sheet.points[t[2]]};
    if (centroid(c).y > 0.5)
      for (auto& v : t) v = copy[v];
  }
  return sheet;
}

/// A square whose upper half has a point more on the edge between them: a triangle without area closes what
/// that leaves open, as repair tools do.
inline TriangleSoup square_with_needle() {
  TriangleSoup sheet;
  sheet.name = "sheet";
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {1, 0.5, 0}, {0.5, 0.5, 0}, {0, 1, 0}, {1, 1, 0}};
  sheet.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 4}, {2, 4, 5}, {4, 3, 6}, {4, 6, 5}};
  return sheet;
}

/// A square of which a part of the border is folded back by `width`, a little above.
inline TriangleSoup square_with_flap(double width) {
  TriangleSoup sheet = grid_sheet(10, [](double, double) { return true; });
  const auto at = [](std::uint32_t j) { return j * 11 + 10; };
  std::vector<std::uint32_t> flap;
  for (std::uint32_t j = 3; j <= 7; ++j) {
    flap.push_back(static_cast<std::uint32_t>(sheet.points.size()));
    const bool end = j == 3 || j == 7;
    const Vec3 p = sheet.points[at(j)];
    if (end)
      flap.back() = at(j);
    else
      sheet.points.push_back({p.x - width, p.y, 0.05 * width});
  }
  for (std::uint32_t k = 0; k + 1 < flap.size(); ++k) {
    if (flap[k] != at(3 + k)) sheet.triangles.push_back({at(3 + k), flap[k], flap[k + 1]});
    if (flap[k + 1] != at(4 + k)) sheet.triangles.push_back({at(3 + k), flap[k + 1], at(4 + k)});
  }
  return sheet;
}

/// A square with teeth of random lengths on one side.
inline TriangleSoup jagged_square(int n, unsigned seed) {
  std::vector<double> ends;
  for (int j = 0; j < n; ++j) {
    seed = seed * 1664525u + 1013904223u;
    ends.push_back(0.85 + 0.15 * (seed >> 16 & 0xff) / 255.0);
  }
  return grid_sheet(
      n, [&](double x, double y) { return x < ends[static_cast<std::size_t>(y * n)]; },
      [](double x, double) { return 0.2 * x * x; });
}

/// A tube of height 0.6 and radius 1 below, which narrows upwards by `taper` times the height, of triangles
/// as long as it is high. Its upper end is a ring of teeth, a triangle each.
inline TriangleSoup crown(std::uint32_t teeth, double length, double taper) {
  TriangleSoup tube;
  tube.name = "crown";
  const auto add_ring = [&](double height, double shift) {
    for (std::uint32_t i = 0; i < teeth; ++i) {
      const double angle = 2 * std::numbers::pi * (i + shift) / teeth, radius = 1 - taper * height;
      tube.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  };
  add_ring(0, 0);
  add_ring(0.6, 0.5);
  add_ring(0.6 + length, 1);
  for (std::uint32_t i = 0; i < teeth; ++i) {
    const std::uint32_t next = (i + 1) % teeth;
    tube.triangles.push_back({i, next, teeth + i});
    tube.triangles.push_back({next, teeth + next, teeth + i});
    tube.triangles.push_back({teeth + i, teeth + next, 2 * teeth + i});
  }
  return tube;
}

/// A wedge of the plane between two edges of length 1, bent along them, with its tip in the origin.
inline TriangleSoup wedge(double degrees, int n = 16) {
  const double half = std::tan(degrees * std::numbers::pi / 360);
  TriangleSoup sheet;
  sheet.name = "wedge";
  sheet.points.push_back({});
  for (int i = 1; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      sheet.points.push_back({x, x * half * (2 * y - 1), 0.15 * std::sin(3 * x)});
    }
  const auto at = [&](int i, int j) {
    return i == 0 ? 0u : static_cast<std::uint32_t>((i - 1) * (n + 1) + j + 1);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      sheet.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      if (i > 0) sheet.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return sheet;
}

/// A bent square with one tooth on its border.
inline TriangleSoup square_with_tooth(double tooth_length, double width) {
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y; };
  TriangleSoup sheet = grid_sheet(
      20, [](double, double) { return true; }, height);
  const std::uint32_t low = 10 * 21 + 20, high = 11 * 21 + 20, behind = low - 1;
  std::erase_if(sheet.triangles, [&](const auto& t) {
    return std::find(t.begin(), t.end(), low) != t.end() && std::find(t.begin(), t.end(), high) != t.end();
  });
  const auto first = static_cast<std::uint32_t>(sheet.points.size());
  for (const double y : {0.525 - width / 2, 0.525 + width / 2})
    sheet.points.push_back({1, y, height(1, 0.525)});
  sheet.points.push_back({1 + tooth_length, 0.525, height(1, 0.525)});
  sheet.triangles.insert(sheet.triangles.end(), {{behind, low, first},
                                                 {behind, first, first + 1},
                                                 {behind, first + 1, high},
                                                 {first, first + 2, first + 1}});
  return sheet;
}

/// A bent square with a square hole into which a strip of that width reaches, so that one loop runs on both
/// sides of it.
inline TriangleSoup square_with_tongue(double width) {
  const auto has = [&](double x, double y) {
    const bool in_hole = x > 0.3 && x < 0.7 && y > 0.3 && y < 0.7;
    return !in_hole || (std::abs(y - 0.5) < width / 2 && x > 0.36);
  };
  return grid_sheet(100, has, [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y; });
}

/// Adds the part of a dented unit square with x in a range, of n by m squares; turned the other way round.
inline void add_dented_patch(TriangleSoup& soup, double from, double to, std::uint32_t n, std::uint32_t m,
                             bool turned = false) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= m; ++j) {
      const double x = from + (to - from) * i / n, y = 1.0 * j / m;
      soup.points.push_back({x, y, 0.2 * std::sin(2 * x + y)});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::uint32_t a = first + i * (m + 1) + j, b = a + m + 1;
      for (std::array<std::uint32_t, 3> t : {std::array{a, b, b + 1}, std::array{a, b + 1, a + 1}}) {
        if (turned) std::swap(t[1], t[2]);
        soup.triangles.push_back(t);
      }
    }
}

/// Two patches with other points at their seam, one of which has a splinter there that is folded back.
inline TriangleSoup patches_with_splinter(double width) {
  TriangleSoup soup;
  soup.name = "patches";
  add_dented_patch(soup, 0, 0.5, 10, 10);
  const std::uint32_t low = 10 * 11 + 4, high = low + 1;
  add_dented_patch(soup, 0.5, 1, 7, 9);
  const Vec3 middle = 0.5 * (soup.points[low] + soup.points[high]);
  soup.triangles.push_back({high, low, static_cast<std::uint32_t>(soup.points.size())});
  soup.points.push_back(middle + width * Vec3{-1, 0, 0.3});
  return soup;
}

/// A strip around the z axis of a half turn for each of `half_turns`: one-sided where they are odd.
inline TriangleSoup strip(int half_turns, double width = 0.35, int along = 96, int across = 6) {
  TriangleSoup strip;
  strip.name = "strip";
  for (int i = 0; i < along; ++i)
    for (int j = 0; j <= across; ++j) {
      const double turn = 2 * std::numbers::pi * i / along, twist = 0.5 * half_turns * turn;
      const double s = width * (2.0 * j / across - 1);
      const double r = 1 + s * std::cos(twist);
      strip.points.push_back({r * std::cos(turn), r * std::sin(turn), s * std::sin(twist)});
    }
  const auto at = [&](int i, int j) {
    const bool round = i >= along && half_turns % 2 != 0;
    return static_cast<std::uint32_t>((i % along) * (across + 1) + (round ? across - j : j));
  };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      strip.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      strip.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return strip;
}

/// A sphere without the triangles near to four corners of a tetrahedron.
inline TriangleSoup ball_with_holes() {
  TriangleSoup ball = make_sphere(4);
  const Vec3 corners[4] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  std::erase_if(ball.triangles, [&](const auto& t) {
    const Vec3 c = centroid(Triangle3{ball.points[t[0]], ball.points[t[1]], ball.points[t[2]]});
    for (const Vec3 corner : corners)
      if (distance(normalized(c), normalized(corner)) < 0.35) return true;
    return false;
  });
  ball.name = "ball with holes";
  return ball;
}

/// The unit sphere with a round hole of that radius.
inline TriangleSoup ball_with_hole(double radius) {
  constexpr std::uint32_t around = 60, rings = 40;
  TriangleSoup ball;
  ball.name = "ball with a hole";
  const double first = std::asin(radius);
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t k = 0; k < around; ++k) {
      const double down = first + (std::numbers::pi - first) * i / rings;
      const double turn = 2 * std::numbers::pi * k / around;
      ball.points.push_back(
          {std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down)});
    }
  const auto pole = static_cast<std::uint32_t>(ball.points.size());
  ball.points.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around;
      if (i + 1 == rings) {
        ball.triangles.push_back({a, pole, b});
        continue;
      }
      ball.triangles.push_back({a, a + around, b + around});
      ball.triangles.push_back({a, b + around, b});
    }
  return ball;
}

/// A comb of prongs of height 1 with gaps between them, 0.6 deep, of which the back is open.
inline TriangleSoup open_comb(int gaps, double prong, double gap) {
  TriangleSoup comb;
  comb.name = "open comb";
  const int columns = 2 * gaps + 1, width = columns + 1;
  const std::array<double, 3> heights{0, 0.2, 1};
  for (const double y : {0.0, 0.6})
    for (const double z : heights)
      for (int i = 0; i < width; ++i) comb.points.push_back({((i + 1) / 2) * prong + (i / 2) * gap, y, z});
  const auto at = [&](int i, int level) { return static_cast<std::uint32_t>(level * width + i); };
  const auto behind = static_cast<std::uint32_t>(heights.size()) * static_cast<std::uint32_t>(width);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; // of the front, as its squares run
  for (int i = 0; i < columns; ++i)
    for (int level = 0; level < (i % 2 == 0 ? 2 : 1); ++level) {
      const std::array<std::uint32_t, 4> square{at(i, level), at(i + 1, level), at(i + 1, level + 1),
                                                at(i, level + 1)};
      comb.triangles.push_back({square[0], square[1], square[2]});
      comb.triangles.push_back({square[0], square[2], square[3]});
      for (std::size_t k = 0; k < 4; ++k) edges.emplace_back(square[k], square[(k + 1) % 4]);
    }
  for (const auto& [a, b] : edges) {
    if (std::find(edges.begin(), edges.end(), std::pair{b, a}) != edges.end()) continue;
    comb.triangles.push_back({a, a + behind, b + behind});
    comb.triangles.push_back({a, b + behind, b});
  }
  return comb;
}

inline std::shared_ptr<const TriangleSoup> shared(TriangleSoup soup) {
  return std::make_shared<const TriangleSoup>(std::move(soup));
}

} // namespace isoscope::test
