// The queue of collapses and its batches.
#include "improve/surface_collapses.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "improve/patch_claims.h"

#include <algorithm>
#include <queue>

namespace isoscope {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct Entry {
  double cost = 0;
  std::uint32_t a = 0, b = 0; ///< a < b
  std::uint32_t stamp = 0;    ///< commits when the cost was computed
  Vec3 target;
  /// Cheapest first; ties by vertex.
  friend bool operator<(const Entry& x, const Entry& y) {
    return std::tuple(x.cost, x.a, x.b, x.stamp) > std::tuple(y.cost, y.a, y.b, y.stamp);
  }
};

/// Whether an attempt failed by so little that relaxation may make up for it.
bool is_close(const Refusal& refusal) {
  constexpr double little = 0.04; ///< of the limit
  return refusal.reason != Reason::stays_above || refusal.value <= (1 + little) * refusal.limit;
}

/// Attempts with repair that are made side by side, wherever they are: most of them fail, so that few of
/// those that would do come too late.
constexpr std::size_t repairs_at_once = 8;

/// Targets begin at the best of an edge's middle and ends. Of 5,062 on elephant, fandisk and joint at 1 %
/// that began farther away than this many times the limit one came below it.
constexpr double hopeless = 3;

/// An entry under evaluation.
struct Attempt {
  Entry entry;
  SurfacePatch patch;
  PatchVerdict verdict;
};

class Round {
 public:
  Round(LiveSurface& surface, const SurfaceRules& rules, const CollapseRoundOptions& options,
        FailedEdges& failed, const RunControl& control, ImproverObserver& observer)
      : surface_(surface), rules_(rules), options_(options), failed_(failed), control_(control),
        observer_(observer), placement_(options.placement), claims_(surface.complex().points.size()) {
    placement_.farthest_start = hopeless * options.cost_limit;
  }

  CollapseRoundFigures run() {
    if (options_.most_attempts > 0) push_all();
    while (!queue_.empty() && figures_.attempts < options_.most_attempts &&
           in_vain_ < options_.most_in_vain && !figures_.stopped && !control_.cancelled()) {
      gather();
      const bool complete =
          parallel_until(attempts_.size(), 1, control_, [&](std::size_t i) { evaluate(attempts_[i]); });
      if (!complete) break;
      // Failures first: they are told of the surface that they were judged on, before others change it.
      if (with_repair())
        std::stable_partition(attempts_.begin(), attempts_.end(),
                              [](const Attempt& attempt) { return !attempt.verdict.accepted(); });
      for (const Attempt& attempt : attempts_)
        if (!figures_.stopped) settle(attempt);
      push(stale_);
    }
    return figures_;
  }

 private:
  const FacetComplex& complex() const { return surface_.complex(); }
  void push_all();
  void push(std::vector<Edge>& edges);
  void gather();
  bool is_current(const Entry& e) const {
    return e.stamp >= std::max(surface_.stamp(e.a), surface_.stamp(e.b));
  }
  bool failed_before(std::uint32_t a, std::uint32_t b) const;
  ImproverVerdict verdict_on(std::uint32_t a, std::uint32_t b) const;
  void refuse(const ImproverVerdict& verdict);
  bool with_repair() const { return options_.repair.sweeps > 0; }
  std::optional<SurfacePatch> take(const Entry& e);
  /// Puts an attempt that came too late back into the queue.
  void try_again(const Entry& e);
  void evaluate(Attempt& attempt) const;
  void settle(const Attempt& attempt);

