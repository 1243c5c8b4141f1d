// Whether the border of Z keeps to the rim of an open input: the Hausdorff distance of both stays within δ,
// by branch and bound (§4.1, core/README.md, N8).
#pragma once

#include "tolerance/segment_index.h"

#include <cstddef>
#include <span>
#include <vector>

namespace isoscope {

/// What was found of one change of the border.
struct BorderVerdict {
  bool proven = true;
  Vec3 witness;        ///< not proven: a point that is too far away, or where the search ended
  double distance = 0; ///< of the witness
};

/// The open rim of the input with δ. Immutable and thread-safe.
class BorderGate {
 public:
  /// `rim`: where the input ends, without parts that Ω closes. `crossed`: as below.
  BorderGate(std::vector<Segment3> rim, double delta, std::vector<Segment3> crossed = {});

  const SegmentIndex& rim() const { return rim_; }
  /// From one side of the sheet to the other before each place of the rim, -1 first: while Z passes between
  /// their ends, it is near to all of the rim.
  const SegmentIndex& crossed() const { return crossed_; }
  double delta() const { return delta_; }

  /// Whether every point of an edge is proven to be within δ of the rim.
  BorderVerdict keeps_to_rim(const Segment3& edge) const;
  /// Whether every point of the rim that is within δ of the edges `before` is proven to be within δ of those
  /// `after`, so that what the border covered of the rim stays covered. `after` may hold edges that stay.
  BorderVerdict covers_rim(std::span<const Segment3> before, std::span<const Segment3> after) const;
  /// Points of the rim at most δ / 2 apart along it, and ends of its segments where they are not closer than
  /// a quarter of that: where a placement looks at the rim.
  std::vector<Vec3> rim_samples() const;

 private:
  SegmentIndex rim_, crossed_;
  double delta_;
};

} // namespace isoscope
