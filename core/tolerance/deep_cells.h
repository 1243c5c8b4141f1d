// What the octree shows of {d > δ}: cells in groups, and climbs from the input that come to one.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"
#include "tolerance/field.h"
#include "tolerance/regions.h"

#include <vector>

namespace isoscope {

/// The OUT cells whose centres lie beyond δ and within a box, with a union-find across faces. The octree must
/// outlive it and stay as it is.
class DeepCells {
 public:
  using CellIndex = Regions::CellIndex;
  static constexpr Box3 everywhere{{-Box3::inf, -Box3::inf, -Box3::inf}, {Box3::inf, Box3::inf, Box3::inf}};

  /// Of no use once the control is cancelled.
  DeepCells(const Regions& octree, double delta, const Box3& within, const RunControl& control);

  bool deep(CellIndex i) const {
    return octree_.kind(i) == Regions::Kind::out && static_cast<double>(octree_.distance(i)) > delta_ &&
           holds(octree_.center(octree_.cell(i)));
  }
  /// Whether p lies in the box.
  bool holds(Vec3 p) const { return within_.meets({p, p}); }
  /// Whether p lies in the ball about the centre of its cell that holds nothing of Ω.
  bool joined(Vec3 p) const;
  /// The smallest cell of the group of a deep one.
  CellIndex group(CellIndex i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  /// The deepest cell of each group, by its smallest cell.
  std::vector<CellIndex> deepest(const RunControl& control) const;

 private:
  const Regions& octree_;
  double delta_;
  Box3 within_;
  std::vector<CellIndex> parent_;

  void unite(CellIndex a, CellIndex b);
};

/// Climbs from a point beyond δ, with the closest one to it, by balls outside of Ω; true when it comes to
/// where a group of cells is, else `p` is the farthest point reached in their box. `depth`: φ there.
bool climb(const ToleranceField& field, const DeepCells& cells, double delta, ClosestPoint at, Vec3& p,
           double& depth);

} // namespace isoscope
