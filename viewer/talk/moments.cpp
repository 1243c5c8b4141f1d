// Finding the moments in a growing journal.
#include "talk/moments.h"

#include <algorithm>

namespace isoscope {
namespace {

template <class Bits, class Value> bool first_of(Bits& seen, Value value) {
  const auto at = static_cast<std::size_t>(value);
  if (seen[at]) return false;
  seen.set(at);
  return true;
}

} // namespace

void Moments::reset(std::shared_ptr<const Journal> journal) {
  *this = Moments();
  journal_ = std::move(journal);
}

// Events come by step, but for an operation's own: it shows a step later than what was decided before it.
void Moments::add(Step step, std::uint32_t event) {
  if (!all_.empty() && all_.back() == TalkMoment{step, event}) return;
  all_.push_back({step, event});
  steps_.push_back(step);
}

Moments::Range Moments::at(Step step) const {
  const auto [begin, end] = std::equal_range(steps_.begin(), steps_.end(), step);
  return {static_cast<std::size_t>(begin - steps_.begin()), static_cast<std::size_t>(end - steps_.begin())};
}

void Moments::take_operation(std::uint32_t index, const Event& e) {
  const bool first_kind =
      first_of(kinds_, static_cast<int>(e.stage) * event_kind_count + static_cast<int>(e.kind));
  const bool first_condition = e.condition != Condition::none && first_of(conditions_, e.condition);
  // What violates a condition is seen before it is mended: the tetrahedron that goes, say.
  if (first_condition && e.condition != Condition::classification) add(e.step, index);
  const bool at_last = rejected_ >= patience && first_of(at_last_, e.stage);
  rejected_ = 0;
  const bool early = e.kind == EventKind::insertion && inserted_++ < first_insertions;
  if (first_kind || first_condition || at_last || early) add(e.step + 1, index);
}

void Moments::take(std::uint32_t index, const Event& e) {
  if (e.operation) return take_operation(index, e);
  switch (e.kind) {
  case EventKind::stage_begin:
    rejected_ = 0;
    add(e.step, index);
    break;
  case EventKind::stage_end:
  case EventKind::warning:
  case EventKind::stopped:
    add(e.step, index);
    break;
  case EventKind::topology_check:
    if (checked_ && (e.value != euler_ || e.count != components_)) add(e.step, index);
    checked_ = true;
    euler_ = e.value;
    components_ = e.count;
    break;
  case EventKind::rejection:
    ++rejected_;
    if (first_of(reasons_, e.reason)) add(e.step, index);
    break;
  default:
    break;
  }
}

void Moments::update(std::size_t budget) {
  if (!journal_) return;
  const std::size_t end = std::min(journal_->events().size(), taken_ + budget);
  for (; taken_ < end; ++taken_) take(static_cast<std::uint32_t>(taken_), journal_->events()[taken_]);
}

} // namespace isoscope
