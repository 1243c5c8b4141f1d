// Where a plane, or a line in one, meets a convex polygon.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace isoscope {

/// The two ends of what a convex polygon has at height 0, nothing where it stays on one side. `height(i)`: of
/// corner i; corners at 0 count as above. `point(i, j, t)`: at share t of the way from corner i to corner j.
template <class Height, class Point>
auto cut_polygon(std::size_t corners, const Height& height, const Point& point) {
  std::array<std::invoke_result_t<Point, std::size_t, std::size_t, double>, 2> ends;
  std::size_t found = 0;
  for (std::size_t i = 0; i < corners && found < 2; ++i) {
    const std::size_t j = (i + 1) % corners;
    const double hi = height(i), hj = height(j);
    if ((hi >= 0) != (hj >= 0)) ends[found++] = point(i, j, hi / (hi - hj));
  }
  return found == 2 ? std::optional(ends) : std::nullopt;
}

} // namespace isoscope
