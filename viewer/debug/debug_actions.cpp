// Breakpoints, filters and ranges of the window.
#include "debug/debug_actions.h"

#include "command/named_values.h"
#include "debug/suggested_breaks.h"
#include "command/usage.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

std::string joined(const Arguments& a) {
  std::string text;
  for (const std::string& word : a) text += (text.empty() ? "" : " ") + word;
  return text;
}

Error wrong(const QueryError& error, const std::string& text) {
  return {ErrorCode::usage, error.picture(text), ""};
}

/// Goes to where the run paused, once a pause, and says why.
bool tell_pause(AppModel& m) {
  Debugger& d = m.debug;
  if (m.run.phase != SessionPhase::paused || m.run.pause_note.empty() || !m.run.journal) return false;
  const std::size_t events = m.run.journal->events().size();
  if (d.held_generation == m.run.generation && d.held_events == events) return false;
  d.held_generation = m.run.generation;
  d.held_events = events;
  const auto hit = d.breakpoints->last_hit();
  if (hit && hit->note() == m.run.pause_note && hit->event < events) {
    show_event(m, hit->event);
    m.tell("Stopped at " + hit->note() + ".");
    return true;
  }
  if (m.run.pause_note == stepping_note && events > 0) {
    show_event(m, static_cast<std::uint32_t>(events - 1));
    return true;
  }
  return false;
}

bool take_answer(AppModel& m) {
  const auto answer = m.debug.worker.answered();
  if (!answer || answer->question.number == m.debug.told) return false;
  m.debug.told = answer->question.number;
  if (answer->question.number != m.debug.searches || answer->question.journal != m.run.journal) return false;
  const bool forward = answer->question.search.direction == Direction::forward;
  if (answer->answer) {
    show_event(m, answer->answer->event);
    m.tell("Event " + std::to_string(answer->answer->event) + " matches " +
           answer->question.search.expressions[answer->answer->expression]->text() + ".");
  } else if (!forward || !answer->question.goes_on) {
    m.tell(forward ? "No later event matches." : "No earlier event matches.");
  } else if (m.run.phase == SessionPhase::paused) {
    m.session.resume();
    m.transport.follow();
  } else if (m.running()) {
    m.transport.follow();
  } else {
    m.tell("No later event matches a breakpoint.");
  }
  return true;
}

void gather(AppModel& m) {
  Debugger& d = m.debug;
  d.listed.update(m.run.journal, {d.filter, m.filter, d.range});
  d.lanes.resize(m.settings.filters.size());
  for (std::size_t i = 0; i < d.lanes.size(); ++i) {
    EventQuery query = d.lanes[i].query();
    if (!query.expression || query.expression->text() != m.settings.filters[i]) {
      ParsedQuery parsed = parse_query(m.settings.filters[i]);
      const auto* expression = std::get_if<std::shared_ptr<const Expression>>(&parsed);
      if (expression == nullptr) continue; // a settings file that somebody has edited
      query.expression = *expression;
    }
    d.lanes[i].update(m.run.journal, query);
  }
}

/// Gates belong to one event: where another is shown, one steps over operations again.
void leave_gates(AppModel& m) {
  Debugger& d = m.debug;
  if (d.level != DebugLevel::gate) return;
  if (current_event(m) != static_cast<std::ptrdiff_t>(d.gate_event.value_or(0))) {
    d.level = DebugLevel::operation;
    return;
  }
  const auto gates = gates_of(m);
  if (d.gate < gates.size()) m.selection.mark = gates[d.gate].witness;
}

} // namespace

bool update_debugger(AppModel& m) {
  Debugger& d = m.debug;
  const bool wanted = d.breakpoints->any_enabled();
  if (wanted != d.armed) {
    d.armed = wanted;
    m.session.set_breakpoint(!wanted ? Breakpoint()
                                     : [set = d.breakpoints](const Journal& journal, const Event&) {
                                         const auto hit = set->ask(journal);
                                         return hit ? hit->note() : std::string();
                                       });
  }
  bool changed = tell_pause(m);
  changed |= take_answer(m);
  gather(m);
  leave_gates(m);
  return changed || !debugger_is_current(m);
}

bool debugger_is_current(const AppModel& m) {
  const Debugger& d = m.debug;
  const auto answer = d.worker.answered();
  const bool waits = answer && answer->question.number != d.told;
  return d.worker.idle() && !waits && (m.running() || d.listed.complete());
}

std::ptrdiff_t current_event(const AppModel& m) {
  if (!m.run.journal) return -1;
  const Journal& journal = *m.run.journal;
  const Step step = m.transport.step();
  if (m.selection.event && *m.selection.event < journal.events().size()) {
    const Event& e = journal.events()[*m.selection.event];
    if (step_showing(e) == step) return *m.selection.event;
  }
  return step > 0 && step <= journal.steps()
             ? static_cast<std::ptrdiff_t>(journal.operations()[step - 1].event)
             : -1;
}

