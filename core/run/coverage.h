// What of an input a mesh leaves behind: whether every point of the input is near enough to it, and where
// not.
#pragma once

#include "base/run_control.h"
#include "run/reverse_distance.h"
#include "tolerance/closest_point.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A connected part of the input that is farther from the mesh than the limit.
struct UncoveredPlace {
  Vec3 point;          ///< its farthest point that was found
  double distance = 0; ///< of it to the mesh, absolute
  double size = 0;     ///< longest edge of the bounding box of the part, absolute
};

struct Coverage {
  enum class Verdict : std::uint8_t {
    covered,   ///< proven: every point of the input is within the limit of the mesh
    uncovered, ///< proven: `places` are not
    undecided  ///< neither within the pieces that a facet may be cut into
  };
  Verdict verdict = Verdict::undecided;
  std::vector<UncoveredPlace> places; ///< farthest first, at most most_uncovered_places
  std::size_t count = 0;              ///< of all of them
};
constexpr std::size_t most_uncovered_places = 10;

/// Judges the input by `limit` (> 0, absolute); `bounds`: what is known of its distance to the mesh. Places
/// that are nearer to each other than about `resolution` (> 0, absolute) count as one. The same on any number
/// of threads; undecided when abandoned.
Coverage judge_coverage(const ClosestPointIndex& input, const ClosestPointIndex& mesh,
                        const DistanceBounds& bounds, double limit, double resolution,
                        const RunControl& control);

} // namespace isoscope
