// Edges of walls along which a room touches itself: which rooms lie between (§4.2).
#pragma once

#include "base/run_control.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <vector>

namespace isoscope {

/// An edge of the input at which four walls or more meet, and a room lies between two pairs of them: what is
/// at the edge is to be of another one, which lies between one pair only, so that the first does not join
/// itself through it.
struct RoomContact {
  std::array<Vec3, 2> edge;
  int label = -1;
};

/// All of them, by edges in order. Not told where all rooms at an edge lie between two pairs, as two that
/// alternate: whichever joins itself, Z is no deformation of Ω there; nor where Ω takes in what lies between
/// two of the walls. None where there are no rooms; fewer once the control is cancelled.
std::vector<RoomContact> room_contacts(const ToleranceVolume& volume, const RunControl& control);

} // namespace isoscope
