// What a finished mesh is as a surface, whatever its geometry.
#pragma once

#include "run/certificate.h"

#include <cstdint>
#include <functional>
#include <string>

namespace isoscope {

/// Closedness, orientation, single fans, components, loops and χ. `open`: a border is allowed. Where `counts`
/// is given, the mesh is a part of a larger one, with all facets at the vertices that it counts: those are
/// judged, with the edges and facets whose lowest vertex they are, so that the χ of parts that count each
/// vertex once add up to that of all. Components and loops are not told then.
void check_connectivity(const TriangleMesh& mesh, bool open, Certificate& c,
                        const std::function<bool(std::uint32_t)>& counts = {});
/// The same for a mesh between several rooms, region by region.
void check_regions(const TriangleMesh& mesh, Certificate& c);

/// "room 2".
std::string name_of_region(int label);

} // namespace isoscope
