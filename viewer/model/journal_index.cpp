// Taking in a journal.
#include "model/journal_index.h"

#include <algorithm>

namespace isoscope {

void JournalIndex::reset(std::shared_ptr<const Journal> journal) {
  *this = {};
  journal_ = std::move(journal);
  for (auto& sum : sums_) sum.assign(1, 0);
}

bool JournalIndex::update(std::size_t budget) {
  if (!journal_) return false;
  const std::size_t event_end = std::min(journal_->events().size(), events_ + budget);
  const std::size_t step_end =
      std::min<std::size_t>(journal_->operations().size(), conditions_.size() + budget);
  bool any = false;
  for (; events_ < event_end; ++events_) {
    const Event& event = journal_->events()[events_];
    any = true;
    if (event.kind == EventKind::stage_begin) stages_.push_back({event.stage, event.step, event.step, true});
    if (event.kind == EventKind::stage_end && !stages_.empty()) {
      stages_.back().end = event.step;
      stages_.back().open = false;
    }
    if (event.kind == EventKind::rejection)
      rejections_[static_cast<std::size_t>(event.reason)].push_back(event.step);
    if (event.kind == EventKind::parameter_change || event.kind == EventKind::warning ||
        event.kind == EventKind::topology_check || event.kind == EventKind::stopped)
      marks_.push_back({event.step, static_cast<std::uint32_t>(events_), event.kind});
  }
  for (std::size_t k = conditions_.size(); k < step_end; ++k) {
    const Operation& operation = journal_->operations()[k];
    const Event& event = journal_->events()[operation.event];
    any = true;
    if (event.vertex.valid()) births_.try_emplace(event.vertex.value, static_cast<Step>(k));
    conditions_.push_back(static_cast<std::uint8_t>(event.condition));
    const float spent = operation.figures.seconds;
    auto& seconds = figures_[static_cast<std::size_t>(Figure::seconds)];
    // Seconds are those of a stage; where they begin anew another one has begun.
    if (!seconds.empty() &&
        (event.stage != stage(static_cast<Step>(k - 1)) || seconds_before_ + spent < seconds.back()))
      seconds_before_ = seconds.back();
    seconds.push_back(seconds_before_ + spent);
    stage_of_.push_back(static_cast<std::uint8_t>(event.stage));
    kind_of_.push_back(static_cast<std::uint8_t>(event.kind));
    operations_[static_cast<std::size_t>(event.kind)].push_back(static_cast<Step>(k));
    for (std::size_t c = 0; c < sums_.size(); ++c)
      sums_[c].push_back(sums_[c].back() + (c == static_cast<std::size_t>(event.condition) ? 1u : 0u));
    const StepFigures& f = operation.figures;
    figures_[0].push_back(static_cast<float>(f.bad_samples));
    figures_[1].push_back(f.largest_error);
    figures_[2].push_back(static_cast<float>(f.zero_set_vertices));
    figures_[3].push_back(f.smallest_height);
    figures_[4].push_back(static_cast<float>(f.tets));
  }
  if (!stages_.empty() && stages_.back().open) stages_.back().end = std::max(stages_.back().end, steps());
  return any;
}

bool JournalIndex::complete() const {
  return !journal_ ||
         (events_ == journal_->events().size() && conditions_.size() == journal_->operations().size());
}

std::array<std::uint32_t, condition_count> JournalIndex::counts(Step begin, Step end) const {
  std::array<std::uint32_t, condition_count> n{};
  end = std::min(end, steps());
  begin = std::min(begin, end);
  for (std::size_t c = 0; c < sums_.size(); ++c)
    n[c] = sums_[c].empty() ? 0 : sums_[c][end] - sums_[c][begin];
  return n;
}

namespace {

std::uint32_t count_within(const std::vector<Step>& ascending, Step begin, Step end) {
  const auto first = std::lower_bound(ascending.begin(), ascending.end(), begin);
  return static_cast<std::uint32_t>(std::lower_bound(first, ascending.end(), end) - first);
}

} // namespace

std::uint32_t JournalIndex::count(EventKind kind, Step begin, Step end) const {
  return count_within(operations_[static_cast<std::size_t>(kind)], begin, end);
}

std::uint32_t JournalIndex::rejections(Reason reason, Step begin, Step end) const {
  return count_within(rejections_[static_cast<std::size_t>(reason)], begin, end);
}

std::optional<Step> JournalIndex::begin_of(Stage stage) const {
  for (const StageSpan& span : stages_)
    if (span.stage == stage) return span.begin;
  return std::nullopt;
}

std::optional<Step> JournalIndex::birth_of(VertexId vertex) const {
  const auto found = births_.find(vertex.value);
  return found == births_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Step> JournalIndex::next_change(Step from) const {
  const Step end = steps();
  if (from >= end) return std::nullopt;
  // The operation that led here is from - 1; at the start the first one counts as the present.
  const Step present = from == 0 ? 0 : from - 1;
  for (Step k = present + 1; k < end; ++k)
    if (conditions_[k] != conditions_[present] || stage_of_[k] != stage_of_[present]) return k + 1;
  return std::nullopt;
}

std::size_t JournalIndex::first_event_at(Step step) const {
  std::size_t low = 0, high = events_;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (journal_->events()[middle].step < step)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

} // namespace isoscope
