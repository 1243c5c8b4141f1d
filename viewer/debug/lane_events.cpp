// Filters by name; the journal is read outwards from the step.
#include "debug/lane_events.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::string_view filter_prefix = "filter-";

std::optional<std::size_t> saved_filter(const Debugger& d, std::string_view lane) {
  if (!lane.starts_with(filter_prefix)) return std::nullopt;
  const auto number = read_number(std::string(lane.substr(filter_prefix.size())));
  if (!number || *number < 1 || *number > static_cast<double>(d.window.settings.filters.size()))
    return std::nullopt;
  return static_cast<std::size_t>(*number) - 1;
}

template <std::size_t n> std::bitset<n> only(std::size_t bit) {
  return std::bitset<n>().set(bit);
}

} // namespace

std::optional<LaneFilter> lane_filter(const Debugger& d, std::string_view lane) {
  LaneFilter f;
  if (const auto saved = saved_filter(d, lane)) {
    f.condition = d.window.settings.filters[*saved];
    return f;
  }
  if (const auto loop = loop_of_lane(lane)) {
    if (!d.loops.has(*loop)) return std::nullopt;
    f.chosen.loop = loop;
    return f;
  }
  for (const ConditionWords& row : condition_table)
    if (row.value != Condition::none && row.name == lane) {
      f.chosen.conditions = only<condition_count>(static_cast<std::size_t>(row.value));
      f.chosen.kinds.reset();
      for (const EventKind kind : {EventKind::insertion, EventKind::relabel})
        f.chosen.kinds.set(static_cast<std::size_t>(kind));
      return f;
    }
  for (const KindWords& row : kind_table)
    if (row.name == lane) {
      f.chosen.kinds = only<event_kind_count>(static_cast<std::size_t>(row.value));
      return f;
    }
  for (const ReasonWords& row : reason_table)
    if (rejects(row.value) && row.name == lane) {
      f.chosen.kinds = only<event_kind_count>(static_cast<std::size_t>(EventKind::rejection));
      f.chosen.reasons = only<reason_count>(static_cast<std::size_t>(row.value));
      return f;
    }
  return std::nullopt;
}

bool shows_lane(const Debugger& d, std::string_view lane) {
  const auto f = lane_filter(d, lane);
  const ListFilter& now = d.window.filter;
  return f && now.chosen == f->chosen && now.condition == f->condition;
}

std::string shown_lane(const Debugger& d) {
  const ListFilter& now = d.window.filter;
  if (now.chosen.everything() && now.condition.empty()) return {};
  for (std::size_t i = 0; i < d.window.settings.filters.size(); ++i) {
    std::string name = std::string(filter_prefix) + std::to_string(i + 1);
    if (shows_lane(d, name)) return name;
  }
  if (now.chosen.loop && shows_lane(d, loop_lane_name(*now.chosen.loop)))
    return loop_lane_name(*now.chosen.loop);
  const auto among = [&](const auto& table) {
    for (const auto& row : table)
      if (shows_lane(d, row.name)) return std::string(row.name);
    return std::string();
  };
  for (const std::string& name : {among(condition_table), among(reason_table), among(kind_table)})
    if (!name.empty()) return name;
  return {};
}

std::optional<std::uint32_t> nearest_event(const Debugger& d, std::string_view lane, Step step, Step reach) {
  const auto f = lane_filter(d, lane);
  if (!f || !d.window.run.journal) return std::nullopt;
  const Journal& journal = *d.window.run.journal;
  const auto far = [&](Step at) { return at > step ? at - step : step - at; };
  std::optional<std::uint32_t> best;
  const auto take = [&](std::uint32_t event) {
    const Step at = journal.events()[event].step;
    if (far(at) > reach) return;
    if (!best || far(at) < far(journal.events()[*best].step)) best = event;
  };
  const auto saved = saved_filter(d, lane);
  if (saved && *saved >= d.lanes.size()) return std::nullopt;
  if (saved || f->chosen.loop) {
    const auto& rows = saved ? d.lanes[*saved].rows() : d.loops.events(*f->chosen.loop);
    const auto at = std::partition_point(
        rows.begin(), rows.end(), [&](std::uint32_t row) { return journal.events()[row].step < step; });
    if (at != rows.begin()) take(*std::prev(at));
    if (at != rows.end()) take(*at);
    return best;
  }
  const std::size_t end = complete_events(journal), middle = d.window.index.first_event_at(step);
  for (std::size_t i = middle; i > 0; --i) {
    const Event& e = journal.events()[i - 1];
    if (far(e.step) > reach) break;
    if (!f->chosen.passes(e)) continue;
    take(static_cast<std::uint32_t>(i - 1));
    break;
  }
  for (std::size_t i = middle; i < end; ++i) {
    const Event& e = journal.events()[i];
    if (far(e.step) > (best ? far(journal.events()[*best].step) : reach)) break;
    if (!f->chosen.passes(e)) continue;
    take(static_cast<std::uint32_t>(i));
    break;
  }
  return best;
}

} // namespace isoscope
