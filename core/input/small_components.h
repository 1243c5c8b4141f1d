// Crumbs: connected parts of a soup that are small against the tolerance.
#pragma once

#include "base/run_control.h"
#include "input/triangle_soup.h"

#include <cstddef>

namespace isoscope {

/// What is left of a soup, and what went.
struct SoupWithoutCrumbs {
  TriangleSoup soup; ///< the points of its triangles, in their order
  std::size_t components = 0, dropped_components = 0, dropped_triangles = 0;
};

/// Leaves out the connected components whose bounding box has a longest edge below `size`. Triangles are
/// connected where they share a vertex or one of the same coordinates. Meaningless once the control is
/// cancelled.
SoupWithoutCrumbs drop_small_components(const TriangleSoup& soup, double size, const RunControl& control);

/// The parts of a mesh whose bounding box has a longest edge below a limit.
struct SmallParts {
  std::size_t components = 0, vertices = 0;
};

/// Of components connected by shared vertices.
SmallParts count_small_parts(const TriangleMesh& mesh, double size);

} // namespace isoscope
