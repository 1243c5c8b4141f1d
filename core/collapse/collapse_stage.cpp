// Rounds of a collapse stage. Batches have a fixed size, so that threads change nothing.
#include "collapse/collapse_stage.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "mesh/cost_star.h"
#include "mesh/strata.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace isoscope {

namespace {

/// Edges evaluated side by side: more would leave the order of errors, fewer would leave cores idle.
constexpr std::size_t batch_size = 16;
/// Edges looked at for one batch before it goes on with fewer.
constexpr std::size_t batch_search = 48;
constexpr std::size_t priority_grain = 64;

QueuedEdge ordered(VertexId a, VertexId b, double error, std::uint32_t time) {
  return {error, std::min(a, b), std::max(a, b), time};
}

} // namespace

struct CollapseStage::Candidate {
  QueuedEdge edge;
  EdgeStar star;
  std::vector<Vec3> samples;
  CollapseAttempt attempt;
  bool judged = false;
};

CollapseStage::CollapseStage(LiveComplex& live, const EvaluationContext& context,
                             const CollapseSettings& settings, CostRing ring, const BoundarySamples* samples,
                             StageLog& log)
    : live_(live), context_(context), settings_(settings), ring_(ring), log_(log) {
  if (samples != nullptr && settings.kind == EdgeKind::gamma && !settings.halfedge) {
    targets_.emplace(*samples);
  }
}

CollapseStage::~CollapseStage() = default;

bool CollapseStage::may_be_eligible(VertexId a, VertexId b) const {
  const Complex& c = live_.complex();
  const Vertex &va = c.vertices[a.index()], &vb = c.vertices[b.index()];
  if (va.kind == VertexKind::box || vb.kind == VertexKind::box) return false;
  switch (settings_.kind) {
  case EdgeKind::gamma:
    return va.value != 0 && va.label() == vb.label();
  case EdgeKind::zero:
    return va.value == 0 && vb.value == 0;
  case EdgeKind::mixed:
    return settings_.halfedge ? (va.value == 0) != (vb.value == 0) : va.value == 0 || vb.value == 0;
  case EdgeKind::other:
    break;
  }
  return false;
}

double CollapseStage::priority(VertexId a, VertexId b) const {
  const auto [stays, goes] = oriented_edge(live_.complex(), live_.incidence(), a, b);
  return collapse_priority(gather_cost_star(live_.complex(), live_.incidence(), stays, goes, ring_),
                           settings_);
}

std::vector<QueuedEdge> CollapseStage::eligible_edges() const {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const Tet& t : live_.complex().tets) {
    if (!t.alive()) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto [a, b] = std::minmax(t.v[i], t.v[j]);
        if (may_be_eligible(a, b) && !failures_.failed_since(a, b, changed(a, b))) edges.emplace_back(a, b);
      }
    }
  }
  sort_unique(edges);
  std::vector<QueuedEdge> queued(edges.size());
  const bool complete = parallel_until(edges.size(), priority_grain, log_.control(), [&](std::size_t i) {
    queued[i] =
        ordered(edges[i].first, edges[i].second, priority(edges[i].first, edges[i].second), live_.clock());
  });
  if (!complete) return {};
  std::erase_if(queued, [](const QueuedEdge& e) { return std::isinf(e.error); });
  return queued;
}

std::vector<CollapseStage::Candidate> CollapseStage::next_batch(CollapseQueue& queue) {
  std::vector<Candidate> batch;
  std::vector<QueuedEdge> deferred;
  std::vector<TetId> taken; ///< tetrahedra of the batch's stars, sorted
  for (std::size_t looked = 0; batch.size() < batch_size && looked < batch_search && !queue.empty();
       ++looked) {
    const QueuedEdge e = queue.pop();
    if (!live_.alive(e.a) || !live_.alive(e.b) || !live_.adjacent(e.a, e.b)) continue;
    const std::uint32_t last = changed(e.a, e.b);
    if (failures_.failed_since(e.a, e.b, last)) continue;
    if (e.time < last) {
      const double error = priority(e.a, e.b);
      if (!std::isinf(error)) queue.push(ordered(e.a, e.b, error, live_.clock()));
      continue;
    }
    const auto is_taken = [&](VertexId v) {
      const auto at = live_.incidence().tets_of(v);
      return std::any_of(at.begin(), at.end(),
                         [&](TetId t) { return std::binary_search(taken.begin(), taken.end(), t); });
    };
    if (is_taken(e.a) || is_taken(e.b)) {
      deferred.push_back(e);
      continue;
    }
    const auto [stays, goes] = oriented_edge(live_.complex(), live_.incidence(), e.a, e.b);
    Candidate candidate{e, live_.star(stays, goes, ring_), {}, {}, false};
    for (const auto& t : candidate.star.tets) taken.push_back(t.id);
    std::sort(taken.begin(), taken.end());
    batch.push_back(std::move(candidate));
  }
  for (const QueuedEdge& e : deferred) queue.push(e);
  parallel_for(batch.size(), 1, [&](std::size_t i) {
    live_.add_samples(batch[i].star);
    if (targets_) batch[i].samples = targets_->near(batch[i].star);
  });
  return batch;
}

