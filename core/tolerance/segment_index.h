// Closest points on line segments: the rim of an open surface, the border of Z.
#pragma once

#include "base/segment.h"
#include "tolerance/box_hierarchy.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace isoscope {

/// The closest point on some segments.
struct ClosestOnSegments {
  static constexpr std::uint32_t none = 0xffffffffu;
  Vec3 point;
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t segment = none;
};

/// A hierarchy over segments. Immutable; queries are thread-safe and depend on the query and the segments
/// only.
class SegmentIndex {
 public:
  explicit SegmentIndex(std::vector<Segment3> segments);
  std::span<const Segment3> segments() const { return segments_; }
  const Box3& bounds() const { return boxes_.bounds; }
  /// Nothing on no segments: the distance is infinite.
  ClosestOnSegments closest(Vec3 p) const;
  /// The segments, ascending, whose box comes within r of a point; more may be named, none is missed.
  std::vector<std::uint32_t> near(Vec3 center, double r) const;

 private:
  std::vector<Segment3> segments_;
  BoxHierarchy boxes_;
};

} // namespace isoscope
