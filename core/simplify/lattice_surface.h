// Z from signs on a body-centred cubic lattice: for inputs that are no surface themselves.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>

namespace isoscope {

/// The largest lattice that is taken, in δ: a tetrahedron of it has the diameter h, and where its corners are
/// on both sides some point of it has φ = 0, so that all of it lies inside Ω.
constexpr double coarsest_lattice = 0.95;

struct LatticeSurface {
  double edge =
      0; ///< h: the edge of the lattice's cubes, absolute; its digits are few, so that places are exact
  TriangleMesh
      mesh; ///< a closed oriented 2-manifold, free of intersections; empty where all signs are the same
};

/// Z between the points of the lattice of edge `ratio` δ, rounded down to few digits, that are inside and
/// those outside of the input. Its vertices are at sixteenths of the lattice's edges, so that every
/// coordinate is exact and facets lie in the tetrahedron that they belong to. For volumes of which the side
/// of every point is told. Fails with unsupported where more than `most_facets` would be made or the lattice
/// has too many points in a row for exact coordinates; with cancelled.
Result<LatticeSurface> lattice_surface(const ToleranceVolume& volume, double ratio, std::size_t most_facets,
                                       const RunControl& control);

} // namespace isoscope
