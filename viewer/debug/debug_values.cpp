// What scripts can expect of the debugger.
#include "debug/debugger.h"
#include "debug/suggested_breaks.h"

namespace isoscope {

void Debugger::add_values(NamedValues& t) {
  const auto gate = [this]() -> std::optional<GateView> {
    const auto all = gates();
    if (window.place.level != DebugLevel::gate || window.place.gate >= all.size()) return std::nullopt;
    return all[window.place.gate];
  };
  t.add("breakpoints", "how many there are", [this] { return std::to_string(breakpoints->list().size()); });
  t.add("breaks.suggested", "conditions that the inspector offers to stop at",
        [this] { return std::to_string(suggested_breaks(*this).size()); });
  t.add("breakpoints.hits", "of all of them in this run", [this] {
    std::size_t hits = 0;
    for (const BreakpointState& b : breakpoints->list()) hits += b.hits;
    return std::to_string(hits);
  });
  t.add("hit.event", "the event of the last hit", [this] {
    const auto hit = breakpoints->last_hit();
    return hit ? std::to_string(hit->event) : std::string("none");
  });
  t.add("hit.id", "the breakpoint of the last hit", [this] {
    const auto hit = breakpoints->last_hit();
    return hit ? std::to_string(hit->id) : std::string("none");
  });
  t.add("event.here", "the event at which one stands", [this] { return std::to_string(current_event()); });
  t.add("events.listed", "events that the list shows",
        [this] { return std::to_string(listed.rows().size()); });
  t.add("filters", "saved filters", [this] { return std::to_string(window.settings.filters.size()); });
  t.add("lane.events", "events of the saved filters together", [this] {
    std::size_t events = 0;
    for (const FilteredEvents& lane : lanes) events += lane.rows().size();
    return std::to_string(events);
  });
  t.add("depth", "how deep one steps: 0 stages, 1 operations, 2 gates",
        [this] { return std::to_string(static_cast<int>(window.place.level)); });
  t.add("gates", "of the event at which one stands", [this] { return std::to_string(gates().size()); });
  t.add("gate.number", "the number of the gate shown, from 1; 0 none",
        [gate, this] { return gate() ? std::to_string(window.place.gate + 1) : std::string("0"); });
  t.add("gate.failed", "whether the gate shown failed", [gate, this] {
    const auto shown = gate();
    return std::string(!shown ? "none" : shown->failed ? "on" : "off");
  });
  t.add("range.begin", "the first step of the chosen range",
        [this] { return window.range ? std::to_string(window.range->begin) : std::string("none"); });
  t.add("range.end", "its last step",
        [this] { return window.range ? std::to_string(window.range->end) : std::string("none"); });
}

} // namespace isoscope
