// Triangles with equal points merged, and what its edges tell.
#pragma once

#include "input/triangle_soup.h"
#include "tolerance/closest_point.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

using IndexTriangle = std::array<std::uint32_t, 3>;

/// Triangles with bitwise equal points merged and unused ones dropped; triangles keep their ids.
struct WeldedMesh {
  std::vector<Vec3> points; ///< ascending by x, y, z
  std::vector<IndexTriangle> triangles;
};
WeldedMesh weld(const TriangleSoup& soup);
WeldedMesh weld(const ClosestPointIndex& index);

/// One side of an edge: its ends in order, its triangle, and whether that runs from the lower end to the
/// higher one.
struct EdgeUse {
  std::uint32_t low, high, triangle;
  bool ascends;
  /// As the triangle runs.
  std::uint32_t from() const { return ascends ? low : high; }
  std::uint32_t to() const { return ascends ? high : low; }
};

/// The sides of all edges of all triangles, ascending by edge, then triangle: those of an edge are
/// neighbours.
std::vector<EdgeUse> sorted_edge_uses(const std::vector<IndexTriangle>& triangles);
/// Those of edges that one triangle alone has: the border.
std::vector<EdgeUse> border_uses(const std::vector<IndexTriangle>& triangles);

/// A vertex whose triangles are joined across edges into more than one fan, where no edge has more than two.
std::optional<std::uint32_t> vertex_of_two_fans(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses);

/// Orients the triangles consistently where that is possible; false on a one-sided surface. No edge may have
/// more than two of them, as `uses` tells.
bool orient(std::vector<IndexTriangle>& triangles, const std::vector<EdgeUse>& uses);

/// Whether a triangle has a vertex twice.
inline bool is_collapsed(const IndexTriangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

} // namespace isoscope
