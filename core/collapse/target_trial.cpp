// Verdicts become Ψ, the record, and the reason to name when nothing passes.
#include "collapse/target_trial.h"

#include <algorithm>
#include <utility>

namespace isoscope {

TargetVerdict TargetTrial::judge(Vec3 x, double cost, Reason found_by) {
  TargetVerdict verdict = judge_(x);
  ++result_.tried;
  if (record_) {
    result_.candidates.push_back(
        {x, cost, found_by, verdict.reason, verdict.value, verdict.limit, verdict.witness});
  }
  if (verdict.reason == Reason::none) {
    result_.target = x;
    result_.cost = cost;
    result_.found_by = found_by;
    return verdict;
  }
  if (verdict.invalid && !verdict.invalid->empty()) invalid_.push_back(*verdict.invalid);
  if (cost < rejected_cost_) {
    rejected_cost_ = cost;
    result_.last_rejection = verdict;
    result_.rejected_point = x;
  }
  return verdict;
}

bool TargetTrial::plausible(Vec3 x) const {
  return std::none_of(invalid_.begin(), invalid_.end(),
                      [x](const InvalidRegion& r) { return r.contains(x); }) &&
         kernel_.contains(x);
}

bool TargetTrial::invalid(const Box3& box) const {
  return std::any_of(invalid_.begin(), invalid_.end(),
                     [&box](const InvalidRegion& r) { return r.contains_box(box); });
}

TargetSearchResult TargetTrial::take() {
  if (found()) result_.last_rejection = {};
  if (result_.tried == 0) result_.last_rejection.reason = Reason::no_candidate;
  if (record_) result_.invalid_regions = std::move(invalid_);
  return std::move(result_);
}

} // namespace isoscope
