// Runs the checks in order, cheap ones first; with full detail goes on where it could stop.
#include "collapse/collapse_evaluator.h"

#include "base/stopwatch.h"
#include "collapse/collapse_margins.h"
#include "collapse/star_classes.h"
#include "criteria/collapse_cost.h"
#include "criteria/kernel.h"
#include "criteria/link.h"
#include "mesh/strata.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace isoscope {

namespace {

using State = CheckVerdict::State;

bool eligible(EdgeKind kind, const CollapseSettings& settings) {
  if (kind == EdgeKind::other) return false;
  if (kind == settings.kind) return true;
  return settings.kind == EdgeKind::mixed && !settings.halfedge && kind == EdgeKind::zero;
}

constexpr std::array<CollapseCheck, 5> target_checks{CollapseCheck::border, CollapseCheck::classification,
                                                     CollapseCheck::containment, CollapseCheck::witness,
                                                     CollapseCheck::normals};

/// The checks behind a target, in order; remembers the outcome of each.
class Judge {
 public:
  Judge(const EdgeStar& star, const EvaluationContext& context, CollapseAttempt& attempt, bool all)
      : star_(star), context_(context), attempt_(attempt), all_(all) {}

  TargetVerdict operator()(Vec3 target) const {
    TargetVerdict first;
    for (const CollapseCheck check : target_checks) {
      if (first.reason != Reason::none && !all_) {
        attempt_.check(check) = {};
        continue;
      }
      const Stopwatch watch(all_);
      const std::optional<TargetVerdict> verdict = ask(check, target);
      if (!verdict) continue;
      CheckVerdict& out = attempt_.check(check);
      out = {verdict->reason == Reason::none ? State::passed : State::failed, verdict->value, verdict->limit,
             verdict->witness, watch.seconds()};
      if (verdict->reason != Reason::none && first.reason == Reason::none) first = *verdict;
    }
    return first;
  }
  /// What passed tells how close it came to its limit.
  void add_margins(Vec3 target) const {
    for (const CollapseCheck check : target_checks) {
      CheckVerdict& out = attempt_.check(check);
      if (out.state != State::passed) continue;
      if (const auto margin = check_margin(check, star_, target, context_)) {
        out.value = margin->value;
        out.limit = margin->limit;
        out.witness = margin->at;
      }
    }
  }
  /// Outside the kernel T would be inverted: what asks for tetrahedra is not asked.
  void facets_only(Vec3 target) const {
    for (const CollapseCheck check :
         {CollapseCheck::border, CollapseCheck::containment, CollapseCheck::normals}) {
      if (check == CollapseCheck::normals && star_.form != ZeroForm::embedded) continue;
      const Stopwatch watch;
      if (const std::optional<TargetVerdict> verdict = ask(check, target))
        attempt_.check(check) = {verdict->reason == Reason::none ? State::passed : State::failed,
                                 verdict->value, verdict->limit, verdict->witness, watch.seconds()};
    }
  }

 private:
  const EdgeStar& star_;
  const EvaluationContext& context_;
  CollapseAttempt& attempt_;
  bool all_;
  mutable std::optional<StarClasses> classes_; ///< made as they are first asked

  std::optional<TargetVerdict> ask(CollapseCheck check, Vec3 target) const {
    switch (check) {
    case CollapseCheck::border:
      return check_border(star_, target, context_.volume);
    case CollapseCheck::classification:
      if (context_.criteria.certified) return std::nullopt;
      if (!classes_) classes_.emplace(star_);
      return classes_->check(target, context_.criteria);
    case CollapseCheck::containment:
      if (!context_.criteria.certified) return std::nullopt;
      return check_containment(star_, target, context_.volume);
    case CollapseCheck::witness:
      return check_witnesses(star_, target, context_.volume);
    case CollapseCheck::normals:
      if (!context_.criteria.condition_3) return std::nullopt;
      return check_normals(star_, target, context_);
    default:
      return std::nullopt;
    }
  }
};

/// `reason`: where it is not the check's own.
void fail(CollapseAttempt& attempt, CollapseCheck check, double value = 0, double limit = 0,
          Vec3 witness = {}, Reason reason = Reason::none) {
  attempt.check(check) = {State::failed, value, limit, witness, 0};
  if (attempt.rejected == Reason::none)
    attempt.rejected = reason == Reason::none ? words(check).reason : reason;
}

void pass(CollapseAttempt& attempt, CollapseCheck check) {
  attempt.check(check).state = State::passed;
}

/// The checks that do not depend on the target. False when the evaluation can end here.
bool check_edge(const EdgeStar& star, const CollapseSettings& settings, EvaluationDetail detail,
                CollapseAttempt& attempt) {
  const bool full = detail == EvaluationDetail::full;
  attempt.a = star.a();
  attempt.b = star.b();
  attempt.kind = star.kind();
  if (eligible(attempt.kind, settings)) {
    pass(attempt, CollapseCheck::eligible);
  } else {
    fail(attempt, CollapseCheck::eligible);
    return false;
  }
  const Stopwatch link_watch(full);
  attempt.link = check_link(star, full);
  const double link_seconds = link_watch.seconds();
  if (attempt.link.holds_in_t) {
    pass(attempt, CollapseCheck::link);
  } else {
    fail(attempt, CollapseCheck::link);
    if (!full) return false;
  }
  if (attempt.kind == EdgeKind::zero || !attempt.link.holds_in_strata()) {
    if (attempt.link.holds_in_strata()) {
      pass(attempt, CollapseCheck::zero_link);
    } else {
      fail(attempt, CollapseCheck::zero_link);
      if (!full) return false;
    }
  }
  attempt.check(CollapseCheck::link).seconds = link_seconds;
  const Stopwatch kernel_watch(full);
  attempt.kernel = compute_kernel(star);
  const double kernel_seconds = kernel_watch.seconds();
  if (attempt.kernel->empty) {
    fail(attempt, CollapseCheck::kernel, attempt.kernel->inscribed_radius, 0, attempt.kernel->center);
    attempt.check(CollapseCheck::kernel).seconds = kernel_seconds;
    return false;
  }
  attempt.check(CollapseCheck::kernel) = {State::passed, attempt.kernel->inscribed_radius, 0,
                                          attempt.kernel->center, kernel_seconds};
  return true;
}

TargetSearchResult search(const EdgeStar& star, const CollapseSettings& settings, const Kernel& kernel,
                          const CollapseCost& cost, const TargetJudge& judge, TargetSearchOptions options,
                          std::span<const Vec3> samples) {
  const bool pinned = strata_of(star).pinned();
  if (settings.halfedge || pinned) {
    const std::array<Vec3, 2> ends{star.vertices[0].position, star.vertices[1].position};
    // A vertex of Γ goes to the vertex of Z: that leaves Z where it is. So does what goes to a lower stratum
    // with that stratum.
    const std::size_t allowed = settings.kind == EdgeKind::mixed || pinned ? 1 : 2;
    return search_candidates(star, kernel, cost, std::span(ends).first(allowed), Reason::halfedge, judge,
                             options);
  }
  if (settings.kind == EdgeKind::gamma) {
    return search_candidates(star, kernel, cost, samples, Reason::sample_candidate, judge, options);
  }
  return search_kernel(star, kernel, cost, judge, options);
}

} // namespace

