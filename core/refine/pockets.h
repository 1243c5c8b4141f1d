// Components of Z that no sample asked for (condition 4).
#pragma once

#include "mesh/complex.h"

#include <vector>

namespace isoscope {

/// Vertices of one label that are joined by edges of T, none of which is a sample, a witness or a corner of
/// the box, and which one component of Z alone, a sphere, parts from the rest of T: given the other label
/// that component is gone. Those of components with fewer vertices of Z first. Of two labels only.
std::vector<std::vector<VertexId>> find_pockets(const Complex& complex);

} // namespace isoscope
