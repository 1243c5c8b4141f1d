// What is on both sides of the walls of a soup, whose inside nothing else tells.
#pragma once

#include "base/ids.h"
#include "base/run_control.h"
#include "tolerance/solid_angles.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// A place on a triangle of the input.
struct WallProbe {
  TriangleId triangle;
  Vec3 point;
};
/// Places about 2 δ apart, at least one in each triangle, but not many more than 100,000.
std::vector<WallProbe> probes_on_walls(const ToleranceVolume& volume);

/// What lies in front of a wall and behind it, just outside of Ω'.
struct WallNeighbours {
  std::array<Vec3, 2> places;
  std::array<RegionId, 2> regions; ///< invalid where Ω' is as wide there
  bool parted = false;             ///< an odd number of walls is between the two places

  bool told() const { return regions[0].valid() && regions[1].valid(); }
  /// Whether the wall parts a region from itself: of an open sheet, not of what is thin.
  bool ends_in_the_open() const { return told() && regions[0] == regions[1] && parted; }
};
WallNeighbours neighbours_of_wall(const ToleranceVolume& volume, const WallProbe& probe);

/// Solid angles by which the input tells the sides, though it does not close: seen from in front of its walls
/// and from behind them, it winds a whole number of times, the same as around the region there, and not
/// everywhere alike. Loose triangles are turned where rays say so. Null where it does not: open surfaces,
/// walls that stand out, rooms that share walls.
std::shared_ptr<const SolidAngles> find_clear_windings(const ToleranceVolume& volume,
                                                       const RunControl& control);

/// Labels of all regions, +1 and -1, such that those that walls part differ and others do not, as where what
/// is thin lies between them; the unbounded one has +1. Nothing where there are none: walls that end in the
/// open, or rooms that share walls. Of no use once the control is cancelled.
std::optional<std::vector<int>> label_by_walls(const ToleranceVolume& volume, const RunControl& control);

} // namespace isoscope