  LiveSurface& surface_;
  const SurfaceRules& rules_;
  const CollapseRoundOptions& options_;
  FailedEdges& failed_;
  const RunControl& control_;
  ImproverObserver& observer_;
  PlacementEffort placement_;
  std::priority_queue<Entry> queue_;
  std::vector<Attempt> attempts_;
  std::vector<Edge> stale_; ///< edges whose cost has to be computed before the next batch
  PatchClaims claims_;
  CollapseRoundFigures figures_;
  std::size_t in_vain_ = 0; ///< tries that failed since the last collapse
};

void Round::push_all() {
  std::vector<Edge> edges = complex().edges();
  push(edges);
}

void Round::push(std::vector<Edge>& edges) {
  sort_unique(edges);
  std::vector<std::optional<CollapseCandidate>> candidates(edges.size());
  std::vector<Refusal> refusals(edges.size()); // by T
  parallel_until(edges.size(), 4, control_, [&](std::size_t i) {
    const auto [a, b] = edges[i];
    if (surface_.frozen(a) || surface_.frozen(b) || !complex().has_edge(a, b)) return;
    Kernel kernel;
    if (surface_.embedding() != nullptr) {
      refusals[i] = surface_.embedding()->check_edge(a, b, kernel);
      if (!refusals[i].accepted()) return;
    }
    candidates[i] = collapse_candidate(*rules_.input, complex(), a, b, placement_,
                                       surface_.embedding() != nullptr ? &kernel : nullptr);
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b] = edges[i];
    if (candidates[i] && candidates[i]->cost <= options_.cost_limit)
      queue_.push({candidates[i]->cost, a, b, surface_.commits(), candidates[i]->target});
    if (!refusals[i].accepted() && !failed_before(a, b)) {
      ImproverVerdict verdict = verdict_on(a, b);
      static_cast<Refusal&>(verdict) = refusals[i];
      refuse(verdict);
    }
  }
  edges.clear();
}

bool Round::failed_before(std::uint32_t a, std::uint32_t b) const {
  const Failure* failure = failed_.find(a, b);
  if (failure == nullptr) return false;
  const int rings = options_.rings > 0 ? std::min(options_.rings, 2) : 1;
  for (const std::uint32_t v : vertices_around(complex(), {a, b}, rings))
    if ((failure->close ? surface_.stamp(v) : surface_.collapse_stamp(v)) > failure->time) return false;
  return true;
}

void Round::gather() {
  attempts_.clear();
  claims_.begin_batch();
  const std::size_t size =
      with_repair() ? repairs_at_once : std::clamp<std::size_t>(surface_.vertex_count() / 32, 1, most_batch);
  std::vector<Entry> aside;
  for (std::size_t looked = 0; looked < most_looked_at && !queue_.empty(); ++looked) {
    if (attempts_.size() + stale_.size() >= size) break;
    const Entry e = queue_.top();
    queue_.pop();
    if (!complex().alive_vertex(e.a) || !complex().alive_vertex(e.b) || !complex().has_edge(e.a, e.b))
      continue;
    if (!is_current(e)) {
      stale_.emplace_back(e.a, e.b);
      continue;
    }
    if (failed_before(e.a, e.b)) continue;
    if (auto patch = take(e)) {
      attempts_.push_back({e, std::move(*patch), {}});
    } else {
      aside.push_back(e);
    }
  }
  for (const Entry& e : aside) queue_.push(e);
}

std::optional<SurfacePatch> Round::take(const Entry& e) {
  if (!with_repair()) return claims_.take(surface_, e.a, e.b, options_.rings);
  return surface_.patch(vertices_around(complex(), {e.a, e.b}, options_.rings));
}

void Round::try_again(const Entry& e) {
  if (is_current(e))
    queue_.push(e);
  else
    stale_.emplace_back(e.a, e.b);
}

void Round::evaluate(Attempt& attempt) const {
  SurfacePatch& patch = attempt.patch;
  attempt.verdict =
      collapse_with_repair(rules_, patch, patch.local_vertex(attempt.entry.a),
                           patch.local_vertex(attempt.entry.b), attempt.entry.target, options_.repair);
}

ImproverVerdict Round::verdict_on(std::uint32_t a, std::uint32_t b) const {
  ImproverVerdict verdict;
  verdict.kind = with_repair() ? EventKind::repair : EventKind::collapse;
  verdict.a = a;
  verdict.b = b;
  return verdict;
}

void Round::refuse(const ImproverVerdict& verdict) {
  failed_.add(verdict.a, verdict.b, {surface_.commits(), is_close(verdict)});
  figures_.stopped = !observer_.rejected(verdict) || figures_.stopped;
}

void Round::settle(const Attempt& attempt) {
  ++figures_.attempts;
  ++in_vain_;
  const Entry& e = attempt.entry;
  if (attempt.verdict.accepted()) {
    if (!complex().has_edge(e.a, e.b)) return;
    if (!surface_.up_to_date(attempt.patch)) return try_again(e);
  }
  ImproverVerdict verdict = verdict_on(e.a, e.b);
  verdict.target = e.target;
  verdict.cost = e.cost;
  verdict.sweeps = attempt.verdict.sweeps;
  verdict.moved = attempt.verdict.moved;
  verdict.flipped = attempt.verdict.flipped;
  static_cast<Refusal&>(verdict) =
      attempt.verdict.accepted() ? surface_.check(attempt.patch) : Refusal(attempt.verdict);
  if (!verdict.accepted()) {
    if (attempt.verdict.facet) verdict.facet = attempt.patch.surface_corners(*attempt.verdict.facet);
    refuse(verdict);
    return;
  }
  verdict.limit = rules_.input->delta();
  verdict.value = attempt.patch.largest_distance(verdict.limit);
  const SurfaceChange change = surface_.commit(attempt.patch, verdict.kind);
  ++figures_.collapses;
  in_vain_ = 0;
  failed_.erase(e.a, e.b);
  for (const std::uint32_t v : complex().neighbors(e.a))
    stale_.emplace_back(std::min(v, e.a), std::max(v, e.a));
  figures_.stopped = !observer_.accepted(change, verdict);
}

} // namespace

CollapseRoundFigures collapse_round(LiveSurface& surface, const SurfaceRules& rules,
                                    const CollapseRoundOptions& options, FailedEdges& failed,
                                    const RunControl& control, ImproverObserver& observer) {
  return Round(surface, rules, options, failed, control, observer).run();
}

} // namespace isoscope
