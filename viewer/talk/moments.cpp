// Finding the moments in a growing journal.
#include "talk/moments.h"

#include <algorithm>

namespace isoscope {

void Moments::reset(std::shared_ptr<const Journal> journal) {
  *this = Moments();
  journal_ = std::move(journal);
}

void Moments::add(Step step) {
  if (steps_.empty() || steps_.back() < step) steps_.push_back(step);
}

void Moments::update(std::size_t budget) {
  if (!journal_) return;
  const std::size_t end = std::min(journal_->events().size(), taken_ + budget);
  for (; taken_ < end; ++taken_) {
    const Event& e = journal_->events()[taken_];
    switch (e.kind) {
    case EventKind::stage_begin:
    case EventKind::warning:
    case EventKind::stopped:
      add(e.step);
      break;
    case EventKind::topology_check:
      if (checked_ && (e.value != euler_ || e.count != components_)) add(e.step);
      checked_ = true;
      euler_ = e.value;
      components_ = e.count;
      break;
    case EventKind::rejection:
      ++rejected_;
      break;
    case EventKind::collapse:
    case EventKind::repair:
      if (rejected_ >= patience) add(e.step + 1);
      rejected_ = 0;
      break;
    default:
      break;
    }
  }
}

} // namespace isoscope
