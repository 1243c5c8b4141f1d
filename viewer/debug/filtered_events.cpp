// Gathering events.
#include "debug/filtered_events.h"

#include <algorithm>

namespace isoscope {

bool FilteredEvents::update(const std::shared_ptr<const Journal>& journal, const EventQuery& query,
                            std::size_t budget) {
  constexpr std::size_t follow_cost = 40; ///< how much dearer an event is where the journal is followed
  bool changed = false;
  if (journal != journal_ || !(query == query_)) {
    journal_ = journal;
    query_ = query;
    watch_.reset();
    scanned_ = 0;
    changed = !rows_.empty();
    rows_.clear();
    steps_.clear();
  }
  if (!journal_) return changed;
  const Expression* expression = query_.expression.get();
  const bool follows = expression != nullptr && expression->needs().any();
  if (follows && !watch_) watch_ = std::make_unique<JournalWatch>(journal_, expression->needs());
  if (follows) budget /= follow_cost;
  const auto end =
      static_cast<std::uint32_t>(std::min<std::size_t>(complete_events(*journal_), scanned_ + budget));
  const auto loop = query_.loops != nullptr ? query_.chosen.loop : std::nullopt;
  const auto known = loop ? std::min(end, query_.loops->scanned()) : end;
  for (; scanned_ < known; ++scanned_) {
    if (follows) watch_->go_to(scanned_);
    const Event& event = journal_->events()[scanned_];
    if (query_.range && !query_.range->holds(event.step)) continue;
    if (!query_.chosen.passes(event) || (loop && !query_.loops->touches(*loop, scanned_))) continue;
    if (expression != nullptr && !holds(*expression, *journal_, scanned_, watch_.get())) continue;
    rows_.push_back(scanned_);
    steps_.push_back(event.step);
    changed = true;
  }
  return changed;
}

bool FilteredEvents::complete() const {
  return !journal_ || scanned_ >= complete_events(*journal_);
}

std::uint32_t FilteredEvents::count(Step begin, Step end) const {
  return static_cast<std::uint32_t>(std::lower_bound(steps_.begin(), steps_.end(), end) -
                                    std::lower_bound(steps_.begin(), steps_.end(), begin));
}

} // namespace isoscope
