// The queue of collapses and its batches.
#include "simplify/collapse_round.h"

#include "base/parallel.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <queue>

namespace isoscope {
namespace {

constexpr std::size_t most_batch = 16;
/// Entries looked at while a batch is filled: bounds what is set aside because of overlaps.
constexpr std::size_t most_looked_at = 64;

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
bool is_close(const ImproverVerdict& verdict) {
  constexpr double little = 0.04; ///< of the limit
  return verdict.reason != ImproverVerdict::Reason::distance || verdict.value <= (1 + little) * verdict.limit;
}

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
        observer_(observer), claims_(surface.complex().points.size()) {}

  CollapseRoundFigures run() {
    push_all();
    while (!queue_.empty() && !figures_.stopped && !control_.cancelled()) {
      gather();
      parallel_for(attempts_.size(), 1, [&](std::size_t i) { evaluate(attempts_[i]); });
      for (const Attempt& attempt : attempts_)
        if (!figures_.stopped) settle(attempt);
      push(stale_);
    }
    return figures_;
  }

 private:
  struct Claim {
    std::uint32_t write = 0, read = 0; ///< number of the batch that holds the vertex
  };

  const FacetComplex& complex() const { return surface_.complex(); }
  void push_all();
  void push(std::vector<Edge>& edges);
  void gather();
  bool claim(const SurfacePatch& patch);
  bool is_current(const Entry& e) const {
    return e.stamp >= std::max(surface_.stamp(e.a), surface_.stamp(e.b));
  }
  bool failed_before(const Entry& e) const;
  void evaluate(Attempt& attempt) const;
  void settle(const Attempt& attempt);

  LiveSurface& surface_;
  const SurfaceRules& rules_;
  const CollapseRoundOptions& options_;
  FailedEdges& failed_;
  const RunControl& control_;
  ImproverObserver& observer_;
  std::priority_queue<Entry> queue_;
  std::vector<Attempt> attempts_;
  std::vector<Edge> stale_; ///< edges whose cost has to be computed before the next batch
  std::vector<Claim> claims_;
  std::uint32_t batch_ = 0;
  CollapseRoundFigures figures_;
};

void Round::push_all() {
  std::vector<Edge> edges;
  for (const Facet& f : complex().facets) {
    if (!f.alive()) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (f.v[k] < f.v[(k + 1) % 3]) edges.emplace_back(f.v[k], f.v[(k + 1) % 3]);
  }
  push(edges);
}

void Round::push(std::vector<Edge>& edges) {
  sort_unique(edges);
  std::vector<std::optional<CollapseCandidate>> candidates(edges.size());
  parallel_for(edges.size(), 4, [&](std::size_t i) {
    const auto [a, b] = edges[i];
    if (control_.cancelled() || !complex().has_edge(a, b)) return;
    candidates[i] = collapse_candidate(*rules_.input, complex(), a, b, options_.placement);
  });
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (candidates[i] && candidates[i]->cost <= options_.cost_limit)
      queue_.push(
          {candidates[i]->cost, edges[i].first, edges[i].second, surface_.commits(), candidates[i]->target});
  edges.clear();
}

bool Round::failed_before(const Entry& e) const {
  const auto found = failed_.find({e.a, e.b});
  if (found == failed_.end()) return false;
  const int rings = options_.rings > 0 ? std::min(options_.rings, 2) : 1;
  for (const std::uint32_t v : vertices_around(complex(), {e.a, e.b}, rings))
    if ((found->second.close ? surface_.stamp(v) : surface_.collapse_stamp(v)) > found->second.commits)
      return false;
  return true;
}

bool Round::claim(const SurfacePatch& patch) {
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const Claim& c = claims_[patch.vertices[i]];
    if (c.write == batch_ || (patch.free[i] && c.read == batch_)) return false;
  }
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    Claim& c = claims_[patch.vertices[i]];
    c.read = batch_;
    if (patch.free[i]) c.write = batch_;
  }
  return true;
}

void Round::gather() {
  attempts_.clear();
  ++batch_;
  const std::size_t size = std::clamp<std::size_t>(surface_.vertex_count() / 32, 1, most_batch);
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
    if (failed_before(e)) continue;
    if (claims_[e.a].read == batch_ || claims_[e.b].read == batch_) {
      aside.push_back(e);
      continue;
    }
    Attempt attempt{e, take_patch(complex(), vertices_around(complex(), {e.a, e.b}, options_.rings)), {}};
    if (claim(attempt.patch)) {
      attempts_.push_back(std::move(attempt));
    } else {
      aside.push_back(e);
    }
  }
  for (const Entry& e : aside) queue_.push(e);
}

void Round::evaluate(Attempt& attempt) const {
  SurfacePatch& patch = attempt.patch;
  attempt.verdict =
      collapse_with_repair(rules_, patch, patch.local_vertex(attempt.entry.a),
                           patch.local_vertex(attempt.entry.b), attempt.entry.target, options_.repair);
}

void Round::settle(const Attempt& attempt) {
  ++figures_.attempts;
  const Entry& e = attempt.entry;
  ImproverVerdict verdict;
  verdict.kind = options_.repair.sweeps > 0 ? SurfaceChange::Kind::repair : SurfaceChange::Kind::collapse;
  verdict.a = e.a;
  verdict.b = e.b;
  verdict.target = e.target;
  verdict.cost = e.cost;
  verdict.sweeps = attempt.verdict.sweeps;
  verdict.moved = attempt.verdict.moved;
  verdict.flipped = attempt.verdict.flipped;
  PatchVerdict last = attempt.verdict;
  if (last.accepted()) last = surface_.check(attempt.patch);
  verdict.reason = last.reason;
  verdict.value = last.value;
  verdict.limit = last.limit;
  verdict.witness = last.witness;
  if (!verdict.accepted()) {
    failed_[{e.a, e.b}] = {surface_.commits(), is_close(verdict)};
    figures_.stopped = !observer_.rejected(verdict);
    return;
  }
  verdict.limit = rules_.input->delta();
  verdict.value = attempt.patch.largest_distance(verdict.limit);
  const SurfaceChange change = surface_.commit(attempt.patch, verdict.kind);
  ++figures_.collapses;
  failed_.erase({e.a, e.b});
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
