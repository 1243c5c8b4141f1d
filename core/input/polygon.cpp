// Small polygons by ear clipping, large ones by a Delaunay triangulation.
#include "input/polygon.h"

#include "input/constrained_delaunay.h"
#include "input/ear_clipping.h"

#include <algorithm>

namespace isoscope {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Twice the area across the plane that the polygon lies in, on the side from which it runs
/// counter-clockwise.
Vec3 area_vector(std::span<const Vec3> points, std::span<const std::uint32_t> corners) {
  Vec3 area;
  const Vec3 origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += cross(points[corners[i]] - origin, points[corners[i + 1]] - origin);
  return area;
}

/// Zigzag from both ends of the list of corners: n - 2 triangles in any case.
void cut_strip(std::span<const std::uint32_t> corners, Triangles& triangles) {
  std::size_t low = 0, high = corners.size() - 1;
  for (bool from_low = true; high - low >= 2; from_low = !from_low) {
    if (from_low) {
      triangles.push_back({corners[low], corners[low + 1], corners[high]});
      ++low;
    } else {
      triangles.push_back({corners[low], corners[high - 1], corners[high]});
      --high;
    }
  }
}

} // namespace

bool triangulate_polygon(std::span<const Vec3> points, std::span<const std::uint32_t> corners,
                         const RunControl& control, Triangles& triangles) {
  if (corners.size() <= most_clipped_corners) {
    clip_ears(points, corners, triangles);
    return true;
  }
  if (triangulate_delaunay(points, corners, area_vector(points, corners), control, triangles)) return true;
  if (!control.cancelled()) cut_strip(corners, triangles);
  return false;
}

double flatness_deviation(std::span<const Vec3> points, std::span<const std::uint32_t> corners) {
  if (corners.size() <= 3) return 0;
  const Vec3 area = area_vector(points, corners);
  if (area == Vec3{}) return 0;
  const Vec3 normal = normalized(area), origin = points[corners[0]];
  double sum = 0;
  for (const std::uint32_t v : corners) sum += dot(normal, points[v] - origin);
  const double middle = sum / static_cast<double>(corners.size());
  double largest = 0;
  for (const std::uint32_t v : corners)
    largest = std::max(largest, std::abs(dot(normal, points[v] - origin) - middle));
  return largest;
}

} // namespace isoscope
