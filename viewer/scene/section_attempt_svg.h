// The edge at hand in the vector figure of the section.
#pragma once

#include "scene/section_attempt.h"

#include <functional>
#include <string>

namespace isoscope {

/// Groups "edge-cells", "edge-kernel", "edge-psi", "edge-lines" and "edge-marks". `place`: of a point of the
/// plane on the page, millimetres.
std::string attempt_svg(const AttemptSection& section,
                        const std::function<PlanePoint(const PlanePoint&)>& place);

} // namespace isoscope
