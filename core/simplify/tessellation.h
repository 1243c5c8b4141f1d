// Mutual tessellation: the zero set becomes facets of T, and every tetrahedron gets its side (§2.4.2).
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "mesh/complex.h"

namespace isoscope {

/// The delta that splits every edge of T with ends of different labels at its zero, one edge after another in
/// ascending order of (end of the smaller label, other end), and labels all tetrahedra. Where three labels or
/// more meet, tetrahedra and then their facets get a vertex inside first (§4.2, core/README.md, N3). Each
/// split is conformal, so neighbours agree on the diagonals of quads. Zeros are representable on the grid of
/// S. Where one is not, and exact orientations say that its rounding turns a tetrahedron over, the place
/// beside it is taken that turns none; fails with unsupported where the digits of the coordinates leave no
/// such place.
Result<Delta> mutual_tessellation(const Complex& complex);

/// The delta by which Z leaves T: its facets become free, all tetrahedra and the vertices off Z go.
Delta departure(const Complex& complex);

/// The delta by which Z begins outside of T, as a mesh: from nothing.
Delta free_start(const TriangleMesh& mesh);

} // namespace isoscope
