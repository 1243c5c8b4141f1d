// Following a journal.
#include "query/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isoscope {

JournalWatch::JournalWatch(const Journal& journal, QueryNeeds needs, ExpectedGenus expected)
    : journal_(&journal), needs_(std::move(needs)),
      follows_state_(needs_.topology || needs_.positions || !needs_.samples.empty()) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  told_genus_ = expected ? expected().value_or(unknown) : unknown;
  restart();
}

JournalWatch::JournalWatch(std::shared_ptr<const Journal> journal, QueryNeeds needs, ExpectedGenus expected)
    : JournalWatch(*journal, std::move(needs), std::move(expected)) {
  owned_ = std::move(journal);
}

void JournalWatch::restart() {
  expected_genus_ = told_genus_;
  next_ = 0;
  complex_ = {};
  sample_set_.reset();
  topology_ = {};
  topology_known_ = false;
  rejected_ = stalled_ = 0;
  edge_.reset();
  watched_.clear();
  for (const SampleId s : needs_.samples) watched_.push_back({s});
  sets_.reset();
}

void JournalWatch::go_to(std::uint32_t event) {
  if (event + 1 < next_) restart();
  while (next_ <= event) take(next_++);
}

void JournalWatch::take(std::uint32_t index) {
  const Event& event = journal_->events()[index];
  if (event.kind == EventKind::topology_check && std::isnan(told_genus_))
    expected_genus_ = static_cast<double>(event.count) - event.limit / 2;
  if (needs_.stall) {
    const bool attempt = event.kind == EventKind::rejection || event.kind == EventKind::exhausted;
    if (event.operation) rejected_ = 0;
    if (attempt) ++rejected_;
    stalled_ = attempt ? rejected_ : 0;
  }
  if (!follows_state_) return;
  edge_.reset();
  const auto known = [&](VertexId v) { return v.valid() && v.index() < complex_.vertices.size(); };
  if (needs_.positions && known(event.vertex) && known(event.other))
    edge_ = {complex_.position(event.vertex), complex_.position(event.other)};
  for (Watched& w : watched_) w.before = w.now;
  if (event.operation) apply(journal_->operations()[event.step]);
  if (event.operation || event.kind == EventKind::parameter_change)
    for (std::size_t i = 0; i < watched_.size(); ++i) watched_[i].now = judge(i, step_showing(event));
}

void JournalWatch::apply(const Operation& operation) {
  const Delta delta = operation.delta();
  if (needs_.topology) topology_.before(complex_, delta);
  complex_.apply(delta);
  if (needs_.topology) {
    topology_.after(complex_, delta);
    topology_known_ = true;
  }
  if (watched_.empty()) return;
  if (sets_ && !delta.sample_set && !delta.form) {
    sets_->redistribute(complex_, delta.removed, delta.added);
  } else {
    const std::uint16_t set =
        delta.sample_set ? delta.sample_set->after : sample_set_.value_or(std::uint16_t{0});
    sample_set_ = set;
    place_samples();
  }
}

void JournalWatch::place_samples() {
  sets_.reset();
  positions_.assign(watched_.size(), Vec3{});
  labels_.assign(watched_.size(), std::int8_t{0});
  if (complex_.form == ZeroForm::free || *sample_set_ >= journal_->sample_sets().size()) return;
  const auto& samples = journal_->sample_sets()[*sample_set_];
  if (!samples || complex_.tets.empty()) return;
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    if (watched_[i].id.index() >= samples->size()) continue;
    positions_[i] = samples->positions[watched_[i].id.index()];
    labels_[i] = samples->labels[watched_[i].id.index()];
  }
  sets_ = std::make_unique<SampleSets>(positions_);
  sets_->assign_all(complex_);
}

SampleClass JournalWatch::judge(std::size_t i, Step step) const {
  if (!sets_ || labels_[i] == 0) return SampleClass::outside;
  const TetId t = sets_->tet_of(SampleId(i));
  if (!t.valid()) return SampleClass::outside;
  const double error = sample_error_at(complex_, t, positions_[i], labels_[i]);
  if (is_bad(error)) return SampleClass::bad;
  return error > journal_->parameters_at(step).error_limit() ? SampleClass::margin : SampleClass::good;
}

namespace {
template <class Range> auto of(const Range& watched, SampleId sample) {
  return std::find_if(watched.begin(), watched.end(), [&](const auto& w) { return w.id == sample; });
}
} // namespace

SampleClass JournalWatch::sample_class(SampleId sample) const {
  const auto found = of(watched_, sample);
  return found == watched_.end() ? SampleClass::outside : found->now;
}

bool JournalWatch::sample_changed(SampleId sample) const {
  const auto found = of(watched_, sample);
  return found != watched_.end() && found->now != found->before;
}

} // namespace isoscope
