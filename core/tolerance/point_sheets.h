// Sheets among points: parts that enclose nothing, with their sides and their rim (§4.1).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace isoscope {

/// What was found of the sheets.
struct PointSheets {
  std::shared_ptr<const OpenSides> sides;
  double gamma = 0;
  std::size_t samples = 0, boundary_samples = 0; ///< of the test, and those of them that are B
};

/// Samples ∂Ω' densely, tells the sides of its sheets by balls of radius γδ' and finds the curves where they
/// meet. `sheets`: a 1 by component of Ω' for those that are sheets, some. `gammas`: tried in their order.
/// Fails with open_surface, naming a place, with what the first of them comes to, where none gives each sheet
/// two sides and as many curves as Ω' can have, by its Euler characteristic. Of no use once the control is
/// cancelled.
Result<PointSheets> find_point_sheets(ToleranceVolume& volume, const std::vector<std::uint8_t>& sheets,
                                      std::span<const double> gammas, const RunControl& control);

} // namespace isoscope
