// The one place where an input becomes a field (core/README.md, D9).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameters.h"
#include "tolerance/tolerance_volume.h"

#include <memory>

namespace isoscope {

/// What the algorithm asks of an input, and what is known of its surface.
struct FieldInput {
  std::shared_ptr<const ToleranceField> field;
  InputTopology topology; ///< with what tells the sides
};

/// The field of what was read: the distance to triangles. Of no use once the control is cancelled.
Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, const RunControl& control);

} // namespace isoscope
