// States by slot, with counts and the ordered set of violated slots kept in step.
#include "refine/checklist.h"

#include <algorithm>

namespace isoscope {

void Checklist::set(TetId t, State state) {
  if (t.index() >= states_.size()) states_.resize(t.index() + 1, State::absent);
  State& slot = states_[t.index()];
  if (slot == state) return;
  if (slot == State::violated) violated_.erase(t);
  if (slot == State::exhausted) --exhausted_;
  if (slot == State::undecided) --undecided_;
  slot = state;
  if (state == State::violated) violated_.insert(t);
  if (state == State::exhausted) ++exhausted_;
  if (state == State::undecided) ++undecided_;
  if (state == State::pending) pending_.push_back(t);
}

void Checklist::forget(TetId t) {
  if (t.index() < states_.size()) set(t, State::absent);
}

void Checklist::add(TetId t) {
  set(t, State::pending);
}

void Checklist::clear() {
  *this = {};
}

const std::vector<TetId>& Checklist::pending() {
  std::sort(pending_.begin(), pending_.end());
  pending_.erase(std::unique(pending_.begin(), pending_.end()), pending_.end());
  std::erase_if(pending_, [this](TetId t) { return state(t) != State::pending; });
  return pending_;
}

} // namespace isoscope
