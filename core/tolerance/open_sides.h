// The sides of open surfaces: near to them the orientation tells, off their rim (§4.1).
#pragma once

#include "tolerance/facet_certificate.h"
#include "tolerance/pseudo_normals.h"
#include "tolerance/rim.h"
#include "tolerance/sample_grid.h"
#include "tolerance/weighted_points.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace isoscope {

/// A place of ∂Ω' and the side that it is on.
struct SideVote {
  Vec3 point;
  std::int8_t side;
};

/// Sides of the components of Ω' that do not separate space. A point whose nearest place of the input is on
/// the open rim has none. Const and thread-safe.
class OpenSides {
 public:
  /// Z is asked for its side as far as so many δ from an open surface; beyond it may be what it likes.
  static constexpr double reach = 2;

  /// `component`: by triangle; `open`: by component. `turns`: how the triangles run, as in PseudoNormals.
  /// Of no use once the control is cancelled.
  OpenSides(std::shared_ptr<const ClosestPointIndex> index, std::vector<std::uint32_t> component,
            std::vector<std::uint8_t> open, std::span<const std::int8_t> turns, double boundary,
            const RunControl& control);

  /// Of what has no triangles that are joined: the side of a point is that of the nearest of the samples,
  /// which are given by side, -1 first, some of each. `rim`: where both meet, right to `rim_margin` only.
  OpenSides(std::shared_ptr<const ToleranceField> field, std::vector<std::uint32_t> component,
            std::vector<std::uint8_t> open, const std::array<std::vector<Vec3>, 2>& samples, Rim rim,
            double rim_margin, double boundary);

  /// The same with a rim of which more is open, and where near to some places their sides are known better
  /// than by normals. `vote_reach`: how near.
  OpenSides settled(Rim rim, std::vector<SideVote> votes, double vote_reach) const;

  const Rim& rim() const { return rim_; }
  /// Whether a triangle is part of an open surface.
  bool is_open(TriangleId t) const { return open_[component_[t.index()]] != 0; }
  bool is_open_component(std::uint32_t component) const { return open_[component] != 0; }
  /// Whether all components are.
  bool all_open() const;
  /// Whether the nearest place of the input is on the open rim.
  bool is_over_rim(Vec3 p, const ClosestPoint& closest) const {
    return rim_.is_nearest(p, rim_reach(p, closest));
  }
  /// Whether the nearest place of the input is on the open rim, or nearly so: where the rim is farther by no
  /// more than δ'/500, either may be the nearest a little further on. Folds and teeth shorter than Ω is thick
  /// put them side by side.
  bool is_by_wall(Vec3 p, const ClosestPoint& closest) const {
    return is_open(closest.triangle) && rim_.is_nearest(p, rim_reach(p, closest) + wall_margin_);
  }
  /// The side of a point near an open surface: ±1, or 0 over its rim.
  int side(Vec3 p, const ClosestPoint& closest) const;
  /// What a piece of a facet beyond Ω counts for before Z has been cut: nothing over the rim and far away
  /// from open surfaces.
  PieceVerdict judge_outside(const Triangle3& piece, Vec3 center, const ClosestPoint& closest, double radius,
                             double delta) const;
  /// Whether samples tell the sides, and balls found the rim.
  bool by_samples() const { return !index_; }
  /// Where they do, places of ∂Ω' on both sides of a place of the input, -1 first, the nearest of those that
  /// are known.
  std::array<Vec3, 2> places_beside(Vec3 p) const;
  std::size_t memory_bytes() const;

 private:
  std::shared_ptr<const ToleranceField> field_;
  std::shared_ptr<const ClosestPointIndex> index_;                   ///< the same, of sheets of triangles
  std::array<std::shared_ptr<const WeightedPointIndex>, 2> samples_; ///< by side, then
  std::vector<std::uint32_t> component_;
  std::vector<std::uint8_t> open_;
  double boundary_;    ///< δ'
  double wall_margin_; ///< of what is by the wall
  double rim_margin_ = 0;
  PseudoNormals normals_;
  Rim rim_;
  std::vector<SideVote> votes_;
  std::shared_ptr<const SampleGrid> vote_grid_;
  double vote_reach_ = 0;

  int vote_near(Vec3 p) const;
  int side_by_samples(Vec3 p, const ClosestPoint& closest) const;
  double rim_reach(Vec3 p, const ClosestPoint& closest) const;
};

} // namespace isoscope
