// meshoptimizer's collapse: fast, by quadrics, with an error that it aims at and does not prove.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

namespace isoscope::bench {

/// Collapses edges onto one of their ends while the estimated error stays below δ. Fails with unsupported
/// where this was built without meshoptimizer.
Result<TriangleMesh> meshoptimizer(const TriangleSoup& input, double delta);

} // namespace isoscope::bench
