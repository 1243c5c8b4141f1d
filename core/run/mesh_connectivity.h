// What a finished mesh is as a surface, whatever its geometry.
#pragma once

#include "run/certificate.h"

#include <string>

namespace isoscope {

/// Closedness, orientation, single fans, components, loops and χ. `open`: a border is allowed.
void check_connectivity(const TriangleMesh& mesh, bool open, Certificate& c);
/// The same for a mesh between several rooms, region by region.
void check_regions(const TriangleMesh& mesh, Certificate& c);

/// "room 2".
std::string name_of_region(int label);

} // namespace isoscope