CollapseAttempt evaluate_collapse(const EdgeStar& star, const CollapseSettings& settings,
                                  const EvaluationContext& context, EvaluationDetail detail,
                                  std::span<const Vec3> samples) {
  CollapseAttempt attempt;
  if (!check_edge(star, settings, detail, attempt)) return attempt;
  const bool full = detail == EvaluationDetail::full;
  const CollapseCost cost(star);
  attempt.optimum = cost.optimum();
  attempt.unconstrained_cost = cost(attempt.optimum);
  TargetSearchOptions options = settings.search;
  options.record = full;
  const Judge judge(star, context, attempt, full);
  const Stopwatch watch(full);
  TargetSearchResult found =
      search(star, settings, *attempt.kernel, cost, std::cref(judge), options, samples);
  attempt.tried = found.tried;
  attempt.candidates = std::move(found.candidates);
  attempt.cells = std::move(found.cells);
  attempt.invalid_regions = std::move(found.invalid_regions);
  // The checks are those of the point that the verdict names, which need not be the last one judged.
  const double search_seconds = watch.seconds();
  if (full && attempt.tried > 0) {
    const Vec3 named = found.target ? *found.target : found.rejected_point;
    judge(named);
    judge.add_margins(named);
  }
  if (found.target) {
    attempt.check(CollapseCheck::candidates) = {State::passed, static_cast<double>(found.tried), 0,
                                                *found.target, search_seconds};
    attempt.target = *found.target;
    attempt.cost = found.cost;
    attempt.found_by = found.found_by;
    return attempt;
  }
  const TargetVerdict& last = found.last_rejection;
  fail(attempt, CollapseCheck::candidates, last.value, last.limit, last.witness, last.reason);
  attempt.check(CollapseCheck::candidates).seconds = search_seconds;
  return attempt;
}

CollapseAttempt evaluate_target(const EdgeStar& star, Vec3 target, const CollapseSettings& settings,
                                const EvaluationContext& context) {
  CollapseAttempt attempt;
  if (!check_edge(star, settings, EvaluationDetail::full, attempt) && !attempt.kernel) return attempt;
  const CollapseCost cost(star);
  attempt.optimum = cost.optimum();
  attempt.unconstrained_cost = cost(attempt.optimum);
  attempt.target = target;
  attempt.cost = cost(target);
  attempt.tried = 1;
  attempt.found_by = Reason::user;
  double slack = std::numeric_limits<double>::infinity();
  for (const HalfSpace& h : attempt.kernel->half_spaces) slack = std::min(slack, h.slack(target));
  const Judge judge(star, context, attempt, true);
  if (!attempt.kernel->contains(target)) {
    fail(attempt, CollapseCheck::candidates, slack, 0, target);
    judge.facets_only(target);
    judge.add_margins(target);
    return attempt;
  }
  attempt.check(CollapseCheck::candidates) = {State::passed, slack, 0, target, 0};
  const TargetVerdict verdict = judge(target);
  judge.add_margins(target);
  if (attempt.rejected == Reason::none) attempt.rejected = verdict.reason;
  return attempt;
}

double collapse_priority(const EdgeStar& star, const CollapseSettings& settings) {
  if (!eligible(star.kind(), settings)) return std::numeric_limits<double>::infinity();
  const CollapseCost cost(star);
  if (strata_of(star).pinned()) return cost(star.vertices[0].position);
  if (settings.halfedge || settings.kind == EdgeKind::gamma) {
    return std::min(cost(star.vertices[0].position), cost(star.vertices[1].position));
  }
  return cost(cost.optimum());
}

} // namespace isoscope
