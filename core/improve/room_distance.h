// How far a wall has slid away from the rooms that it lies between: Ω alone lets a room go on as a thin layer
// along the wall between two others, and its curves with it (core/README.md, N8).
#pragma once

#include "base/geometry.h"
#include "base/labels.h"
#include "criteria/nearest_sample.h"
#include "input/triangle_soup.h"

#include <cstdint>

namespace isoscope {

/// The samples of each room, and how far the walls of one may be from them.
struct RoomSamples {
  const NearestSample* samples = nullptr; ///< null where there are two sides only
  double enough = 0, reach = 0;           ///< absolute
  double delta = 0;                       ///< δ

  /// The distance to the nearest sample of a room as if it were one to the input: none up to `enough`, δ at
  /// `reach`.
  struct Distance {
    double value = 0;
    Vec3 direction; ///< its gradient
  };
  Distance at(Vec3 p, std::int8_t label) const;
};

/// For a surface between rooms. Across a wall samples are up to 2 δ and σ away, and in the corner of two
/// walls a curve at δ from both is some 3 δ from those across: 2.5 δ is enough, and 4 δ the reach, or as far
/// as the surface goes already.
RoomSamples room_samples(const TriangleMesh& surface, const NearestSample& samples, double delta);

} // namespace isoscope