void search_events(AppModel& m, std::vector<std::shared_ptr<const Expression>> expressions,
                   Direction direction, bool goes_on) {
  QueryRequest request;
  request.number = ++m.debug.searches;
  request.journal = m.run.journal;
  request.goes_on = goes_on;
  request.search.expressions = std::move(expressions);
  request.search.from = current_event(m);
  request.search.direction = direction;
  if (const auto scene = m.run.scene) request.search.expected = [scene] { return expected_genus(*scene); };
  m.transport.jump(m.transport.step());
  m.debug.worker.ask(std::move(request));
}

namespace actions {

Status add_breakpoint(AppModel& m, const Arguments& a) {
  const std::string text = joined(a);
  const auto added = m.debug.breakpoints->add(text);
  if (const auto* error = std::get_if<QueryError>(&added)) return wrong(*error, text);
  return {};
}

Status toggle_break_here(AppModel& m, const Arguments& a) {
  std::string text = joined(a);
  if (text.empty())
    if (const auto suggested = suggested_breaks(m); !suggested.empty()) text = suggested.front().condition;
  if (text.empty())
    return Error{ErrorCode::usage, "Nothing is selected to break on.",
                 "Select an edge, a vertex, a tetrahedron or a sample."};
  for (const BreakpointState& b : m.debug.breakpoints->list())
    if (b.text == text) {
      m.debug.breakpoints->remove(b.id);
      m.tell("No breakpoint any more: " + text);
      return {};
    }
  const Status added = add_breakpoint(m, {text});
  if (added) m.tell("Breakpoint: " + text + ". F5 goes on to it, Shift+F5 back.");
  return added;
}

Status change_breakpoint(AppModel& m, const Arguments& a) {
  const auto id = a.size() >= 2 ? parse_number(a[0]) : Result<double>(-1.0);
  if (!id || *id < 1 || *id != std::floor(*id)) return usage("breakpoint", "Which breakpoint?");
  const auto number = static_cast<unsigned>(*id);
  bool found = false;
  if (a[1] == "remove" && a.size() == 2) {
    found = m.debug.breakpoints->remove(number);
  } else if ((a[1] == "on" || a[1] == "off") && a.size() == 2) {
    found = m.debug.breakpoints->enable(number, a[1] == "on");
  } else if (a[1] == "ignore" && a.size() == 3) {
    const auto hits = parse_number(a[2]);
    if (!hits || *hits < 0 || *hits > 1e9) return usage("breakpoint", "How many hits?");
    found = m.debug.breakpoints->ignore(number, static_cast<std::size_t>(*hits));
  } else {
    return usage("breakpoint", "Nothing of a breakpoint is called \"" + a[1] + "\".");
  }
  if (!found) return usage("breakpoint", "There is no breakpoint " + a[0] + ".");
  return {};
}

Status continue_run(AppModel& m, Direction direction) {
  auto expressions = m.debug.breakpoints->enabled();
  if (expressions.empty() && direction == Direction::backward)
    return Error{ErrorCode::usage, "No breakpoint is enabled.", "F9 breaks on what is selected."};
  search_events(m, std::move(expressions), direction, true);
  return {};
}

Status save_filter(AppModel& m, const Arguments& a) {
  constexpr std::size_t most = 8;
  const std::string text = a.empty() ? m.debug.filter_text : joined(a);
  if (text.empty()) return usage("save-filter", "There is no filter.");
  const ParsedQuery parsed = parse_query(text);
  if (const auto* error = std::get_if<QueryError>(&parsed)) return wrong(*error, text);
  auto& filters = m.settings.filters;
  if (std::find(filters.begin(), filters.end(), text) != filters.end()) return {};
  if (filters.size() == most)
    return Error{ErrorCode::usage, "There are eight saved filters already.", "Forget one of them."};
  filters.push_back(text);
  return {};
}

Status forget_filter(AppModel& m, const Arguments& a) {
  const auto number = a.size() == 1 ? parse_number(a[0]) : Result<double>(-1.0);
  auto& filters = m.settings.filters;
  if (!number || *number < 1 || *number > static_cast<double>(filters.size()))
    return usage("forget-filter", "There is no such saved filter.");
  const auto at = static_cast<std::ptrdiff_t>(*number) - 1;
  filters.erase(filters.begin() + at);
  if (static_cast<std::size_t>(at) < m.debug.lanes.size()) m.debug.lanes.erase(m.debug.lanes.begin() + at);
  return {};
}

Status choose_range(AppModel& m, const Arguments& a) {
  if (a.empty()) {
    m.debug.range.reset();
    return {};
  }
  const auto begin = parse_number(a[0]);
  const auto end = a.size() == 2 ? parse_number(a[1]) : Result<double>(-1.0);
  if (!begin || !end || *begin < 0 || *end < *begin || *begin > static_cast<double>(m.live_step()))
    return usage("range", "A range has a first and a last step.");
  m.debug.range = StepSpan{static_cast<Step>(*begin),
                           static_cast<Step>(std::min(*end, static_cast<double>(m.live_step())))};
  return {};
}

} // namespace actions
} // namespace isoscope