void CollapseStage::evaluate(std::span<Candidate> candidates) const {
  parallel_until(candidates.size(), 1, log_.control(), [&](std::size_t i) {
    Candidate& c = candidates[i];
    c.judged = true;
    CollapseSettings settings = settings_;
    if (targets_) settings.search.kernel_samples = most_sample_targets;
    c.attempt = evaluate_collapse(c.star, settings, context_, EvaluationDetail::decision, c.samples);
  });
}

/// Whether the border beyond the star, on which the verdict rests, is no longer what it was when the batch
/// was begun.
bool CollapseStage::rests_on_changed_border(const Candidate& candidate) const {
  const EdgeStar& star = candidate.star;
  return !star.border_beyond.empty() &&
         live_.star(star.a(), star.b(), ring_).border_beyond != star.border_beyond;
}

bool CollapseStage::commit(const Candidate& candidate, CollapseQueue& queue) {
  const CollapseAttempt& attempt = candidate.attempt;
  Event e;
  e.vertex = attempt.a;
  e.other = attempt.b;
  e.count = attempt.tried;
  if (!attempt.possible()) {
    e.kind = EventKind::rejection;
    e.reason = attempt.rejected;
    if (const CheckVerdict* failed = attempt.first_failed()) {
      e.value = failed->value;
      e.limit = failed->limit;
      e.witness = failed->witness;
    }
    e.point = attempt.optimum;
    return carry_out(candidate.edge, e, queue);
  }
  if (rests_on_changed_border(candidate)) {
    queue.push(ordered(candidate.edge.a, candidate.edge.b, candidate.edge.error, live_.clock()));
    return false;
  }
  e.kind = EventKind::collapse;
  e.reason = attempt.found_by;
  e.point = attempt.target;
  e.witness = attempt.optimum;
  e.value = attempt.cost;
  e.limit = attempt.unconstrained_cost;
  return carry_out(candidate.edge, e, queue);
}

bool CollapseStage::follow(const Candidate& candidate, CollapseQueue& queue) {
  const Event e = log_.rehearsal()->event();
  const bool verdict = e.kind == EventKind::rejection || e.kind == EventKind::collapse;
  const QueuedEdge& edge = candidate.edge;
  if (!verdict || std::minmax(e.vertex, e.other) != std::minmax(edge.a, edge.b)) {
    log_.go_astray();
    return false;
  }
  return carry_out(edge, e, queue);
}

/// Does what the event of an edge says, and records it.
bool CollapseStage::carry_out(const QueuedEdge& edge, Event e, CollapseQueue& queue) {
  if (e.kind == EventKind::rejection) {
    failures_.add(edge.a, edge.b, {live_.clock(), false});
    log_.event(e);
    return false;
  }
  Delta delta = live_.collapse(e.vertex, e.other, e.point);
  live_.apply(delta);
  push_around(e.vertex, queue);
  log_.operation(e, std::move(delta), live_.step_figures());
  return true;
}

void CollapseStage::push_around(VertexId v, CollapseQueue& queue) {
  for (const VertexId n : live_.neighbors(v)) {
    if (!may_be_eligible(v, n)) continue;
    const double error = priority(v, n);
    if (!std::isinf(error)) queue.push(ordered(v, n, error, live_.clock()));
  }
}

std::size_t CollapseStage::run_round() {
  CollapseQueue queue;
  for (const QueuedEdge& e : eligible_edges()) queue.push(e);
  std::size_t collapses = 0;
  while (!queue.empty() && !log_.stopped()) {
    std::vector<Candidate> batch = next_batch(queue);
    if (log_.rehearsal() == nullptr) evaluate(batch);
    for (std::size_t i = 0; i < batch.size() && !log_.stopped(); ++i) {
      const bool followed = log_.rehearsal() != nullptr;
      // What was pushed back has no event: whether it was is found out.
      if (!batch[i].judged && followed && !rests_on_changed_border(batch[i])) {
        collapses += follow(batch[i], queue);
        continue;
      }
      // The rehearsal may end amidst a batch; its stars are those from before the batch.
      if (!batch[i].judged) evaluate(std::span(batch).subspan(i, followed ? 1 : batch.size() - i));
      collapses += commit(batch[i], queue);
    }
  }
  return collapses;
}

std::size_t CollapseStage::run(int rounds) {
  std::size_t collapses = 0;
  for (int round = 0; round < rounds && !log_.stopped(); ++round) {
    const std::size_t made = run_round();
    collapses += made;
    if (made == 0) break;
  }
  return collapses;
}

} // namespace isoscope
