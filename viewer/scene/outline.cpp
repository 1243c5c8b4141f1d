// Extremes in directions that are spread evenly.
#include "scene/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace isoscope {
namespace {

constexpr std::size_t directions = 128;
constexpr std::size_t most_points = 50000; ///< that are looked at

/// Along a spiral from pole to pole.
std::array<Vec3, directions> spread() {
  std::array<Vec3, directions> out;
  for (std::size_t i = 0; i < directions; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / directions, r = std::sqrt(1 - z * z);
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0)) * static_cast<double>(i);
    out[i] = {r * std::cos(turn), r * std::sin(turn), z};
  }
  return out;
}

} // namespace

std::vector<Vec3> outline(const TriangleSoup& input, double margin) {
  const Box3 box = input.bounds();
  if (box.empty()) return {};
  static const std::array<Vec3, directions> along = spread();
  const bool points = input.is_point_set();
  const std::size_t count = points ? input.points.size() : 3 * input.triangles.size();
  std::array<double, directions> reach;
  reach.fill(-std::numeric_limits<double>::infinity());
  std::array<Vec3, directions> farthest;
  for (std::size_t i = 0, step = count / most_points + 1; i < count; i += step) {
    const Vec3 p = input.points[points ? i : input.triangles[i / 3][i % 3]];
    for (std::size_t d = 0; d < directions; ++d)
      if (const double far = dot(p, along[d]); far > reach[d]) {
        reach[d] = far;
        farthest[d] = p;
      }
  }
  std::vector<Vec3> out;
  out.reserve(directions + 6);
  for (std::size_t d = 0; d < directions; ++d) out.push_back(farthest[d] + margin * along[d]);
  const Vec3 middle = box.center(), half = 0.5 * box.extent() + Vec3{margin, margin, margin};
  for (const double sign : {-1.0, 1.0}) {
    out.push_back(middle + Vec3{sign * half.x, 0, 0});
    out.push_back(middle + Vec3{0, sign * half.y, 0});
    out.push_back(middle + Vec3{0, 0, sign * half.z});
  }
  return out;
}

} // namespace isoscope
