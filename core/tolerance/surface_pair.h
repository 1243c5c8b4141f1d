// Two closed surfaces, one inside the other, as the walls of a volume.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "tolerance/closest_point.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace isoscope {

/// Walls that were found to bound a volume: the outer surface's triangles come first, and all are oriented so
/// that their front is where the volume is not.
struct SurfacePair {
  TriangleSoup walls;
  std::shared_ptr<const ClosestPointIndex> index; ///< of the walls
  std::size_t outer = 0;                          ///< triangles of the outer surface
  std::vector<std::uint32_t> component;           ///< of the volume, by triangle
  std::size_t components = 0;
  std::vector<Vec3> seeds; ///< a point of each connected part of the walls
};

/// Judges two surfaces, which may consist of several parts and have cavities. Fails with bad_input, naming
/// the place, where one of them is open or meets itself, where they touch or cross, where the inner one is
/// not inside the outer one, and where a part of the volume has walls of one of them only.
Result<SurfacePair> join_surfaces(const TriangleSoup& outer, const TriangleSoup& inner,
                                  const RunControl& control);

} // namespace isoscope
