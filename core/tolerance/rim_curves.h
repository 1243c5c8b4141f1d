// The rim of sheets that have no edges: where samples of both their sides meet (§4.1).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/rim.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// How near the curves are to the sites that they stand for, in units of δ': what is over the rim is told so
/// far before it.
constexpr double rim_curve_margin = 0.15;

/// The curves on ∂Ω' from which the nearest samples of both sides are equally far, on the facets that the
/// level δ' of φ has on a lattice, each led back to the sites that it goes round, with what they scatter
/// evened out over δ'/2 to each side. `labels`: by sample, ±1 around sheets, 0 elsewhere. Fails with
/// open_surface where a curve ends, naming the place. Of no use once the control is cancelled.
Result<std::vector<RimCurve>> find_rim_curves(const ToleranceVolume& volume, const BoundarySamples& samples,
                                              std::span<const std::int8_t> labels, const RunControl& control);

} // namespace isoscope
