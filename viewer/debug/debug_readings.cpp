// What scripts can expect of the debugger.
#include "debug/debug_actions.h"
#include "command/named_table.h"
#include "debug/suggested_breaks.h"

namespace isoscope {

void add_debug_readings(NamedTable& t) {
  const auto add = [&](std::string name, std::string help, std::function<std::string(const AppModel&)> get) {
    t.push_back({std::move(name), std::move(help), std::move(get), nullptr});
  };
  const auto gate = [](const AppModel& m) -> std::optional<GateView> {
    const auto gates = gates_of(m);
    if (m.debug.level != DebugLevel::gate || m.debug.gate >= gates.size()) return std::nullopt;
    return gates[m.debug.gate];
  };
  add("breakpoints", "how many there are",
      [](const AppModel& m) { return std::to_string(m.debug.breakpoints->list().size()); });
  add("breaks.suggested", "conditions that the inspector offers to stop at",
      [](const AppModel& m) { return std::to_string(suggested_breaks(m).size()); });
  add("breakpoints.hits", "of all of them in this run", [](const AppModel& m) {
    std::size_t hits = 0;
    for (const BreakpointState& b : m.debug.breakpoints->list()) hits += b.hits;
    return std::to_string(hits);
  });
  add("hit.event", "the event of the last hit", [](const AppModel& m) {
    const auto hit = m.debug.breakpoints->last_hit();
    return hit ? std::to_string(hit->event) : std::string("none");
  });
  add("hit.id", "the breakpoint of the last hit", [](const AppModel& m) {
    const auto hit = m.debug.breakpoints->last_hit();
    return hit ? std::to_string(hit->id) : std::string("none");
  });
  add("event.here", "the event at which one stands",
      [](const AppModel& m) { return std::to_string(current_event(m)); });
  add("events.listed", "events that the list shows",
      [](const AppModel& m) { return std::to_string(m.debug.listed.rows().size()); });
  add("filters", "saved filters",
      [](const AppModel& m) { return std::to_string(m.settings.filters.size()); });
  add("lane.events", "events of the saved filters together", [](const AppModel& m) {
    std::size_t events = 0;
    for (const FilteredEvents& lane : m.debug.lanes) events += lane.rows().size();
    return std::to_string(events);
  });
  add("depth", "how deep one steps: 0 stages, 1 operations, 2 gates",
      [](const AppModel& m) { return std::to_string(static_cast<int>(m.debug.level)); });
  add("gates", "of the event at which one stands",
      [](const AppModel& m) { return std::to_string(gates_of(m).size()); });
  add("gate.number", "the number of the gate shown, from 1; 0 none",
      [gate](const AppModel& m) { return gate(m) ? std::to_string(m.debug.gate + 1) : std::string("0"); });
  add("gate.failed", "whether the gate shown failed", [gate](const AppModel& m) {
    const auto shown = gate(m);
    return std::string(!shown ? "none" : shown->failed ? "on" : "off");
  });
  add("range.begin", "the first step of the chosen range", [](const AppModel& m) {
    return m.debug.range ? std::to_string(m.debug.range->begin) : std::string("none");
  });
  add("range.end", "its last step", [](const AppModel& m) {
    return m.debug.range ? std::to_string(m.debug.range->end) : std::string("none");
  });
}

} // namespace isoscope
