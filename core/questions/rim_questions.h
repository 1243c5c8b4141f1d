// What a person asks of an open surface (§4.1): why a sample is over the rim, and what became of each hole.
#pragma once

#include "questions/snapshot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// The rim of an open input; null where there is none.
const Rim* open_rim(const Scene& scene);

/// The place of an open input that is closest to a point, beside its rim.
struct RimInspection {
  Vec3 closest;           ///< of the input
  double distance = 0;    ///< to it
  bool over_rim = false;  ///< that place is on the open rim: the point is on no side
  Vec3 on_rim;            ///< the place of the open rim that is closest
  double to_rim = 0;      ///< the distance to it
  std::uint32_t loop = 0; ///< the number of its loop
  /// The border edge of the input that it lies on, by points of the input; equal where it is one of them.
  /// None where balls found the rim.
  std::optional<std::array<std::uint32_t, 2>> edge;
  bool at_vertex() const { return edge && (*edge)[0] == (*edge)[1]; }
};
/// Nothing where the input has no open rim.
std::optional<RimInspection> inspect_rim(const Scene& scene, Vec3 p);

/// What became of a hole at a step.
enum class HoleState : std::uint8_t {
  ahead, ///< Z has not been cut yet
  kept,  ///< the border of Z runs along it
  filled ///< Z goes on across it
};

/// A loop of the open rim as it is drawn.
struct LoopReport {
  RimLoop loop;
  HoleState state = HoleState::ahead;
  std::vector<Segment3> pieces;
};
/// A part of the border that Ω bridges, its pieces in a row.
struct BridgedStretch {
  double length = 0;
  Vec3 center;
  bool meets_wall = false; ///< the sheet ends on another part of the input
  std::vector<Segment3> pieces;
};
struct RimReport {
  std::vector<LoopReport> loops;       ///< by number
  std::vector<BridgedStretch> bridged; ///< the longest first
  std::size_t count(HoleState state) const;
};
/// Nothing where the input has no open rim.
std::optional<RimReport> report_rim(const StateSnapshot& state, const Scene& scene);

} // namespace isoscope
