// The one place where an input becomes a field (core/README.md, D9).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameters.h"
#include "tolerance/tolerance_volume.h"

#include <memory>
#include <string>
#include <vector>

namespace isoscope {

/// What the algorithm asks of an input, and what is known of its surface.
struct FieldInput {
  std::shared_ptr<const ToleranceField> field;
  InputTopology topology; ///< with what tells the sides
  double delta = 0;       ///< δ, where the input gives Ω; else 0
  /// The input with triangles that show it, where it has none of its own; else null.
  std::shared_ptr<const TriangleSoup> shown = nullptr;
  std::vector<std::string> notes = {}; ///< what the user should know, one sentence each
};

/// The field of what was read: the distance to triangles, or of a given volume what lies between its walls or
/// its levels. Of no use once the control is cancelled. Fails with usage and bad_input where a volume is no
/// such.
Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, const RunControl& control);

} // namespace isoscope
