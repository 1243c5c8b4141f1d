// Points with weights: φ(x) = min √(|x - b|² + w), the field of scans and of noisy soups (core/README.md,
// N1).
#pragma once

#include "base/run_control.h"
#include "tolerance/box_hierarchy.h"
#include "tolerance/field.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// A site of a weighted point set: {φ <= r} holds the ball around it of radius √(r² - weight), none where the
/// weight is r² or more.
struct WeightedPoint {
  Vec3 center;       ///< b
  double weight = 0; ///< w >= 0, a squared length
};

/// The hierarchy of ClosestPointIndex over weighted points. Every term of φ is a distance in R⁴, to (b, √w),
/// so that φ is 1-Lipschitz. Immutable after construction; all queries are thread-safe.
class WeightedPointIndex final : public ToleranceField {
 public:
  /// `area`: about that of the surface that the points are on. Once the control is cancelled, an index that
  /// finds nothing.
  WeightedPointIndex(const std::vector<WeightedPoint>& points, double area, const RunControl& control = {});

  FieldKind kind() const override { return FieldKind::points; }
  std::size_t size() const override { return sites_.size(); }
  const Box3& bounds() const override { return boxes_.bounds; }
  double area() const override { return area_; }
  std::size_t memory_bytes() const override;

  ClosestPoint closest(Vec3 p) const override;
  ClosestPoint closest_within(Vec3 p, double radius) const override;
  ClosestPoint closest_near(Vec3 p, TriangleId guess) const override;
  ClosestPoint closest_near(Vec3 p, const ClosestPoint& found, double enough) const override;
  void find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const override;
  ClosestPoint closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                            double enough = 0) const override;
  ClosestPoint at_site(Vec3 p, TriangleId site) const override;
  double convex_bound(const Triangle3& facet, TriangleId site) const override;
  Vec3 place_of(TriangleId id) const override { return site(id).center; }
  Vec3 gradient(Vec3 p, const ClosestPoint& at) const override;
  bool is_distance() const override { return !weighted_; }
  std::optional<Vec3> project(Vec3 p, const ClosestPoint& at, double r) const override;
  bool rises(Vec3 p, const ClosestPoint& at_p, Vec3 q, const ClosestPoint& at_q) const override;
  /// By balls that meet. Numbered by their smallest site.
  VolumeComponents components(double r, const RunControl& control) const override;

  const WeightedPoint& site(TriangleId id) const { return sites_[slots_[id.index()]]; }

 private:
  class Flood;
  double squared_at(Vec3 p, const WeightedPoint& s) const { return squared_length(p - s.center) + s.weight; }
  ClosestPoint search(Vec3 p, ClosestPoint best, double squared_enough = 0) const;

  /// The least weight below each child of a node, in the hierarchy's frame.
  struct alignas(16) LeastWeights {
    float of[BoxHierarchy::width];
  };
  void find_least_weights();

  BoxHierarchy boxes_;
  std::vector<WeightedPoint> sites_;  ///< by slot
  std::vector<std::uint32_t> slots_;  ///< site id -> slot
  std::vector<LeastWeights> weights_; ///< by node
  double area_ = 0;
  bool weighted_ = false; ///< some weight is above 0
};

} // namespace isoscope
