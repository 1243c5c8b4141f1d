// Small hand-made states in which Z is embedded in T or free of it.
#pragma once

#include "questions/snapshot.h"

namespace isoscope::testing {

/// A facet of Z in the plane z = 0 between two tetrahedra: vertices 0, 1, 2 on it, 3 above (outer), 4 below
/// (inner).
StateSnapshot embedded_facet();
/// The surface of a tetrahedron with the corners 0 to 3, without T; facet i is opposite corner i.
StateSnapshot free_tetrahedron();

} // namespace isoscope::testing
