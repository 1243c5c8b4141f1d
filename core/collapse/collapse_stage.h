// One stage of edge collapses: a queue by error, evaluations in parallel batches, commits in order (§2.4).
#pragma once

#include "collapse/collapse_evaluator.h"
#include "collapse/collapse_queue.h"
#include "collapse/live_complex.h"
#include "collapse/sample_targets.h"
#include "journal/stage_log.h"

#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Collapses edges of one kind until no one of them can be collapsed or it is told to stop. During a
/// rehearsal of the log the verdicts are those of the journal: queue and failures become what they were.
class CollapseStage {
 public:
  /// `samples` are candidate targets of ∂Γ collapses and may be null otherwise.
  CollapseStage(LiveComplex& live, const EvaluationContext& context, const CollapseSettings& settings,
                CostRing ring, const BoundarySamples* samples, StageLog& log);
  ~CollapseStage();

  /// Rounds over all eligible edges until a round brings nothing, at most `rounds`. Returns the collapses
  /// made.
  std::size_t run(int rounds);

 private:
  struct Candidate;
  std::vector<QueuedEdge> eligible_edges() const;
  std::size_t run_round();
  std::vector<Candidate> next_batch(CollapseQueue& queue);
  void evaluate(std::span<Candidate> candidates) const;
  bool commit(const Candidate& candidate, CollapseQueue& queue);
  /// Takes the verdict from the journal that is followed.
  bool follow(const Candidate& candidate, CollapseQueue& queue);
  bool carry_out(const QueuedEdge& edge, Event event, CollapseQueue& queue);
  bool rests_on_changed_border(const Candidate& candidate) const;
  void push_around(VertexId v, CollapseQueue& queue);
  double priority(VertexId a, VertexId b) const;
  std::uint32_t changed(VertexId a, VertexId b) const { return std::max(live_.changed(a), live_.changed(b)); }
  bool may_be_eligible(VertexId a, VertexId b) const;

  LiveComplex& live_;
  const EvaluationContext& context_;
  CollapseSettings settings_;
  CostRing ring_;
  StageLog& log_;
  std::optional<SampleTargets> targets_;
  FailedCollapses<VertexId> failures_;
};

} // namespace isoscope
