// Keys are read once a row.
#include "debug/event_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isoscope {
namespace {

/// Whether an event measured a length.
bool is_length(const Event& e) {
  switch (e.kind) {
  case EventKind::repair:
  case EventKind::relaxation:
  case EventKind::shake:
    return true;
  case EventKind::rejection:
    switch (e.reason) {
    case Reason::outside_tolerance:
    case Reason::unproven:
    case Reason::stays_above:
    case Reason::kernel_empty:
    case Reason::border_distance:
      return true;
    default:
      return false;
    }
  default:
    return e.condition == Condition::height || e.condition == Condition::containment;
  }
}

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
    const double unit = is_length(e) ? journal.parameters_at(e.step).unit() : 1;
    n.value = e.value / unit;
    if (e.limit != 0) n.limit = e.limit / unit;
    if (is_length(e)) n.unit = "δ";
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
    return rows;
  }
  if (journal_ == listed.journal() && query_ == listed.query() && sort_ == sort && taken_ == rows.size() &&
      indexed_ == index.steps())
    return rows_;
  journal_ = listed.journal();
  query_ = listed.query();
  sort_ = sort;
  taken_ = rows.size();
  indexed_ = index.steps();
  if (sort.column == EventColumn::step) {
    rows_.assign(rows.rbegin(), rows.rend());
    return rows_;
  }
  std::vector<std::pair<double, std::uint32_t>> keyed;
  keyed.reserve(rows.size());
  for (const std::uint32_t row : rows)
    keyed.emplace_back(key_of(event_numbers(*journal_, index, row), sort.column), row);
  std::stable_sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    const bool has_a = !std::isnan(a.first), has_b = !std::isnan(b.first);
    if (has_a != has_b) return has_a;
    if (!has_a) return false;
    return sort.descending ? a.first > b.first : a.first < b.first;
  });
  rows_.clear();
  for (const auto& [key, row] : keyed) rows_.push_back(row);
  return rows_;
}

} // namespace isoscope
