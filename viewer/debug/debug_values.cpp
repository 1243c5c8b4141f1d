// What scripts can expect of the debugger.
#include "debug/debugger.h"
#include "debug/lane_events.h"

namespace isoscope {

void Debugger::add_values(NamedValues& t) {
  const auto gate = [this]() -> std::optional<GateView> {
    const auto all = gates();
    if (window.place.level != DebugLevel::gate || window.place.gate >= all.size()) return std::nullopt;
    return all[window.place.gate];
  };
  t.add("breakpoints", "how many there are", [this] { return breakpoints->list().size(); });
  t.add("breaks.suggested", "conditions that the inspector offers to stop at",
        [this] { return suggested_breaks(*this).size(); });
  t.add("breakpoints.hits", "of all of them in this run", [this] {
    std::size_t hits = 0;
    for (const BreakpointState& b : breakpoints->list()) hits += b.hits;
    return hits;
  });
  const auto of_hit = t.readings("hit.", [this] { return breakpoints->last_hit(); });
  of_hit("event", "the event of the last hit", [](const auto& hit) { return hit.event; });
  of_hit("id", "the breakpoint of the last hit", [](const auto& hit) { return hit.id; });
  t.add("event.here", "the event at which one stands", [this] { return current_event(); });
  t.add("events.listed", "events that the list shows", [this] { return listed.rows().size(); });
  t.add("events.first", "the event in the first row of the list",
        [this] { return listed_rows().empty() ? std::string("nan") : std::to_string(listed_rows()[0]); });
  t.add("events.sort", "the column that the list is sorted by, with - for the largest first", [this] {
    const EventSort s = window.event_sort;
    return (s.descending ? "-" : "") + std::string(event_column_names.at(static_cast<std::size_t>(s.column)));
  });
  t.add("lane", "the lane that the list shows alone", [this] {
    const std::string lane = shown_lane(*this);
    return lane.empty() ? std::string("none") : lane;
  });
  t.add("filters", "saved filters", [this] { return window.settings.filters.size(); });
  t.add("lane.events", "events of the saved filters together", [this] {
    std::size_t events = 0;
    for (const FilteredEvents& lane : lanes) events += lane.rows().size();
    return events;
  });
  t.add("loop.lanes", "lanes of loops of the open rim", [this] { return loops.lanes().size(); });
  t.add("loop.events", "events that work on each of them, together", [this] {
    std::size_t events = 0;
    for (const std::uint32_t loop : loops.lanes()) events += loops.events(loop).size();
    return events;
  });
  t.add("depth", "how deep one steps: 0 stages, 1 operations, 2 gates",
        [this] { return static_cast<int>(window.place.level); });
  t.add("gates", "of the event at which one stands", [this] { return gates().size(); });
  t.add("gate.number", "the number of the gate shown, from 1; 0 none",
        [gate, this] { return gate() ? window.place.gate + 1 : 0; });
  t.readings("gate.", gate)("failed", "whether the gate shown failed", &GateView::failed);
  const auto of_range = t.readings("range.", [this] { return window.range; });
  of_range("begin", "the first step of the chosen range", &StepSpan::begin);
  of_range("end", "its last step", &StepSpan::end);
}

} // namespace isoscope
