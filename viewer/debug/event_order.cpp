// Keys are read once a row; what has come in since is merged into what was in order.
#include "debug/event_order.h"

#include "journal/describe.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace isoscope {
namespace {

std::uint32_t element_of(const Event& e) {
  if (e.vertex.valid() && e.other.valid()) return e.vertex.value;
  if (e.sample.valid()) return e.sample.value;
  return e.tet.value;
}

double key_of(const EventNumbers& n, EventColumn column) {
  switch (column) {
  case EventColumn::value:
    return n.value.value_or(std::numeric_limits<double>::quiet_NaN());
  case EventColumn::limit:
    return n.limit.value_or(std::numeric_limits<double>::quiet_NaN());
  case EventColumn::milliseconds:
    return n.milliseconds.value_or(std::numeric_limits<double>::quiet_NaN());
  case EventColumn::element:
    return n.element == 0xffffffffu ? std::numeric_limits<double>::quiet_NaN()
                                    : static_cast<double>(n.element);
  case EventColumn::step:
    break;
  }
  return 0;
}

} // namespace

EventNumbers event_numbers(const Journal& journal, const JournalIndex& index, std::uint32_t event) {
  const Event& e = journal.events()[event];
  EventNumbers n;
  n.element = element_of(e);
  if (e.value != 0 || e.limit != 0) {
    const bool length = is_length(measure_of(e));
    const double unit = length ? journal.parameters_at(e.step).unit() : 1;
    n.value = e.value / unit;
    if (e.limit != 0) n.limit = e.limit / unit;
    if (length) n.unit = "δ";
  }
  const auto& seconds = index.values(Figure::seconds);
  if (e.operation && e.step < seconds.size()) {
    const double before = e.step > 0 ? static_cast<double>(seconds[e.step - 1]) : 0;
    n.milliseconds = 1e3 * std::max(static_cast<double>(seconds[e.step]) - before, 0.0);
  }
  return n;
}

const std::vector<std::uint32_t>& EventOrder::of(const FilteredEvents& listed, const JournalIndex& index,
                                                 EventSort sort) {
  const auto& rows = listed.rows();
  if (sort == EventSort() || rows.size() > most || !listed.journal()) {
    journal_.reset(); // it may be the last to keep it
    settled_.clear();
    return rows;
  }
  const bool same = journal_ == listed.journal() && query_ == listed.query() && sort_ == sort &&
                    taken_ <= rows.size() && indexed_ <= index.steps();
  if (same && taken_ == rows.size() && indexed_ == index.steps()) return rows_;
  if (!same) settled_.clear();
  journal_ = listed.journal();
  query_ = listed.query();
  sort_ = sort;
  taken_ = rows.size();
  indexed_ = index.steps();
  if (sort.column == EventColumn::step) {
    rows_.assign(rows.rbegin(), rows.rend());
    return rows_;
  }
  const auto before = [&](const Keyed& a, const Keyed& b) {
    const bool has_a = !std::isnan(a.key), has_b = !std::isnan(b.key);
    if (has_a != has_b) return has_a;
    if (!has_a) return false;
    return sort.descending ? a.key > b.key : a.key < b.key;
  };
  const auto sorted = [&](std::size_t from, std::size_t end) {
    std::vector<Keyed> some;
    some.reserve(end - from);
    for (std::size_t i = from; i < end; ++i)
      some.push_back({key_of(event_numbers(*journal_, index, rows[i]), sort.column), rows[i]});
    std::stable_sort(some.begin(), some.end(), before);
    return some;
  };
  // Further rows are merged into those whose keys stay; times are there once the index has the step.
  const std::size_t from = settled_.size();
  std::size_t end = from;
  while (end < rows.size() &&
         (sort.column != EventColumn::milliseconds || journal_->events()[rows[end]].step < index.steps()))
    ++end;
  const std::vector<Keyed> fresh = sorted(from, end), waiting = sorted(end, rows.size());
  settled_.insert(settled_.end(), fresh.begin(), fresh.end());
  std::inplace_merge(settled_.begin(), settled_.begin() + static_cast<std::ptrdiff_t>(from), settled_.end(),
                     before);
  std::vector<Keyed> all;
  all.reserve(rows.size());
  std::merge(settled_.begin(), settled_.end(), waiting.begin(), waiting.end(), std::back_inserter(all),
             before);
  rows_.clear();
  for (const Keyed& k : all) rows_.push_back(k.row);
  return rows_;
}

} // namespace isoscope
