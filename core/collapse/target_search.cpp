// The strategies in order of their price; each point is judged at most once, and none that is known to fail.
#include "collapse/target_search.h"

#include "collapse/kernel_walk.h"
#include "collapse/octree_search.h"
#include "collapse/target_trial.h"

#include <algorithm>
#include <utility>

namespace isoscope {

namespace {

/// How far the search stays from the kernel's facets, of the inscribed radius: flat tetrahedra leave no room
/// for later collapses.
constexpr double kernel_margin = 1e-3;
/// By how much a learnt half-space is overdone, of the inscribed radius: its own boundary is no target.
constexpr double learnt_margin = 1e-3;

std::vector<HalfSpace> shrunk(const Kernel& kernel) {
  std::vector<HalfSpace> inner = kernel.half_spaces;
  for (HalfSpace& h : inner) h.offset += kernel_margin * kernel.inscribed_radius;
  return inner;
}

/// The least error in the kernel, and under what was learnt from its failures.
void search_optimum(TargetTrial& trial, std::vector<HalfSpace> inner, int rounds) {
  Reason found_by = Reason::quadric_optimum;
  for (int round = 0; round < rounds; ++round) {
    const std::optional<Vec3> x = trial.cost().minimum(inner);
    if (!x || !trial.kernel().contains(*x)) return;
    const TargetVerdict verdict = trial.judge(*x, trial.cost()(*x), found_by);
    if (trial.found() || !verdict.learnt) return;
    HalfSpace learnt = *verdict.learnt;
    learnt.offset += learnt_margin * trial.kernel().inscribed_radius;
    // Without a cut the same point would come back.
    if (learnt.slack(*x) >= 0) return;
    inner.push_back(learnt);
    found_by = Reason::lazy_constraints;
  }
}

struct Candidate {
  double cost;
  Vec3 point;
};

void judge_in_order(TargetTrial& trial, std::vector<Candidate> candidates, Reason found_by, int most) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  int judged = 0;
  for (const Candidate& c : candidates) {
    if (trial.found() || judged == most) return;
    if (!trial.plausible(c.point)) continue;
    trial.judge(c.point, c.cost, found_by);
    ++judged;
  }
}

std::uint64_t seed_of(const EdgeStar& star) {
  const VertexId lo = std::min(star.a(), star.b()), hi = std::max(star.a(), star.b());
  return std::uint64_t{lo.value} << 32 | hi.value;
}

} // namespace

TargetSearchResult search_kernel(const EdgeStar& star, const Kernel& kernel, const CollapseCost& cost,
                                 const TargetJudge& judge, const TargetSearchOptions& options) {
  if (kernel.empty) {
    TargetSearchResult result;
    result.last_rejection.reason = Reason::kernel_empty;
    return result;
  }
  TargetTrial trial(kernel, cost, judge, options.record);
  if (options.strategy == TargetStrategy::octree) {
    search_octree(trial, options);
    return trial.take();
  }
  std::vector<HalfSpace> inner = shrunk(kernel);
  const bool constraints = options.strategy != TargetStrategy::optimum;
  search_optimum(trial, inner, constraints ? 1 + options.constraint_rounds : 1);
  if (options.strategy == TargetStrategy::sampling && !trial.found()) {
    std::vector<Candidate> candidates;
    for (const Vec3 x : walk_kernel(inner, kernel.center, options.kernel_samples, seed_of(star)))
      candidates.push_back({cost(x), x});
    judge_in_order(trial, std::move(candidates), Reason::kernel_sampling, options.kernel_samples);
  }
  return trial.take();
}

TargetSearchResult search_candidates(const EdgeStar&, const Kernel& kernel, const CollapseCost& cost,
                                     std::span<const Vec3> points, Reason found_by, const TargetJudge& judge,
                                     const TargetSearchOptions& options) {
  if (kernel.empty) {
    TargetSearchResult result;
    result.last_rejection.reason = Reason::kernel_empty;
    return result;
  }
  TargetTrial trial(kernel, cost, judge, options.record);
  std::vector<Candidate> candidates;
  for (const Vec3 x : points) {
    if (kernel.contains(x)) candidates.push_back({cost(x), x});
  }
  judge_in_order(trial, std::move(candidates), found_by, options.kernel_samples);
  return trial.take();
}

} // namespace isoscope
