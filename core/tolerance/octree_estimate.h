// What Ω takes, told from the area of the input before anything is built.
#pragma once

#include "tolerance/field.h"

namespace isoscope {

/// Of a surface that is not folded closer than δ; where it is, fewer cells do.
class OctreeEstimate {
 public:
  /// `sides_known`: regions that only cells smaller than δ' see need not be found at once.
  OctreeEstimate(const ToleranceField& field, bool sides_known)
      : area_(field.area()), sides_known_(sides_known) {}

  /// The side of the octree's main cells, in units of δ': half, and where that would take more than about 30
  /// million cells and the sides are known, one, which takes a quarter of them.
  double main_side_ratio(double boundary) const;
  /// How many cells the octree has with main cells of that side.
  double cells(double boundary) const;
  /// The least δ' whose octree and sparsest samples take no more than so many bytes.
  double fitting_boundary(double most_bytes) const;

 private:
  double area_;
  bool sides_known_;
};

} // namespace isoscope
