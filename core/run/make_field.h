// The one place where an input becomes a field (core/README.md, D9).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameters.h"
#include "run/point_field.h"
#include "tolerance/tolerance_volume.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// What the algorithm asks of an input, and what is known of its surface.
struct FieldInput {
  std::shared_ptr<const ToleranceField> field;
  InputTopology topology;     ///< with what tells the sides
  MadePointField points = {}; ///< where the field is one of points
  double delta = 0;           ///< δ, where the input gives Ω; else 0
  /// The input with triangles that show it, where it has none of its own; else null.
  std::shared_ptr<const TriangleSoup> shown = nullptr;
  std::vector<std::string> notes = {}; ///< what the user should know, one sentence each
};

/// The field of what was read: the distance to triangles, the robust distance to points, or of a given volume
/// what lies between its walls or its levels. `delta`: δ, where it is known already. Of no use once the
/// control is cancelled. Fails with usage and bad_input where a volume is no such.
Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, std::optional<double> delta,
                              const RunControl& control);

} // namespace isoscope
