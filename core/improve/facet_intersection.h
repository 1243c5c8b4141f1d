// Exact test whether two facets meet in more than the vertices they share.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstdint>

namespace isoscope {

/// A facet by position and by vertex id: what is shared is known from the ids.
struct IndexedTriangle {
  Triangle3 points;
  std::array<std::uint32_t, 3> ids;
};

/// Whether the triangles have a point in common that no shared vertex or edge accounts for. Exact. Facets
/// with the same three vertices always do.
bool intersect_properly(const IndexedTriangle& a, const IndexedTriangle& b);
/// Whether the corners lie on one line. Exact.
bool is_degenerate(const Triangle3& t);

} // namespace isoscope
