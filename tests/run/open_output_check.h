// An open result against its input by brute force, with nothing of what made or proved it.
#pragma once

#include "input/triangle_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace isoscope::test {

/// What a mesh is beside its input.
struct OpenOutput {
  bool manifold = false, oriented = false, meets_itself = true;
  long euler_characteristic = 0;
  std::size_t components = 0, loops = 0;
  double facets = 0;           ///< the largest distance of a facet from the input is at most this, in δ
  double to_rim = 0;           ///< of the border from that of the input, at samples, in δ
  double from_rim = 0;         ///< the other way
  double longest_rim_edge = 0; ///< of the input, in δ
};

/// Facets are halved until the distance at their middles proves them within δ, or they are smaller than
/// δ/1000. The border of the input are the edges of one triangle, its points merged where they are the same;
/// borders are sampled at δ/20. Takes a time of facets times triangles: for small inputs.
OpenOutput check_open_output(const TriangleSoup& input, const TriangleMesh& mesh, double delta);

} // namespace isoscope::test
