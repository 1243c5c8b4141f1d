// Checks a triangulation from scratch: orientation, neighbours, links, sample assignment; for tests and
// "check everything".
#pragma once

#include "mesh/complex.h"
#include "mesh/sample_sets.h"

#include <span>
#include <string>
#include <vector>

namespace isoscope {

/// One thing found wrong, with its place.
struct Defect {
  std::string what;
  TetId tet;
};

/// Exact positive orientation of every tetrahedron, symmetric neighbours that share their facet, one closed
/// shell on the hull.
std::vector<Defect> check_complex(const Complex& complex);
/// Every tetrahedron's circumball is empty of vertices of its neighbours (exact, locally Delaunay).
std::vector<Defect> check_delaunay(const Complex& complex);
/// Every sample is in the tetrahedron that an exhaustive search gives.
std::vector<Defect> check_samples(const Complex& complex, const SampleSets& sets,
                                  std::span<const Vec3> positions);

} // namespace isoscope
