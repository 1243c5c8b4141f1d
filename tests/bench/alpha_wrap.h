// CGAL's alpha wrap: a closed surface around any soup, but no coarse one.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

namespace isoscope::bench {

/// Wraps the triangles from outside at δ/2, with balls of radius δ that do not pass: it then stays within δ
/// of the input where that is free of gaps. Fails with unsupported before CGAL 5.5, which has no wrap.
Result<TriangleMesh> alpha_wrap(const TriangleSoup& input, double delta);

} // namespace isoscope::bench
