// How near to the limit an edge of the border is: the mean of (d/δ)^12 over samples of it, as far from the
// rim, and of the rim, as far from it.
#pragma once

#include "improve/facet_complex.h"
#include "improve/facet_energy.h"
#include "tolerance/border_gate.h"

#include <span>

namespace isoscope {

/// d of one sample, and how it grows as the first end of the edge moves by Δ: weight · direction · Δ.
struct BorderSample {
  double distance = 0, weight = 0;
  Vec3 direction;
};
/// A sample of the rim and its nearest point on the edge.
BorderSample sample_of_rim(Vec3 rim, const Segment3& edge);
/// Samples of the edge, a δ apart or nearer.
int border_steps(const Segment3& edge, double delta);
BorderSample sample_of_border(const BorderGate& gate, const Segment3& edge, double t);

/// Samples and judges the border edge that begins at v.
void measure_border(const InputSurface& input, FacetComplex& complex, std::uint32_t v);
/// Gives each sample of the rim that the two border edges at v hold to the nearer one, and measures both,
/// which are then unproven. v's star must be complete.
void measure_border_at(const InputSurface& input, FacetComplex& complex, std::uint32_t v);
/// The samples of the rim that border edges at these vertices hold.
std::vector<Vec3> rim_around(const FacetComplex& complex, std::span<const std::uint32_t> vertices);

} // namespace isoscope
