// Surfaces with a border: half a sphere, and what a scanner sees from one side.
#include "input/exact_circle.h"
#include "input/gallery_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

using Index = std::uint32_t;

/// The height of a triangle over (x, y), where it has one.
double height_at(const Triangle3& t, double x, double y) {
  const auto side = [](Vec3 a, Vec3 b, double px, double py) {
    return (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
  };
  const double a = side(t[1], t[2], x, y), b = side(t[2], t[0], x, y), c = side(t[0], t[1], x, y);
  const double sum = a + b + c;
  const bool inside = sum > 0 ? a >= 0 && b >= 0 && c >= 0 : sum < 0 && a <= 0 && b <= 0 && c <= 0;
  if (!inside) return -std::numeric_limits<double>::infinity();
  return (a * t[0].z + b * t[1].z + c * t[2].z) / sum;
}

} // namespace

TriangleSoup make_hemisphere(int rings) {
  TriangleSoup model;
  const int around = 4 * rings;
  model.points.push_back({0, 0, 1});
  for (int i = 1; i <= rings; ++i) {
    const CirclePoint down = circle_point(i, 4L * rings);
    for (int k = 0; k < around; ++k) {
      const CirclePoint at = circle_point(k, around);
      model.points.push_back({down.sine * at.cosine, down.sine * at.sine, down.cosine});
    }
  }
  const auto point = [&](int i, int k) {
    return i == 0 ? Index{0} : static_cast<Index>(1 + (i - 1) * around + k % around);
  };
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      model.triangles.push_back({point(i, k), point(i + 1, k), point(i + 1, k + 1)});
      if (i > 0) model.triangles.push_back({point(i, k), point(i + 1, k + 1), point(i, k + 1)});
    }
  return model;
}

TriangleSoup make_range_scan(const TriangleSoup& model, int columns,
                             const std::function<bool(Vec3)>& missing) {
  constexpr double steepest = 3; // rise of an edge over its run, beyond which one surface hides another
  const Box3 box = model.bounds();
  const double step = (box.hi.x - box.lo.x) / (columns - 1);
  const int rows = static_cast<int>((box.hi.y - box.lo.y) / step) + 1;
  const auto at = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
  };
  constexpr double nothing = -std::numeric_limits<double>::infinity();
  std::vector<double> height(at(0, rows), nothing);
  for (std::size_t f = 0; f < model.triangles.size(); ++f) {
    const Triangle3 t = model.triangle(f);
    Box3 b;
    for (const Vec3 p : t) b.add(p);
    const auto first = [&](double lo, double origin) {
      return std::max(0, static_cast<int>(std::ceil((lo - origin) / step)));
    };
    for (int j = first(b.lo.y, box.lo.y); j < rows && box.lo.y + j * step <= b.hi.y; ++j)
      for (int i = first(b.lo.x, box.lo.x); i < columns && box.lo.x + i * step <= b.hi.x; ++i)
        height[at(i, j)] = std::max(height[at(i, j)], height_at(t, box.lo.x + i * step, box.lo.y + j * step));
  }
  TriangleSoup scan;
  std::vector<Index> number(height.size(), 0);
  std::vector<char> seen(height.size(), 0);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Vec3 p{box.lo.x + i * step, box.lo.y + j * step, height[at(i, j)]};
      if (p.z == nothing || (missing && missing(p))) continue;
      seen[at(i, j)] = 1;
      number[at(i, j)] = static_cast<Index>(scan.points.size());
      scan.points.push_back(p);
    }
  const auto joined = [&](std::size_t a, std::size_t b) {
    return seen[a] != 0 && seen[b] != 0 && std::abs(height[a] - height[b]) <= steepest * step;
  };
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      // Whole squares only: a border along the grid has no vertex with a single triangle.
      if (!joined(a, b) || !joined(b, c) || !joined(c, d) || !joined(d, a)) continue;
      scan.triangles.push_back({number[a], number[b], number[c]});
      scan.triangles.push_back({number[a], number[c], number[d]});
    }
  return scan;
}

} // namespace isoscope
