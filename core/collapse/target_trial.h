// What the strategies of a target search share: they ask the judge, and keep what it said.
#pragma once

#include "collapse/target_search.h"

#include <vector>

namespace isoscope {

/// One search in progress.
class TargetTrial {
 public:
  TargetTrial(const Kernel& kernel, const CollapseCost& cost, const TargetJudge& judge, bool record)
      : kernel_(kernel), cost_(cost), judge_(judge), record_(record) {}
  const CollapseCost& cost() const { return cost_; }
  const Kernel& kernel() const { return kernel_; }

  /// Judges x, which is in the kernel, and takes it when it passes.
  TargetVerdict judge(Vec3 x, double cost, Reason found_by);
  /// Whether x may be a target as far as is known: strictly inside the kernel and outside every Ψ met so far.
  bool plausible(Vec3 x) const;
  /// Whether one Ψ holds the whole box.
  bool invalid(const Box3& box) const;

  bool found() const { return result_.target.has_value(); }
  double found_cost() const { return result_.cost; }
  std::uint32_t tried() const { return result_.tried; }
  void visit(const OctreeCell& cell) {
    if (record_) result_.cells.push_back(cell);
  }
  TargetSearchResult take();

 private:
  const Kernel& kernel_;
  const CollapseCost& cost_;
  const TargetJudge& judge_;
  bool record_;
  std::vector<InvalidRegion> invalid_;
  double rejected_cost_ = Box3::inf;
  TargetSearchResult result_;
};

} // namespace isoscope
