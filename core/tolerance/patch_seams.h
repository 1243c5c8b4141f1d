// Patches of an open surface that lie side by side: along their seams, which Ω closes, they are to run one
// way.
#pragma once

#include "tolerance/closest_point.h"
#include "tolerance/welded_mesh.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// Turns whole patches, which are triangles joined across edges of two. Pieces of their borders that face
/// each other within `boundary` (δ') vote by their length and direction; seams of clear votes are followed in
/// the order of their weight, and of what they join the larger part of the area stays as it is. `turns`: as
/// in PatchTurns.
void turn_along_seams(const ClosestPointIndex& index, const WeldedMesh& mesh,
                      const std::vector<EdgeUse>& uses, double boundary, std::vector<std::int8_t>& turns);

} // namespace isoscope
