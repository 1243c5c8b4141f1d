// Raw triangles or points as they come from a file or from the gallery: no manifoldness, no orientation, no
// connectivity promised.
#pragma once

#include "base/geometry.h"
#include "base/labels.h"
#include "input/scalar_grid.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace isoscope {

/// An indexed triangle soup with finite coordinates and indices in range; degenerate triangles may occur.
/// Without triangles it is a set of points. It may give a tolerance volume instead of a surface: by its
/// walls, or by a grid that its triangles only show.
struct TriangleSoup {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::string name; ///< what to call it in the window and the report: a file's stem or a gallery name

  std::size_t outer_triangles = 0; ///< of two walls: so many first ones are the outer one's; else 0
  std::shared_ptr<const ScalarGrid> grid = nullptr; ///< as it was read; else null

  bool gives_volume() const { return outer_triangles > 0 || grid != nullptr; }
  Triangle3 triangle(std::size_t i) const {
    const auto& t = triangles[i];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
  bool is_point_set() const { return triangles.empty() && !points.empty(); }
  double area() const {
    double sum = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      sum += isoscope::area(triangle(i));
    }
    return sum;
  }
  /// Of the triangles; of a point set's points.
  Box3 bounds() const {
    Box3 b;
    if (is_point_set())
      for (const Vec3 p : points) b.add(p);
    for (const auto& t : triangles)
      for (const auto v : t) b.add(points[v]);
    return b;
  }
};

/// An indexed triangle mesh that we made: the zero set as it is written to a file.
struct TriangleMesh {
  std::vector<Vec3> points;
  /// Counter-clockwise seen from outside (label +1), or from the larger one of their labels.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// What each triangle lies between, where there is more than one inside.
  std::vector<LabelPair> labels = {};
};

} // namespace isoscope
