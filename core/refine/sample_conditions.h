// Conditions 1 to 3 of §2.3: classification of S, heights, orientation. Their Steiner points are samples.
#pragma once

#include "criteria/orientation.h"
#include "refine/context.h"

namespace isoscope {

/// The sample nearest to the circumcentre, when it lies strictly inside the circumscribed ball (exact): a
/// Steiner point that is sure to destroy the tetrahedron. Invalid otherwise.
SampleId steiner_sample(const RefinementContext& context, TetId t);

/// Condition 1: every ε(s) <= 1 − α; inserts the worst sample of the queue's top tetrahedron.
class ClassificationCondition {
 public:
  explicit ClassificationCondition(RefinementContext& context) : context_(context) {}
  Turn turn();
  bool holds() const;

 private:
  RefinementContext& context_;
};

/// Condition 2: every tetrahedron that carries Z is at least 2σ/α high.
class HeightCondition {
 public:
  explicit HeightCondition(RefinementContext& context) : context_(context) { context.follow(checklist_); }
  Turn turn();
  /// As the run that is followed found it: no candidate is left for t.
  void give_up(TetId t) { checklist_.set(t, Checklist::State::exhausted); }
  std::size_t unmet() const { return checklist_.exhausted() + checklist_.violated(); }

 private:
  RefinementContext& context_;
  Checklist checklist_;
};

/// Condition 3: the function of every tetrahedron that carries Z classifies the samples nearest to its shrunk
/// copy.
class OrientationCondition {
 public:
  explicit OrientationCondition(RefinementContext& context) : context_(context) {
    context.follow(checklist_);
  }
  Turn turn();
  /// As the run that is followed found it.
  void give_up(TetId t) { checklist_.set(t, Checklist::State::exhausted); }
  std::size_t unmet() const { return checklist_.exhausted() + checklist_.violated(); }

 private:
  RefinementContext& context_;
  Checklist checklist_;
  OrientationVerdict check(TetId t) const;
  void judge_pending();
};

} // namespace isoscope
